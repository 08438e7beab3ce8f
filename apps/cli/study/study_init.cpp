// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/data_folder.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/draft_fields.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/output/field_json.hpp"
#include "setae/study/study_draft.hpp"

namespace setae::cli::study_init_command {
namespace {

constexpr const char* explanation =
    "The command writes a draft of a study from the files in folders.\n"
    "\n"
    "surfaces          The files of one folder are measurements of one surface.\n"
    "                  A folder named after an instrument belongs to the folder that contains it.\n"
    "instruments       from the files, else from a word of the name: stylus, afm, tem, confocal, ...\n"
    "                  A comment in the draft gives the source of each instrument.\n"
    "experiments       Loops and force curves are comments, because files do not contain elastomer and rough surface.\n"
    "missing metadata  Comments with \"?\" mark missing metadata.\n"
    "                  `setae study FILE --dry-run` lists these lines with their consequences.\n"
    "\n"
    "A study file with the name init is run by `setae study ./init`.\n";

struct Arguments {
    Common common;
    std::vector<std::string> paths;
    std::string output = "study.toml";
    bool force = false;
};

std::string counted(std::size_t n, const char* noun) { return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s"); }

void print_summary(const study::StudyDraft& draft, const std::string& file) {
    print(fmt::format("{}: {} with {}, {}, {}; {} left out\n", file, counted(draft.surfaces, "surface"),
                      counted(draft.measurements, "measurement"), counted(draft.loops, "loop"),
                      counted(draft.micrographs, "micrograph"), counted(draft.left_out.size(), "file")));
    if (!draft.own.empty())
        print(fmt::format("{} skipped: figures, tables and reports written by setae\n",
                          counted(draft.own.size(), "file")));
    print(fmt::format("setae study {} --dry-run lists missing metadata\n", shell_word(file)));
}

ExitCode run(const Arguments& arguments) {
    if (arguments.paths.empty()) throw InvalidArgument("no folder; expected at least one with measurements or loops");
    if (!arguments.force && std::filesystem::exists(arguments.output))
        throw InvalidArgument(fmt::format(
            "{}: file exists; give another file with -o, or replace this file with --force", arguments.output));
    const auto draft = study::draft_study(arguments.paths, arguments.output, mapping_folder());
    if (draft.surfaces + draft.loops + draft.micrographs == 0) {
        for (const auto& left : draft.left_out) print_message(left.reason);
        throw InvalidArgument("no measurement, loop, spectrum or micrograph found; nothing was written");
    }
    bytes::write_whole_file(arguments.output, draft.text);
    if (arguments.common.json) print_json(output::described(answers::DraftEntry{arguments.output, &draft}));
    else print_summary(draft, arguments.output);
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("folders", arguments->paths, "folders of measurements, micrographs and loops, or files").of_inputs();
    options
        .output("-o,--output", arguments->output,
                "study file to be written; paths in the file are relative to its folder")
        .default_shown();
    options.flag("--force", arguments->force, "replace an existing file");
    options.example("setae study init data -o study.toml", "draft of a study, with comments for missing metadata");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::study_init_command
