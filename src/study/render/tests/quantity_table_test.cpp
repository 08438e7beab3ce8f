// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/quantity_table.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/layout.hpp"

namespace setae::output {
namespace quantity_table_test {
namespace {

Quantity height(double longest, int n) {
    return {.quantity = "rms_height",
            .symbol = "h_rms",
            .estimate = {.value = 1.098e-8,
                         .standard_error = 3.7e-10,
                         .method = "jackknife",
                         .interval = Interval{9.5e-9, 1.266e-8, 0.95}},
            .unit = "m",
            .band = Band{2.0 * pi / longest, 2.0 * pi / 1e-9},
            .n = n};
}

const Quantity modulus{.quantity = "contact_modulus", .symbol = "E*", .estimate = {.value = 933333.3}, .unit = "Pa"};

TEST(QuantityTable, StatesCommonValuesOnce) {
    EXPECT_EQ(quantity_table("a.spm", {height(1e-6, 3), modulus}),
              "a.spm: waves 1.000 µm … 1.000 nm; n = 3; 95 % by jackknife\n"
              "  quantity         symbol  value ± [95 %]\n"
              "  rms_height       h_rms   10.98 ± 0.37 [9.50, 12.66] nm\n"
              "  contact_modulus  E*      933.33 kPa\n");
}

TEST(QuantityTable, HasColumnsForDifferingValues) {
    const auto text = quantity_table("", {height(1e-6, 3), height(2e-6, 1)});
    EXPECT_NE(text.find("wavelengths"), std::string::npos);
    EXPECT_NE(text.find("2.000 µm … 1.000 nm"), std::string::npos);
    EXPECT_EQ(text.find("n = "), std::string::npos);
}

TEST(QuantityTable, FitsTheGivenWidth) {
    auto long_name = height(1e-6, 3);
    long_name.quantity = "elastic_energy_per_modulus_from_spectrum";
    std::istringstream lines(quantity_table("a title of several words that is longer than the width of lines here",
                                            {long_name, height(2e-6, 1)}, 60));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(display_width(line), 60U) << line;
}

}  // namespace
}  // namespace quantity_table_test
}  // namespace setae::output
