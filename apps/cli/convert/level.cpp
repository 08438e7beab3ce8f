// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "convert/heights_output.hpp"
#include "convert/output_jobs.hpp"
#include "convert/processing_text.hpp"
#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/pages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/processed_file.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/core/errors.hpp"
#include "setae/file_figures/level_figure.hpp"
#include "setae/output/field_json.hpp"
#include "setae/study/pipeline_file.hpp"

namespace setae::cli::level_command {
namespace {

struct Arguments {
    Common common;
    answers::FileRequest file;
    answers::ProcessingRequest processing;
    std::vector<std::string> paths;
    std::string output, folder, to = "x3p", written_pipeline, documentation;
    FigureOption figure;
};

/// Each file with its output file, which is empty if nothing is written.
std::vector<Job> jobs_of(const Arguments& arguments) {
    if (!arguments.output.empty() && !arguments.folder.empty())
        throw InvalidArgument("--output and --output-folder exclude each other");
    if (!arguments.folder.empty()) return jobs_into_folder(arguments.paths, arguments.folder, arguments.to);
    if (!arguments.output.empty()) {
        if (arguments.paths.size() != 1)
            throw InvalidArgument(
                fmt::format("{} files for the one output {}; write several to a folder with --output-folder",
                            arguments.paths.size(), arguments.output));
        if (!file_figures::is_figure_path(arguments.output))
            require_heights_ending(arguments.output, file_figures::figure_endings);
    }
    std::vector<Job> jobs;
    for (const auto& path : arguments.paths) jobs.push_back({path, arguments.output});
    return jobs;
}

/// Processes, writes and prints one file, and adds its alerts; returns the record of its processing.
answers::ProcessingRecord level_file(const Arguments& arguments, const processing::Pipeline& pipeline, const Job& job,
                                     std::vector<Alert>& alerts) {
    const auto processed = answers::processed_file(job.input, arguments.file.read_options(), arguments.file.channel,
                                                   pipeline, arguments.common.workers());
    const auto& [file, channel, before, result] = processed;
    if (file_figures::is_figure_path(job.output))
        file_figures::write_figure(file_figures::level_figure(before, result, arguments.figure.look()), job.output);
    else if (!job.output.empty()) write_heights(job.output, result.measurement);
    const auto add = [&alerts](const std::vector<Alert>& more) {
        alerts.insert(alerts.end(), more.begin(), more.end());
    };
    add(channel.alerts);
    add(topography::metadata(before).alerts);
    std::string lines =
        fmt::format("{} ({}){}\n", job.input, channel.name, job.output.empty() ? "" : " -> " + job.output);
    for (const auto& record : result.records) {
        lines += as_line(record);
        add(record.alerts);
    }
    if (!arguments.common.json) print(lines);
    return answers::record_of(processed, job.output);
}

ExitCode run(const Arguments& arguments) {
    if (!arguments.documentation.empty()) {
        write_page(arguments.documentation, step_page());
        return ExitCode::done;
    }
    auto pipeline = arguments.processing.pipeline();
    const bool writes = !arguments.output.empty() || !arguments.folder.empty();
    if (!arguments.processing.given() && writes) {
        pipeline.entries.push_back({processing::LevelPlane{}});
        print_message("no step given; level_plane subtracts the best plane; choose another step with --step NAME");
    }
    if (pipeline.entries.empty()) throw InvalidArgument("no step; expected --pipeline p.yml or --step level_plane");
    if (!arguments.written_pipeline.empty()) study::write_pipeline(arguments.written_pipeline, pipeline);
    if (arguments.paths.empty()) {
        if (!arguments.written_pipeline.empty()) return ExitCode::done;
        throw InvalidArgument("no file; expected at least one measurement");
    }
    const auto jobs = jobs_of(arguments);
    answers::ProcessingRecords records{.pipeline = study::step_lines(pipeline), .files = {}};
    std::vector<Alert> alerts;
    std::size_t index = 0;
    const auto code = for_each_item(arguments.paths, [&](const std::string&) {
        const auto current = index++;
        if (!jobs[current].output.empty()) require_own_output(jobs, current);
        records.files.push_back(level_file(arguments, pipeline, jobs[current], alerts));
    });
    show(alerts);
    if (arguments.common.json) print_json(output::described(records));
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("files", arguments->paths, "measurements").of_inputs();
    options.ask(arguments->processing);
    options.output(
        "-o,--output", arguments->output,
        "output file for one input, format by its ending; without steps the best plane is subtracted; .svg, .pdf or .png: figure of heights before and after");
    arguments->figure.add_to(options);
    options.output("--output-folder", arguments->folder, "output folder; files keep their names");
    options.output("--to", arguments->to, "ending of the files in the output folder; default: x3p");
    options.output("--write-pipeline", arguments->written_pipeline, "file p.yml or p.toml for the steps");
    options.add("--documentation", arguments->documentation, "file for the documentation page of all steps")
        .in(OptionGroup::advanced);
    options.ask(arguments->file, OptionGroup::height_files);
    options.example("setae level map.ibw -o levelled.x3p", "map minus its best plane");
    options.example("setae level map.ibw --step level_plane --step \"despike threshold=5\" -o levelled.svg",
                    "two steps, as a figure of heights before and after");
    options.example("setae level *.spm --pipeline p.yml --output-folder levelled",
                    "steps of a pipeline file for several maps");
    return action(options, arguments, step_list, run);
}

}  // namespace setae::cli::level_command
