// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/parallel/memory.hpp"

#include <cstdlib>  // defines __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "setae/parallel/for_each.hpp"
#include "setae/platform/memory.hpp"

namespace setae::parallel {

void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int mebibyte = 1 << 20;
    constexpr std::size_t room = std::size_t{1024} * mebibyte;
    constexpr int processors_per_heap = 4;
    mallopt(M_TRIM_THRESHOLD, 1536 * mebibyte);
    mallopt(M_TOP_PAD, mebibyte);
    mallopt(M_MMAP_MAX, 0);  // memory of a separate mapping is returned to the system when it is freed
    // an array freed by one thread can be reused by others
    mallopt(M_ARENA_MAX, (Threads{}.resolved() + processors_per_heap - 1) / processors_per_heap);
    // untouched freed memory costs nothing and remains the end of the heap, which large pages then fill
    void* const heap = std::malloc(room);
    if (heap != nullptr) platform::prefer_large_pages(heap, room);
    std::free(heap);
#endif
}

}  // namespace setae::parallel
