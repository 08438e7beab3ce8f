// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/error_parts.hpp"

#include <gtest/gtest.h>

#include "setae/core/units.hpp"

namespace setae::error_parts_test {
namespace {

TEST(ErrorParts, OfAFormatErrorAreFilePositionAndCause) {
    const auto of_text = error_parts(
        FormatError("b/loop.csv", {.offset = {}, .line = 12}, "'x' is no number; expected metres; mend it").what(),
        true);
    EXPECT_EQ(of_text.file, "b/loop.csv");
    EXPECT_EQ(of_text.position.line, 12U);
    EXPECT_FALSE(of_text.position.offset);
    EXPECT_EQ(of_text.got, "'x' is no number");
    EXPECT_EQ(of_text.expected, "metres");

    const auto of_bytes = error_parts(
        FormatError("map.spm", {.offset = 4096, .line = {}}, "it ends, expected 8 bytes more").what(), true);
    EXPECT_EQ(of_bytes.file, "map.spm");
    EXPECT_EQ(of_bytes.position.offset, 4096U);
    EXPECT_EQ(of_bytes.got, "it ends");
    EXPECT_EQ(of_bytes.expected, "8 bytes more");
}

TEST(ErrorParts, OfAWrongUnitLackAFile) {
    try {
        (void)parse_quantity("3 kg", dimension::length);
        FAIL() << "no exception";
    } catch (const InvalidArgument& error) {
        const auto parts = error_parts(error.what(), false);
        EXPECT_EQ(parts.file, "");
        EXPECT_NE(parts.expected, "") << error.what();
        EXPECT_NE(parts.got.find("kg"), std::string::npos) << error.what();
    }
}

TEST(ErrorParts, OfOtherTextAreEmpty) {
    const auto parts = error_parts("the caller asked to stop", false);
    EXPECT_EQ(parts.file + parts.got + parts.expected, "");
    EXPECT_FALSE(parts.position.line || parts.position.offset);
}

}  // namespace
}  // namespace setae::error_parts_test
