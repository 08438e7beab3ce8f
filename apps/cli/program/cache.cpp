// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/kept_results.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"
#include "setae/study/provenance.hpp"
#include "study/run_arguments.hpp"

namespace setae::cli::cache_command {
namespace {

constexpr const char* explanation =
    "The cache keeps results between runs.\n"
    "\n"
    "key    SHA-256 over the content of the input files and over every setting that the result depends on\n"
    "entry  version of setae, SHA-256 of the result, the result; used only if version and SHA-256 agree\n"
    "show   number, folder and size of the results kept\n"
    "prune  removes results of other versions and remains of interrupted runs\n"
    "clear  removes all results\n";

struct Arguments {
    Common common;
    std::string what = "show";
    std::string folder;
};

std::string megabytes(std::uintmax_t bytes) { return fmt::format("{:.1f} MB", 1e-6 * static_cast<double>(bytes)); }

ExitCode run(const Arguments& arguments) {
    const cache::Store store(arguments.folder.empty() ? cache::default_folder() : arguments.folder, study::version());
    if (!store.enabled())
        throw InvalidArgument(
            "no folder for kept results: none of SETAE_CACHE, XDG_CACHE_HOME and HOME is set; give a folder with --cache");
    const bool show = arguments.what == "show";
    const auto content = show ? store.content() : store.remove(arguments.what == "prune");
    if (arguments.common.json)
        print_json(show ? output::described(answers::KeptResults{store.folder(), content})
                        : output::described(answers::RemovedResults{store.folder(), content}));
    else if (show)
        print(fmt::format("{}: {} results, {}; {} of other versions than {}\n", store.folder(), content.entries,
                          megabytes(content.bytes), content.of_other_versions, study::version()));
    else print(fmt::format("{}: {} results removed, {}\n", store.folder(), content.entries, megabytes(content.bytes)));
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("what", arguments->what, "show, prune or clear; default: show")
        .one_of_unlisted({"show", "prune", "clear"});
    options.add("--cache", arguments->folder, "folder; default: $SETAE_CACHE, else ~/.cache/setae");
    options.example("setae cache", "number, folder and size of the stored results");
    options.example("setae cache prune", "removal of results of other versions");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::cache_command
