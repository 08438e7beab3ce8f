// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace setae::platform {

/// [byte]
[[nodiscard]] std::uint64_t memory_of_machine();

/// Requests large pages for memory to be filled, where the system has them: page faults are most of the cost of reading
/// from the cache.
void prefer_large_pages(void* begin, std::uint64_t bytes);

}  // namespace setae::platform
