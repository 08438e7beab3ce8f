// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/measurement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/artefact.hpp"
#include "setae/topography/contour.hpp"
#include "setae/topography/line_scans.hpp"

namespace setae::topography::measurement_test {
namespace {

Profile contour(std::vector<double> x, std::vector<double> h) {
    Profile profile;
    profile.positions = Eigen::Map<Array1D>(x.data(), static_cast<Index>(x.size()));
    profile.heights = Eigen::Map<Array1D>(h.data(), static_cast<Index>(h.size()));
    return profile;
}

TEST(Validate, NamesTheInvalidPoint) {
    const auto bad = contour({0.0, 1.0, 1.0, 2.0}, {0.0, 0.0, 0.0, 0.0});
    try {
        validate(bad);
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("x does not increase at point 2"), std::string::npos) << error.what();
    }
}

TEST(Validate, RefusesEmptyUndefinedAndInfinite) {
    EXPECT_THROW(validate(LineScan{Array1D(), 1.0}), InvalidArgument);
    EXPECT_THROW(validate(LineScan{Array1D::Zero(5), 0.0}), InvalidArgument);
    EXPECT_THROW(validate(LineScan{Array1D::Constant(5, undefined), 1.0}), UndefinedDataError);
    EXPECT_THROW(validate(HeightMap{Array2D::Constant(2, 2, INFINITY), {1.0, 1.0}}), InvalidArgument);
    EXPECT_NO_THROW(validate(HeightMap{Array2D::Zero(2, 2), {1.0, 1.0}}));
}

TEST(CleanContour, LeavesASingleValuedContourUnchanged) {
    const auto clean = clean_contour(contour({0.0, 1.0, 2.5}, {0.0, 1.0, 0.0}));
    EXPECT_EQ(clean.profile.positions.size(), 3);
    EXPECT_EQ(clean.reentrant_share, 0.0);
    EXPECT_TRUE(clean.alerts.empty());
}

TEST(CleanContour, DropsRepeatedPointsAndCutsReentrantStretchesWithTheirShare) {
    // forward 3, back 1 under an overhang and forward again: 2 of 7 length units are removed
    const auto clean =
        clean_contour(contour({0.0, 1.0, 2.0, 3.0, 2.0, 3.0, 3.5, 4.0, 4.0, 5.0}, std::vector<double>(10, 0.0)));
    EXPECT_EQ(clean.reentrant_points, 2);
    EXPECT_EQ(clean.dropped_points, 1);
    EXPECT_DOUBLE_EQ(clean.reentrant_share, 2.0 / 7.0);
    ASSERT_EQ(clean.alerts.size(), 1u);
    EXPECT_EQ(clean.alerts[0].code, "REENTRANT");
    EXPECT_NO_THROW(validate(clean.profile));
}

TEST(CleanContour, ReversesAContourTracedFromTheRight) {
    const auto clean = clean_contour(contour({3.0, 2.0, 0.0}, {7.0, 8.0, 9.0}));
    EXPECT_EQ(clean.profile.positions[0], 0.0);
    EXPECT_EQ(clean.profile.heights[0], 9.0);
    EXPECT_EQ(clean.reentrant_points, 0);
}

TEST(CleanContour, RefusesAVerticalLine) {
    EXPECT_THROW((void)clean_contour(contour({1.0, 1.0, 1.0}, {0.0, 1.0, 2.0})), UndefinedDataError);
    EXPECT_THROW((void)clean_contour(contour({}, {})), UndefinedDataError);
}

TEST(ReferenceArtefact, IsRecoveredAndSubtracted) {
    const Index n = 200;
    const Array1D t = Array1D::LinSpaced(n, 0.0, 1.0);
    const Array1D bow = 1e-6 * (t * t - t + 1.0 / 6.0);
    const LineScan artefact{bow, 1e-3};
    std::vector<LineScan> references;
    for (const double tilt : {-2e-6, 1e-6, 3e-6}) references.push_back({bow + tilt * t, 1e-3});
    const auto average = average_reference(references);
    LineScan scan{3e-7 * (40.0 * t).sin(), 1e-3};
    const Array1D truth = scan.heights;
    scan.heights += average.heights;
    EXPECT_LT((subtract_artefact(scan, average).heights - truth).abs().maxCoeff(), 1e-18);
    // averaging keeps the curved part of the bow
    EXPECT_NEAR(average.heights[0] - 2.0 * average.heights[n / 2] + average.heights[n - 1],
                bow[0] - 2.0 * bow[n / 2] + bow[n - 1], 1e-9);
}

TEST(ReferenceArtefact, RefusesScansOnAnotherGrid) {
    const std::vector<LineScan> references{{Array1D::Zero(10), 1.0}, {Array1D::Zero(12), 1.0}};
    EXPECT_THROW((void)average_reference(references), InvalidArgument);
}

TEST(ReferenceArtefact, ShorterThanTheScanCutsTheScan) {
    const LineScan scan{Array1D::Ones(100), 1.0}, artefact{Array1D::Ones(51), 0.51};
    const auto corrected = subtract_artefact(scan, artefact);
    EXPECT_EQ(corrected.heights.size(), 51);
    EXPECT_NEAR(corrected.pixel_size(), scan.pixel_size(), 1e-15);
    EXPECT_EQ(corrected.heights.abs().maxCoeff(), 0.0);
}

TEST(LineScans, OfAMapAreAlongX) {
    HeightMap map{Array2D(3, 2), {3.0, 5.0}};
    map.heights << 0, 10, 1, 11, 2, 12;
    const auto scans = line_scans(map);
    ASSERT_EQ(scans.size(), 2u);
    EXPECT_EQ(scans[1].heights[2], 12.0);
    EXPECT_EQ(scans[0].size, 3.0);
}

TEST(ToLineScan, AcceptsRoundedPositionsAndRefusesUnevenOnes) {
    const auto rounded = contour({0.000, 0.100, 0.199, 0.300, 0.400}, {0, 1, 2, 3, 4});
    ASSERT_TRUE(to_line_scan(rounded));
    EXPECT_NEAR(to_line_scan(rounded)->size, 0.5, 1e-15);
    EXPECT_FALSE(to_line_scan(contour({0.0, 1.0, 2.5, 3.0}, {0, 1, 2, 3})));
}

TEST(ToProfile, OmitsUndefinedPoints) {
    LineScan scan{Array1D::Zero(4), 4.0};
    scan.heights[1] = undefined;
    const auto profile = to_profile(scan);
    ASSERT_EQ(profile.positions.size(), 3);
    EXPECT_EQ(profile.positions[1], 2.0);
}

}  // namespace
}  // namespace setae::topography::measurement_test
