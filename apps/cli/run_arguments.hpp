// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "progress.hpp"
#include "setae/cache/store.hpp"
#include "setae/workflow/study_result.hpp"

namespace setae::cli {

/// Options of verbs that run a study: --cache, --no-cache, --progress.
struct RunArguments {
    std::string cache_folder;
    bool no_cache = false;
    ProgressMode progress = ProgressMode::automatic;

    void add_to(CLI::App& verb);
    /// Where results are kept; a store that keeps nothing where that is not wanted.
    [[nodiscard]] cache::Store store() const;
};

/// Tells on standard error what a store could not give or keep.
void report_traffic(const cache::Store& store);

/// Runs a study, shows its steps, and ends the program where the user asks for it: what is done by then is kept.
[[nodiscard]] workflow::StudyResult run_for_user(workflow::Study study, parallel::Threads threads, const cache::Store& store, ProgressDisplay& display);

}  // namespace setae::cli
