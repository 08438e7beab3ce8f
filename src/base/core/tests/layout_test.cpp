// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/layout.hpp"

#include <gtest/gtest.h>

namespace setae::layout_test {
namespace {

TEST(DisplayWidth, CountsCharacters) {
    EXPECT_EQ(display_width(""), 0u);
    EXPECT_EQ(display_width("µm⁻¹"), 4u);
    EXPECT_EQ(display_width("e\u0301"), 1u) << "an accent that combines";
    EXPECT_EQ(display_width("a\xff"), 2u) << "a byte that is no UTF-8";
}

TEST(Wrapped, BreaksLinesAtSpaces) {
    EXPECT_EQ(wrapped("one two three", 7), "one two\nthree");
    EXPECT_EQ(wrapped("one two three", 8, 2), "one two\n  three");
    EXPECT_EQ(wrapped("unbreakable text", 5), "unbreakable\ntext");
    EXPECT_EQ(wrapped("µm µm µm", 5), "µm µm\nµm");
    EXPECT_EQ(wrapped("", 5), "");
}

TEST(Shortened, EndsInAnEllipsis) {
    EXPECT_EQ(shortened("abcdef", 6), "abcdef");
    EXPECT_EQ(shortened("abcdefg", 6), "abcde…");
    EXPECT_EQ(shortened("µµµµ", 3), "µµ…");
}

}  // namespace
}  // namespace setae::layout_test
