// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace setae::parallel {

/// Number of worker threads; 0 means as many as the machine has cores, or as limit_threads() allows.
struct Threads {
    int count = 0;

    [[nodiscard]] int resolved() const;
};

/// What Threads{} stands for from now on in the whole process, for readers and libraries that nobody tells a number; 0
/// again for all cores.
void limit_threads(Threads threads);

/// Calls body(i) for i = 0 … n − 1, each exactly once, on up to `threads` threads.
///
/// Which thread takes which index is left open, so a body writes only to places of its own index; reductions are then
/// done by the caller in index order, which keeps results the same to the byte for any number of threads.
/// Every index runs even if one throws; afterwards the exception of the lowest index is rethrown.
void for_each_index(std::size_t n, Threads threads, const std::function<void(std::size_t)>& body);

}  // namespace setae::parallel
