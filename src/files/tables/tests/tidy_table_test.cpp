// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/tidy_table.hpp"

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"

namespace setae::tables::tidy_table_test {
namespace {

const TidyTable table{"Surfaces",
                      {"surface", "h [nm]", "note", "n"},
                      {{std::string("A"), std::string("5.1 ± 0.1"), std::string(), 3.0},
                       {std::string("longer"), std::string("–"), std::string("–"), undefined}}};

TEST(TextOfATable, AlignsItsColumns) {
    EXPECT_EQ(as_text(table),
              "Surfaces\n"
              "  surface  h [nm]     note      n\n"
              "  A        5.1 ± 0.1        3.000\n"
              "  longer   –          –         –\n");
}

TEST(TextOfATable, OmitsColumnsWithoutInformation) {
    EXPECT_EQ(as_text_within(table, 40),
              "Surfaces\n"
              "  surface  h [nm]         n\n"
              "  A        5.1 ± 0.1  3.000\n"
              "  longer   –              –\n");
}

TEST(TextOfATable, WrapsALastColumnOfText) {
    const TidyTable wide{
        "",
        {"code", "what it says"},
        {{std::string("A"), std::string("a reason of more words than one line of this width can hold")}}};
    EXPECT_EQ(as_text_within(wide, 40),
              "  code  what it says\n"
              "  A     a reason of more words than one\n"
              "        line of this width can hold\n");
}

TEST(TextOfATable, StacksRowsThatAreTooWide) {
    EXPECT_EQ(as_text_within(table, 20),
              "Surfaces\n"
              "  A\n"
              "    h [nm]  5.1 ± 0.1\n"
              "    n       3.000\n"
              "  longer\n");
}

TEST(TextOfATable, StatesConstantColumnsOnceInTheTitle) {
    const TidyTable measured{"a.csv",
                             {"symbol", "filter", "note", "points", "value"},
                             {{std::string("Sq"), std::string("none"), std::string(), 20.0, 1.0},
                              {std::string("Sa"), std::string("none"), std::string(), 20.0, 2.0}}};
    EXPECT_EQ(as_text(constants_in_title(measured)),
              "a.csv: filter none; points 20.00\n"
              "  symbol  value\n"
              "  Sq      1.000\n"
              "  Sa      2.000\n");
    auto one = measured;
    one.rows.pop_back();
    EXPECT_EQ(constants_in_title(one).columns, one.columns);
    EXPECT_EQ(with_columns(measured, {"value", "unknown", "symbol"}).columns,
              (std::vector<std::string>{"value", "symbol"}));
}

}  // namespace
}  // namespace setae::tables::tidy_table_test
