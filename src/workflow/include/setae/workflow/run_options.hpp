// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include "setae/cache/store.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::workflow {

/// A step of a study that is done.
struct Progress {
    std::string stage;      ///< "measurement", "surface" or "experiment"
    std::string item;       ///< the file, or the surface's name
    std::size_t done = 0;   ///< steps done so far, this one included
    std::size_t total = 0;  ///< steps known so far; a container is opened before its measurements are counted
    bool cached = false;    ///< taken from the store
};

/// How a study is run. None of it changes a result.
struct RunOptions {
    parallel::Threads threads;
    const cache::Store* store = nullptr;                     ///< of results from earlier runs; none: everything is computed
    std::function<void(const Progress&)> progress;           ///< called after each step, one call at a time, from any thread
    const std::atomic<bool>* cancelled = nullptr;            ///< once true, nothing new is begun
};

}  // namespace setae::workflow
