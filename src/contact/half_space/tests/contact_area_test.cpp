// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/contact_area.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"

namespace setae::half_space::contact_area_test {
namespace {

TEST(ContactArea, CountsPatchesAcrossPeriodicEdges) {
    Array2D p = Array2D::Zero(6, 8);
    p(0, 0) = p(5, 0) = 1.0;  // one patch across the edge
    p(2, 3) = p(3, 4) = 1.0;  // corners do not join
    const Grid grid{6, 8, 6.0, 16.0};
    const ContactArea area = contact_area(p, grid);
    EXPECT_EQ(area.patches, 3);
    EXPECT_DOUBLE_EQ(area.largest_patch, 4.0);
    EXPECT_DOUBLE_EQ(area.fraction, 4.0 / 48.0);
    // pixels of 1 m x 2 m: the pair is 2 m x 2 m, two stand alone
    EXPECT_DOUBLE_EQ(area.perimeter, 8.0 + 2.0 * 6.0);
    EXPECT_EQ(contact_area(p, grid, Edges::free).patches, 4);
    EXPECT_DOUBLE_EQ(contact_area(Array2D::Zero(6, 8), grid).largest_patch, 0.0);
}

TEST(ContactArea, CorrectedOfADiscConvergesFaster) {
    // pixels a disc of radius R under pressure reaches: A + (fraction of a pixel) · perimeter too much
    const auto errors = [](Index n) {
        Array2D p(n, n);
        const double middle = 0.5 * static_cast<double>(n) - 0.3, radius = 0.37 * static_cast<double>(n);
        for (Index i = 0; i < n; ++i)
            for (Index j = 0; j < n; ++j)
                p(i, j) = std::hypot(static_cast<double>(i) - middle, static_cast<double>(j) - middle) < radius + 0.15
                              ? 1.0
                              : 0.0;
        const ContactArea area = contact_area(p, {n, n, 1.0, 1.0});
        return std::pair(area.fraction / (pi * 0.37 * 0.37) - 1.0, area.corrected_fraction / (pi * 0.37 * 0.37) - 1.0);
    };
    const auto [plain, corrected] = errors(200);
    EXPECT_GT(plain, 3e-3);
    EXPECT_LT(std::abs(corrected), 0.5 * plain);
    const double edges = 4.0 * std::round(2.0 * (0.37 * 200.0 + 0.15));
    EXPECT_NEAR(plain - corrected, (pi - 1.0 + std::numbers::ln2) / 24.0 * edges / (pi * 0.37 * 0.37 * 4e4), 2e-4);
}

}  // namespace
}  // namespace setae::half_space::contact_area_test
