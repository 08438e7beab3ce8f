// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/parallel/memory.hpp"

#include <cstdlib>  // says __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace setae::parallel {

void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int mebibyte = 1 << 20;
    mallopt(M_TRIM_THRESHOLD, 256 * mebibyte);
    mallopt(M_TOP_PAD, mebibyte);
    mallopt(M_MMAP_THRESHOLD, 32 * mebibyte);  // where glibc's own adjustment, which these settings end, would arrive
#endif
}

}  // namespace setae::parallel
