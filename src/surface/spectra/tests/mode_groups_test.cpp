// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/mode_groups.hpp"

#include <gtest/gtest.h>

namespace setae::spectra::mode_groups_test {
namespace {

TEST(NarrowGroups, AreSingleModesThenNarrowBands) {
    const Array1D q = Array1D::LinSpaced(1000, 1.0, 1000.0);
    const auto first = narrow_groups(q, 1.02, 100);
    for (Index k = 0; k < 100; ++k) EXPECT_EQ(first[static_cast<std::size_t>(k)], k);
    EXPECT_EQ(first.back(), 1000);
    EXPECT_LT(first.size(), 100u + 200u);
    for (std::size_t g = 100; g + 1 < first.size(); ++g) {
        EXPECT_LT(first[g], first[g + 1]);
        EXPECT_LE(q[first[g + 1] - 1], 1.02 * q[first[g]]);
    }
}

TEST(NarrowGroups, OfFewModesAreSingleModes) {
    EXPECT_EQ(narrow_groups(Array1D::LinSpaced(3, 1.0, 3.0), 1.5, 3), (std::vector<Index>{0, 1, 2, 3}));
    EXPECT_EQ(narrow_groups(Array1D(), 1.5), (std::vector<Index>{0}));
}

}  // namespace
}  // namespace setae::spectra::mode_groups_test
