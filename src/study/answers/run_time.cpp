// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/run_time.hpp"

#include <chrono>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"

namespace setae::answers {

namespace {

constexpr std::time_t last_second = 253402300799;  // end of the year 9999

/// Seconds since 1970 that $SOURCE_DATE_EPOCH sets, or now. @throws InvalidArgument for a value that is no such number.
std::time_t seconds_of_run() {
    const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
    if (!epoch || !*epoch) return std::time(nullptr);
    const auto seconds = spelled<std::time_t>(epoch);
    if (!seconds || *seconds < 0 || *seconds > last_second)
        throw InvalidArgument(fmt::format("SOURCE_DATE_EPOCH is '{}', expected whole seconds since 1970, from 0 to {}",
                                          epoch, last_second));
    return *seconds;
}

}  // namespace

std::string time_of_run() {
    const std::chrono::sys_seconds now{std::chrono::seconds(seconds_of_run())};
    const auto day = std::chrono::floor<std::chrono::days>(now);
    const std::chrono::year_month_day date(day);
    const std::chrono::hh_mm_ss time(now - day);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), time.hours().count(),
                       time.minutes().count(), time.seconds().count());
}

}  // namespace setae::answers
