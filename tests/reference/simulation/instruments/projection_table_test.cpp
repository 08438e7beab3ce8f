// SPDX-License-Identifier: GPL-3.0-or-later
// The table of docs/concepts/tem-projection.md against other surfaces on another grid.
#include "projection_table.hpp"

#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace projection_table_test {

using namespace setae;

/// The numbers of the table's row for a case: value and ± alternate from h_rms on.
std::vector<double> documented(const tests::ProjectionCase& wanted) {
    std::ifstream page("docs/concepts/tem-projection.md");
    for (std::string line; std::getline(page, line);) {
        for (const std::string mark : {"|", "±"})
            for (auto at = line.find(mark); at != std::string::npos; at = line.find(mark))
                line.replace(at, mark.size(), " ");
        std::istringstream words(line);
        double hurst_exponent = 0.0, rolloff = 0.0, thickness = 0.0, correlation = 0.0;
        if (!(words >> hurst_exponent >> rolloff >> thickness >> correlation)) continue;
        if (hurst_exponent != wanted.hurst_exponent || std::abs(rolloff * 1e-9 - wanted.rolloff_wavelength) > 1e-12 ||
            std::abs(thickness * 1e-9 - wanted.thickness) > 1e-12)
            continue;
        std::vector<double> numbers;
        for (double number = 0.0; words >> number;) numbers.push_back(number);
        return numbers;
    }
    return {};
}

TEST(ProjectionTable, OfTheDocumentMatchesOtherSurfacesOnASmallerGrid) {
    for (const tests::ProjectionCase row :
         {tests::ProjectionCase{0.8, 25e-9, 20e-9}, tests::ProjectionCase{0.8, 50e-9, 20e-9}}) {
        const auto expected = documented(row);
        const auto bias = tests::simulated(row, 4, 99, 204.8e-9);
        ASSERT_EQ(expected.size(), 4 + 2 * static_cast<std::size_t>(bias.C1D.size()));
        // four surfaces determine their standard error to 40 %: five of them; the page rounds to 0.005 and 0.0005
        const auto agrees = [&](double value, double error, std::size_t at, double rounding, const char* what) {
            EXPECT_NEAR(value, expected[at], 5.0 * std::hypot(error, expected[at + 1]) + rounding) << what << ' ' << at;
        };
        agrees(bias.rms_height.value, bias.rms_height.standard_error, 0, 5e-4, "rms height");
        agrees(bias.rms_slope.value, bias.rms_slope.standard_error, 2, 5e-4, "rms slope");
        for (Index b = 0; b < bias.C1D.size(); ++b)
            agrees(bias.C1D[b], bias.C1D_standard_error[b], 4 + 2 * static_cast<std::size_t>(b), 5e-3, "C1D");
    }
}

TEST(ProjectionTable, HasARowForEveryCase) {
    for (const auto& row : tests::projection_cases())
        EXPECT_EQ(documented(row).size(), 18U)
            << row.hurst_exponent << ' ' << row.rolloff_wavelength << ' ' << row.thickness;
}

}  // namespace projection_table_test
