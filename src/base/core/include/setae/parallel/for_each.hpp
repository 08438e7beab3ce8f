// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace setae::parallel {

/// Number of worker threads; 0 means all cores of the computer, or the number set by limit_threads().
struct Threads {
    int count = 0;

    [[nodiscard]] int resolved() const;
};

/// Sets the meaning of Threads{} for the whole process, for readers and libraries without an argument for the number of
/// threads; 0 restores all cores.
void limit_threads(Threads threads);

/// Calls body(i) for i = 0 … n − 1, each exactly once, on up to `threads` threads.
///
/// The assignment of indices to threads is not defined. A body writes only to places of its own index. The caller does
/// reductions in index order, so results are the same bytes for any number of threads. Every index runs even if one
/// throws; afterwards the exception of the lowest index is rethrown.
void for_each_index(std::size_t n, Threads threads, const std::function<void(std::size_t)>& body);

}  // namespace setae::parallel
