// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include "setae/cache/store.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::study {

/// A step of a study that begins or is done.
struct Progress {
    std::string stage;            ///< "measurement", "surface" or "experiment"
    std::string item;             ///< the file, or the surface's name
    bool begins = false;          ///< else it is done
    bool cached = false;          ///< done: taken from the store
    std::size_t done = 0;         ///< steps done so far
    std::size_t total = 0;        ///< steps known so far; a container is opened before its measurements are counted
    double share = 0.0;           ///< of the expected work that is done, 0 … 1
    double computed_share = 0.0;  ///< the part of it that was not in the store
};

/// How a study is run. None of it changes a result.
struct RunOptions {
    parallel::Threads threads;
    const cache::Store* store = nullptr;  ///< of results from earlier runs; none: everything is computed
    std::function<void(const Progress&)>
        progress;  ///< called as steps begin and end, one call at a time, from any thread
    const std::atomic<bool>* cancelled = nullptr;  ///< once true, nothing new is begun
};

}  // namespace setae::study
