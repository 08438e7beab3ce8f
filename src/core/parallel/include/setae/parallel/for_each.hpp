// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace setae::parallel {

/// Number of worker threads; 0 means as many as the machine has cores.
struct Threads {
    int count = 0;

    [[nodiscard]] int resolved() const;
};

/// Calls body(i) for i = 0 … n − 1, each exactly once, on up to `threads` threads.
///
/// Which thread takes which index is left open, so a body writes only to places of its own index; reductions are then
/// done by the caller in index order, which keeps results the same to the byte for any number of threads.
/// Every index runs even if one throws; afterwards the exception of the lowest index is rethrown.
void for_each_index(std::size_t n, Threads threads, const std::function<void(std::size_t)>& body);

}  // namespace setae::parallel
