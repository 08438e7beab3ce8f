// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "convert/heights_output.hpp"
#include "convert/output_jobs.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/converted_files.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/bytes/protected_inputs.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"

namespace setae::cli::convert_command {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    Common common;
    answers::FileRequest file;
    std::vector<std::string> paths;
    std::string folder, to;
    bool all_channels = false;

    [[nodiscard]] bool into_folder() const { return !folder.empty() || !to.empty(); }
};

/// One input with its output, or several inputs with outputs of the same names in a folder.
std::vector<Job> jobs_of(const Arguments& arguments) {
    if (arguments.all_channels && arguments.file.channel)
        throw InvalidArgument("--channel and --all-channels exclude each other");
    if (!arguments.into_folder()) {
        if (arguments.paths.size() != 2)
            throw InvalidArgument(
                fmt::format("expected an input file and OUT with an ending {}; several files need -o FOLDER --to x3p",
                            endings_of_heights()));
        require_heights_ending(arguments.paths[1]);
        bytes::protect_input(arguments.paths[0]);
        return {{arguments.paths[0], arguments.paths[1]}};
    }
    if (arguments.folder.empty() || arguments.to.empty() || arguments.paths.empty())
        throw InvalidArgument("expected FILE…, -o FOLDER and --to x3p together");
    return jobs_into_folder(arguments.paths, arguments.folder, arguments.to);
}

/// "a/out.x3p" is "a/out_3.x3p".
std::string numbered(const std::string& path, std::size_t channel) {
    const fs::path whole(path);
    return (whole.parent_path() / fmt::format("{}_{}{}", whole.stem().string(), channel, whole.extension().string()))
        .string();
}

/// Files written with which warnings, and whether a file failed.
struct Outcome {
    answers::ConvertedFiles converted;
    std::vector<Alert> alerts;
    bool failed = false;
};

void convert_file(const Arguments& arguments, const Job& job, Outcome& outcome) {
    const auto channels = formats::open(job.input, arguments.file.read_options());
    std::vector<std::string> numbers;
    for (const auto k : formats::chosen_channels(job.input, channels, arguments.file.channel, arguments.all_channels))
        numbers.push_back(fmt::format("{}", k));
    const auto code = for_each_item(numbers, [&](const std::string& number) {
        const auto k = static_cast<std::size_t>(std::stoul(number));
        const auto output = arguments.all_channels ? numbered(job.output, k) : job.output;
        const auto& channel = channels[k];
        const auto measurement = channel.read();
        write_heights(output, measurement);
        for (const auto& alerts : {channel.info.alerts, topography::metadata(measurement).alerts})
            outcome.alerts.insert(outcome.alerts.end(), alerts.begin(), alerts.end());
        outcome.converted.files.push_back({job.input, output, channel.info.name});
    });
    outcome.failed = outcome.failed || code != ExitCode::done;
}

ExitCode run(const Arguments& arguments) {
    const auto jobs = jobs_of(arguments);
    std::vector<std::string> inputs;
    for (const auto& job : jobs) inputs.push_back(job.input);
    Outcome outcome;
    std::size_t index = 0;
    const auto code = for_each_item(inputs, [&](const std::string&) {
        const auto current = index++;
        if (arguments.into_folder()) require_own_output(jobs, current);
        convert_file(arguments, jobs[current], outcome);
    });
    show(outcome.alerts);
    const auto& converted = outcome.converted;
    if (converted.files.empty()) return ExitCode::nothing_done;
    const bool one = !arguments.into_folder() && !arguments.all_channels;
    if (arguments.common.json)
        print_json(one ? output::described(converted.files.front()) : output::described(converted));
    return code != ExitCode::done || outcome.failed ? ExitCode::some_failed : ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("files", arguments->paths, "FILE OUT.x3p, or FILE… with -o and --to");
    options.output("-o,--output", arguments->folder,
                   "output folder; files keep their names and get the ending of --to");
    options.output("--to", arguments->to, "ending of the files in the output folder, such as x3p");
    options.flag("--all-channels", arguments->all_channels,
                 "all channels of heights, each to a file with the number of the channel before the ending");
    options.ask(arguments->file, OptionGroup::height_files);
    options.example("setae convert map.ibw map.x3p", "one file; the ending determines the format");
    options.example("setae convert *.spm -o x3p_files --to x3p", "several files, to a folder");
    options.example("setae convert heights.npy heights.gwy --size \"5 um x 5 um\" --unit m",
                    "array without size and unit");
    return action(options, arguments, heights_output_explanation, run);
}

}  // namespace setae::cli::convert_command
