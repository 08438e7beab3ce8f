// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact_line/line_table.hpp"

#include <gtest/gtest.h>

#include "lines.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact_line::line_table_test {
namespace {

TEST(LineTable, IsReadBackUnchanged) {
    auto line = rough_lines(3, 16, 0.5, 1e-6, 0.0, 5);
    line.place_error = 1.25e-8;
    const auto table = as_table(line, {4, 5, 7});
    EXPECT_EQ(table.columns.size(), 18u);
    EXPECT_EQ(table.at("frame")[2], 7.0);
    EXPECT_EQ(table.columns[17].name, "radius_16");
    const auto again = line_of(table);
    EXPECT_TRUE((again.radius == line.radius).all());
    EXPECT_TRUE((again.time == line.time).all());
    EXPECT_DOUBLE_EQ(again.place_error, 1.25e-8);
}

TEST(LineTable, RefusesGapsAndOtherTables) {
    auto table = as_table(rough_lines(3, 17, 0.5, 1e-6, 0.0, 5), {1, 2, 3});
    EXPECT_THROW((void)as_table(line_of(table), {1, 2}), InvalidArgument);
    table.columns.erase(table.columns.begin() + 6);
    EXPECT_THROW((void)line_of(table), InvalidArgument);
    table.columns.resize(2);
    EXPECT_THROW((void)line_of(table), InvalidArgument);
    table.columns.clear();
    EXPECT_THROW((void)line_of(table), InvalidArgument);
}

}  // namespace
}  // namespace setae::contact_line::line_table_test
