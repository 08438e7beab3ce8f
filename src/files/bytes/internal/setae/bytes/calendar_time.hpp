// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace setae::bytes {

/// Date and time in numbers, as in binary headers.
struct CalendarTime {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
    std::optional<int> minutes_ahead_of_utc = {};
};

/// "2014-09-29T10:58:26", with "+09:00" at the end if the offset is known; empty for fields that are no date.
[[nodiscard]] std::string iso_text(const CalendarTime& time);

}  // namespace setae::bytes
