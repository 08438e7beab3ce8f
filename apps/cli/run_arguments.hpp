// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include "progress.hpp"
#include "session.hpp"
#include "setae/cache/store.hpp"

namespace setae::cli {

/// Options of verbs that run a study: --cache, --no-cache, --progress.
struct RunArguments {
    std::string cache_folder;
    bool no_cache = false;
    std::string progress = "auto";

    void add_to(CLI::App& verb);
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
