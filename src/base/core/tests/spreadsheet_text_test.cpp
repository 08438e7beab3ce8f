// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/spreadsheet_text.hpp"

#include <gtest/gtest.h>

namespace setae::spreadsheet_text_test {
namespace {

TEST(SpreadsheetCell, EscapesFormulas) {
    for (const char* formula : {"=1+1", "+A", "-A", "@SUM(A1)", " =1", "\t=1", "\r=1", "\xc2\xa0=1", "\xe2\x80\x8b=1",
                                "\xe3\x80\x80=1", "\xef\xbb\xbf=1", "＝1+1", " ＋1", "－1", "＠SUM"})
        EXPECT_EQ(spreadsheet_cell(formula).front(), '\'') << formula;
}

TEST(SpreadsheetCell, LeavesOtherTextUnchanged) {
    for (const char* text : {"", "a", "a=1", "5'' wafer", "1 - 2", "Ä", " a", "a; b"})
        EXPECT_EQ(spreadsheet_cell(text), text);
}

TEST(SpreadsheetCell, QuotesSeparatorsAndLineBreaks) {
    EXPECT_EQ(spreadsheet_cell("a,b"), "\"a,b\"");
    EXPECT_EQ(spreadsheet_cell("a\"b"), "\"a\"\"b\"");
    EXPECT_EQ(spreadsheet_cell("a\r\nb"), "a  b");
    EXPECT_EQ(spreadsheet_cell("=A1,B1"), "\"'=A1,B1\"");
}

}  // namespace
}  // namespace setae::spreadsheet_text_test
