// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace setae::bytes {

/// "2011-07-23 16:49:36 UTC" from seconds since 1970; empty for seconds outside the years 1 to 9999.
[[nodiscard]] std::string utc_text(std::int64_t seconds);

/// "2011-07-23 16:49:36 UTC" from 100 ns steps since 1601 (Windows file time).
[[nodiscard]] std::string utc_text_of_filetime(std::uint64_t ticks);

}  // namespace setae::bytes
