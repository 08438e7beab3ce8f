// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "program/exit_code.hpp"
#include "program/options.hpp"
#include "setae/cache/store.hpp"
#include "setae/parallel/for_each.hpp"
#include "study/progress.hpp"

namespace setae::cli {

/// Options of commands that run a study: --cache, --no-cache, --progress.
struct RunArguments {
    std::string cache_folder;
    bool no_cache = false;
    std::string progress = "auto";

    void add_to(Options& options);
    [[nodiscard]] ProgressMode progress_mode() const;
    /// The store of results; with --no-cache it keeps nothing.
    [[nodiscard]] cache::Store store() const;
};

/// Prints results that the store could not return or keep on standard error.
void report_traffic(const cache::Store& store);

/// Options of a run that shows its steps and can be interrupted.
[[nodiscard]] study::RunOptions run_options(parallel::Threads threads, const cache::Store& store,
                                            ProgressDisplay& display);

/// Runs the body of a command. After an interruption, prints which results are kept and ends the program by the signal.
ExitCode until_interrupted(const cache::Store& store, ProgressDisplay& display, const std::function<ExitCode()>& body);

}  // namespace setae::cli
