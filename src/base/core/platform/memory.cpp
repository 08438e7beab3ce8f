// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/platform/memory.hpp"

#include <sys/mman.h>
#include <unistd.h>

namespace setae::platform {

std::uint64_t memory_of_machine() {
    static const auto bytes =
        static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    return bytes;
}

void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::uint64_t bytes) {
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t page = std::uintptr_t{2} << 20;
    const auto address = reinterpret_cast<std::uintptr_t>(begin);
    const auto first = (address + page - 1) / page * page, last = (address + bytes) / page * page;
    if (last > first) (void)::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

}  // namespace setae::platform
