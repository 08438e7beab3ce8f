// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/unix_time.hpp"

#include <chrono>

#include <fmt/format.h>

namespace setae::bytes {

std::string utc_text(std::int64_t seconds) {
    using namespace std::chrono;
    constexpr auto earliest = sys_seconds(sys_days(year(1) / 1 / 1)).time_since_epoch().count();
    constexpr auto latest = sys_seconds(sys_days(year(9999) / 12 / 31)).time_since_epoch().count();
    if (seconds < earliest || seconds > latest) return {};
    const sys_seconds time{std::chrono::seconds(seconds)};
    const auto midnight = floor<days>(time);
    const year_month_day date(midnight);
    const hh_mm_ss clock(time - midnight);
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02} UTC", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), clock.hours().count(),
                       clock.minutes().count(), clock.seconds().count());
}

std::string utc_text_of_filetime(std::uint64_t ticks) {
    constexpr std::int64_t from_1601_to_1970 = 11644473600;
    return utc_text(static_cast<std::int64_t>(ticks / 10000000) - from_1601_to_1970);
}

}  // namespace setae::bytes
