// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include "setae/cache/store.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::study {

/// A step of a study that starts or is done.
struct Progress {
    std::string stage;            ///< "measurement", "surface" or "experiment"
    std::string item;             ///< the file, or the surface's name
    bool begins = false;          ///< false: it is done
    bool cached = false;          ///< for a finished step: taken from the store
    std::size_t done = 0;         ///< steps done so far
    std::size_t total = 0;        ///< steps known so far; a container is opened before its measurements are counted
    double share = 0.0;           ///< share of the expected work that is done, 0 … 1
    double computed_share = 0.0;  ///< share of the work that was not in the store
};

/// Options of a run. They do not change any result.
struct RunOptions {
    parallel::Threads threads;
    const cache::Store* store = nullptr;  ///< store of results from earlier runs; without it, everything is computed
    std::function<void(const Progress&)>
        progress;  ///< called as steps start and end, one call at a time, from any thread
    const std::atomic<bool>* cancelled = nullptr;  ///< once true, no new step is started
};

}  // namespace setae::study
