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

TEST(TextOfATable, LeavesOutColumnsThatSayNothing) {
    EXPECT_EQ(as_text_within(table, 40),
              "Surfaces\n"
              "  surface  h [nm]         n\n"
              "  A        5.1 ± 0.1  3.000\n"
              "  longer   –              –\n");
}

TEST(TextOfATable, StacksRowsThatAreTooWide) {
    EXPECT_EQ(as_text_within(table, 20),
              "Surfaces\n"
              "  A\n"
              "    h [nm]  5.1 ± 0.1\n"
              "    n       3.000\n"
              "  longer\n");
}

}  // namespace
}  // namespace setae::tables::tidy_table_test
