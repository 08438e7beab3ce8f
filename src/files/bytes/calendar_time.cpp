// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/calendar_time.hpp"

#include <chrono>
#include <cstdlib>

#include <fmt/format.h>

namespace setae::bytes {

std::string iso_text(const CalendarTime& time) {
    const auto within = [](int value, int least, int most) { return value >= least && value <= most; };
    if (!within(time.year, 1, 9999) || !within(time.month, 1, 12) || !within(time.day, 1, 31) ||
        !within(time.hour, 0, 23) || !within(time.minute, 0, 59) || !within(time.second, 0, 60))
        return {};
    const std::chrono::year_month_day date{std::chrono::year(time.year),
                                           std::chrono::month(static_cast<unsigned>(time.month)),
                                           std::chrono::day(static_cast<unsigned>(time.day))};
    if (!date.ok()) return {};
    constexpr int max_minutes = 18 * 60;
    auto text = fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", time.year, time.month, time.day, time.hour,
                            time.minute, time.second);
    if (const auto ahead = time.minutes_ahead_of_utc; ahead && within(*ahead, -max_minutes, max_minutes))
        text += fmt::format("{}{:02}:{:02}", *ahead < 0 ? '-' : '+', std::abs(*ahead) / 60, std::abs(*ahead) % 60);
    return text;
}

}  // namespace setae::bytes
