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

TEST(LastWords, BeginAfterABlankOrADot) {
    EXPECT_EQ(last_words("scatter between pairs", 21), "scatter between pairs");
    EXPECT_EQ(last_words("scatter between pairs", 20), "…between pairs");
    EXPECT_EQ(last_words("scatter between pairs", 14), "…between pairs");
    EXPECT_EQ(last_words("scatter between pairs", 13), "…pairs");
    EXPECT_EQ(last_words("elastomers.E1.9.youngs_modulus", 28), "…E1.9.youngs_modulus");
    EXPECT_EQ(last_words("elastomers.E1.9.youngs_modulus", 18), "…youngs_modulus");
    EXPECT_EQ(last_words("µµµµ", 3), "…µµ");
}

}  // namespace
}  // namespace setae::layout_test
