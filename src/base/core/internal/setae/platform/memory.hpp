// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace setae::platform {

/// [byte]
[[nodiscard]] std::uint64_t memory_of_machine();

/// Large pages for memory about to be filled, where the system has them: a fault a page is most of what reading from
/// the cache costs.
void prefer_large_pages(void* begin, std::uint64_t bytes);

}  // namespace setae::platform
