// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/run_arguments.hpp"

#include <fmt/format.h>

#include "program/messages.hpp"
#include "setae/core/errors.hpp"
#include "setae/study/provenance.hpp"
#include "study/interruption.hpp"

namespace setae::cli {

void RunArguments::add_to(Options& options) {
    const auto folder =
        options.add("--cache", cache_folder, "folder of stored results; default: $SETAE_CACHE, else ~/.cache/setae")
            .in(OptionGroup::advanced);
    options.flag("--no-cache", no_cache, "compute everything again and store no results")
        .excludes(folder)
        .in(OptionGroup::advanced);
    options
        .add("--progress", progress,
             "auto (bar on a terminal, else nothing), bar, json (lines on standard error) or none")
        .one_of_unlisted({"auto", "bar", "json", "none"})
        .value_named("auto|bar|json|none")
        .in(OptionGroup::advanced);
}

ProgressMode RunArguments::progress_mode() const {
    if (progress == "bar") return ProgressMode::bar;
    if (progress == "json") return ProgressMode::json;
    return progress == "none" ? ProgressMode::none : ProgressMode::automatic;
}

cache::Store RunArguments::store() const {
    if (no_cache) return {};
    return {cache_folder.empty() ? cache::default_folder() : cache_folder, study::version()};
}

void report_traffic(const cache::Store& store) {
    const auto traffic = store.traffic();
    const auto results = [](std::uint64_t n) { return fmt::format("{} result{}", n, n == 1 ? "" : "s"); };
    if (traffic.damaged > 0)
        print_message(fmt::format("cache: {} in {} damaged; computed again", results(traffic.damaged), store.folder()));
    if (traffic.other_version > 0)
        print_message(fmt::format("cache: {} in {} of another version of setae; computed again",
                                  results(traffic.other_version), store.folder()));
    if (traffic.not_kept > 0)
        print_message(fmt::format(
            "cache: {} could not be kept in {}; check that it is writable and has space, or set SETAE_CACHE",
            results(traffic.not_kept), store.folder()));
}

study::RunOptions run_options(parallel::Threads threads, const cache::Store& store, ProgressDisplay& display) {
    study::RunOptions options;
    options.threads = threads;
    options.store = &store;
    options.progress = [&display](const study::Progress& progress) { display.show(progress); };
    options.cancelled = &interruption();
    return options;
}

ExitCode until_interrupted(const cache::Store& store, ProgressDisplay& display, const std::function<ExitCode()>& body) {
    try {
        return body();
    } catch (const Cancelled&) {
        display.finish();
        print_message(fmt::format("stopped after {} of {} steps; {}", display.last().done, display.last().total,
                                  store.enabled() ? "completed steps are kept; repeat the command to continue"
                                                  : "without a cache no step is kept"));
        end_as_interrupted();
    }
}

}  // namespace setae::cli
