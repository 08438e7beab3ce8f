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

/// Options of verbs that run a study: --cache, --no-cache, --progress.
struct RunArguments {
    std::string cache_folder;
    bool no_cache = false;
    std::string progress = "auto";

    void add_to(Options& options);
    [[nodiscard]] ProgressMode progress_mode() const;
    /// Where results are kept; a store that keeps nothing where that is not wanted.
    [[nodiscard]] cache::Store store() const;
};

/// Tells on standard error what a store could not give or keep.
void report_traffic(const cache::Store& store);

/// How a study is run for a user: its steps are shown, and it can be interrupted.
[[nodiscard]] study::RunOptions run_options(parallel::Threads threads, const cache::Store& store,
                                            ProgressDisplay& display);

/// Does what a verb does. Where the user interrupts it, says what is kept and ends the program by the signal.
ExitCode until_interrupted(const cache::Store& store, ProgressDisplay& display, const std::function<ExitCode()>& body);

}  // namespace setae::cli
