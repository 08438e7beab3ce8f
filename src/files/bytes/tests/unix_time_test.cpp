// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/unix_time.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace setae::bytes::unix_time_test {
namespace {

TEST(UtcText, MatchesCalendarDays) {
    EXPECT_EQ(utc_text(0), "1970-01-01 00:00:00 UTC");
    EXPECT_EQ(utc_text(951782400 + 86399), "2000-02-29 23:59:59 UTC");
    EXPECT_EQ(utc_text(-1), "1969-12-31 23:59:59 UTC");
    EXPECT_EQ(utc_text_of_filetime(0), "1601-01-01 00:00:00 UTC");
    EXPECT_EQ(utc_text_of_filetime(116444736000000000), "1970-01-01 00:00:00 UTC");
}

TEST(UtcText, IsEmptyOutsideTheRangeOfYears) {
    EXPECT_EQ(utc_text(std::numeric_limits<std::int64_t>::max()), "");
    EXPECT_EQ(utc_text(std::numeric_limits<std::int64_t>::min()), "");
    EXPECT_EQ(utc_text_of_filetime(std::numeric_limits<std::uint64_t>::max()), "");
}

}  // namespace
}  // namespace setae::bytes::unix_time_test
