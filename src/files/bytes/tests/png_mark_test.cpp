// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/png_mark.hpp"

#include <gtest/gtest.h>

namespace setae::bytes::png_mark_test {
namespace {

TEST(PngMark, IsInsertedOnceAfterTheFirstChunk) {
    // an IHDR of 1 × 1 grey pixels, and the following bytes
    const std::string head("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\10\0\0\0\0\x3a\x7e\x9b\x55", 33),
        rest = "IDAT…";
    EXPECT_FALSE(has_png_mark(head + rest));
    const auto marked = with_png_mark(head + rest);
    EXPECT_TRUE(has_png_mark(marked));
    EXPECT_EQ(marked.substr(0, 33), head);
    EXPECT_EQ(marked.substr(33, 22), std::string("\0\0\0\x0etEXtSoftware\0setae", 22));
    EXPECT_EQ(marked.substr(59), rest);
    EXPECT_EQ(with_png_mark(marked), marked);
    EXPECT_EQ(with_png_mark("no picture"), "no picture");
}

}  // namespace
}  // namespace setae::bytes::png_mark_test
