// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "known_faults.hpp"
#include "setae/core/errors.hpp"
#include "setae/diagnostics/diagnose.hpp"

namespace setae::diagnostics::overlap_test {
namespace {

using topography::Measurement;

TEST(DiagnoseOverlap, FindsNoProblemBetweenSpotsOfOneSurface) {
    const std::array<Measurement, 3> same{surface({.seed = 1}), surface({.seed = 2}), line_of(surface({.seed = 3}))};
    EXPECT_EQ(codes(diagnose_overlap(same)), "");
}

TEST(DiagnoseOverlap, FindsAScaleAppliedTwice) {
    const auto twice = topography::scaled(Measurement(surface({.seed = 2})), 2.0);
    const std::array<Measurement, 2> pair{twice, surface({.seed = 1})};
    const auto found = diagnose_overlap(pair);
    ASSERT_EQ(codes(found), "DISAGREE SCALE_TWICE");
    const auto ratio = quantity(found, "DISAGREE", "psd_ratio").estimate,
               factor = quantity(found, "SCALE_TWICE", "height_factor").estimate;
    EXPECT_NEAR(ratio.value, 4.0, 3.0 * ratio.standard_error);
    EXPECT_NEAR(factor.value, 2.0, 3.0 * factor.standard_error);
    EXPECT_LT(factor.standard_error, 0.3);
}

TEST(DiagnoseOverlap, DistinguishesAnotherSlopeFromAScaleError) {
    const std::array<Measurement, 2> pair{surface({.seed = 1, .hurst_exponent = 0.3}),
                                          surface({.seed = 2, .hurst_exponent = 0.95})};
    const auto found = diagnose_overlap(pair);
    ASSERT_EQ(codes(found), "DISAGREE");
    // C_iso of both is equal at the roll-off, a wavevector x times larger gives x^(2 (0.95 − 0.3)) times more
    EXPECT_GT(value(found, "DISAGREE", "psd_ratio_at_shortest"),
              4.0 * value(found, "DISAGREE", "psd_ratio_at_longest"));
}

TEST(DiagnoseOverlap, RequiresTwoMeasurementsAndACommonBand) {
    const std::array<Measurement, 1> one{surface({})};
    EXPECT_THROW((void)diagnose_overlap(one), InvalidArgument);
    auto wide = line_of(surface({}));
    wide.size *= 1e4;
    const std::array<Measurement, 2> apart{surface({}), wide};
    EXPECT_EQ(codes(diagnose_overlap(apart)), "");
}

}  // namespace
}  // namespace setae::diagnostics::overlap_test
