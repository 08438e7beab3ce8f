// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/region.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "record_number.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::processing::region_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Mask;
using topography::Profile;

/// 10 x 8 points of 1 µm; heights 1 … 80 nm in storage order.
HeightMap ramp() {
    HeightMap map{Array2D(10, 8), {10e-6, 8e-6}};
    for (Index k = 0; k < 80; ++k) map.heights.data()[k] = 1e-9 * static_cast<double>(k + 1);
    return map;
}

Index chosen(const std::string& text, const HeightMap& map = ramp()) {
    return (mask_of(region_from_text(text), map) != 0).count();
}

TEST(Region, WithoutShapesIsTheWholeMap) {
    EXPECT_TRUE(Region{}.everything());
    EXPECT_EQ(chosen(""), 80);
}

TEST(Region, OfARectangleIncludesItsEdges) {
    EXPECT_EQ(chosen("include rectangle 2 um to 4 um, 1 um to 5 um"), 3 * 5);
    EXPECT_EQ(chosen("include rectangle 2 um to 4 um"), 3 * 8);
    EXPECT_EQ(chosen("include rectangle all, above 6 um"), 10 * 2);
    EXPECT_EQ(chosen("exclude rectangle below 0.3 um"), 9 * 8);
    EXPECT_EQ(chosen("include rectangle 2.1 um to 2.9 um"), 0);
}

TEST(Region, OfAnEllipseCoversItsArea) {
    HeightMap map{Array2D::Zero(400, 400), {1e-6, 1e-6}};
    const auto points = static_cast<double>(chosen("include ellipse 0.5 um, 0.5 um, 0.3 um, 0.1 um, 30 deg", map));
    EXPECT_NEAR(points / 160000.0, pi * 0.3 * 0.1, 2e-4);
    const auto mask = mask_of(region_from_text("include ellipse 0.5 um, 0.5 um, 0.3 um, 0.1 um, 30 deg"), map);
    EXPECT_EQ(mask(200 + 100, 200 + 58), 1);  // along the first semi-axis: x towards y
    EXPECT_EQ(mask(200 + 100, 200 - 58), 0);
}

TEST(Region, OfAPolygonFollowsTheEvenOddRule) {
    HeightMap map{Array2D::Zero(200, 300), {2.0, 3.0}};
    EXPECT_NEAR(static_cast<double>(chosen("include polygon 0.1 m, 0.2 m, 1.9 m, 0.3 m, 0.7 m, 2.8 m", map)) * 1e-4,
                0.5 * std::fabs(1.8 * 2.6 - 0.6 * 0.1), 0.01);
    // the core of a pentagram is outside
    std::string star = "include polygon ";
    for (int k = 0; k < 5; ++k) {
        const double angle = 0.1 + 4.0 * pi / 5.0 * k;
        star += (k > 0 ? ", " : "") + std::to_string(1.0 + 0.9 * std::cos(angle)) + " m, " +
                std::to_string(1.5 + 0.9 * std::sin(angle)) + " m";
    }
    const auto mask = mask_of(region_from_text(star), map);
    EXPECT_EQ(mask(100, 150), 0);
    EXPECT_GT((mask != 0).count(), 1000);
}

TEST(Region, OfHeightsAndPercentilesExcludesUndefinedPoints) {
    auto map = ramp();
    EXPECT_EQ(chosen("include heights 10 nm to 20 nm", map), 11);
    EXPECT_EQ(chosen("include heights above 70.5 nm", map), 10);
    EXPECT_EQ(chosen("include percentiles above 90", map), 8);
    EXPECT_EQ(chosen("include percentiles 25 to 75", map), 40);
    map.heights.row(9).setConstant(undefined);  // the eight highest
    EXPECT_EQ(chosen("include heights above 70.5 nm", map), 2);
    EXPECT_EQ(chosen("include percentiles 0 to 100", map), 72);
    map.heights.setConstant(undefined);
    EXPECT_THROW((void)chosen("include percentiles above 90", map), UndefinedDataError);
}

TEST(Region, GrowsByRowsAndColumns) {
    EXPECT_EQ(chosen("include rectangle 4 um to 4 um, 4 um to 4 um grow 1"), 9);
    EXPECT_EQ(chosen("include rectangle 0 um to 0 um, 0 um to 0 um grow 2"), 9);
    EXPECT_EQ(chosen("include rectangle 9 um to 9 um, 3 um to 3 um grow 20"), 80);
    EXPECT_EQ(chosen("exclude heights above 79.5 nm grow 1"), 76);
    const auto mask = mask_of(region_from_text("include rectangle 4 um to 4 um, 4 um to 4 um grow 2"), ramp());
    EXPECT_EQ(mask(6, 2), 1);
    EXPECT_EQ(mask(7, 4), 0);
}

TEST(Region, IsTheUnionOfIncludedShapesLessTheExcludedOnes) {
    EXPECT_EQ(
        chosen(
            "include rectangle 0 um to 1 um; include rectangle 1 um to 3 um; exclude rectangle all, 0 um to 0 um; exclude rectangle 3 um to 9 um"),
        3 * 7);
}

TEST(Region, OfLinesUsesRangesOfXAndHeights) {
    const LineScan scan{Array1D::LinSpaced(11, 0.0, 1e-6), 11e-6};
    const auto mask = mask_of(region_from_text("include rectangle 3 um to 5 um; include heights above 0.95 um"), scan);
    EXPECT_EQ(mask.rows(), 11);
    EXPECT_EQ(mask.cols(), 1);
    EXPECT_EQ((mask != 0).count(), 4);
    const Profile profile{Array1D::LinSpaced(11, 1e6, 1e6 + 1.0), Array1D::Zero(11), {}};
    EXPECT_EQ((mask_of(region_from_text("exclude rectangle above 1000000.75 m"), profile) != 0).count(), 8);
    EXPECT_THROW((void)mask_of(region_from_text("include ellipse 0 m, 0 m, 1 m, 1 m"), scan), InvalidArgument);
    EXPECT_THROW((void)mask_of(region_from_text("include polygon 0 m, 0 m, 1 m, 0 m, 0 m, 1 m"), scan),
                 InvalidArgument);
    EXPECT_THROW((void)mask_of(region_from_text("include rectangle 0 m to 1 m, 0 m to 1 m"), scan), InvalidArgument);
}

TEST(Region, WrittenAsTextReadsBackTheSame) {
    for (const std::string text :
         {"include rectangle 1 um to 5 um, 0 m to 2 um; exclude heights above 20 nm grow 3",
          "exclude ellipse 5 um, 5 um, 2 um, 1 um, 30 deg", "include polygon 0 m, 0 m, 4 um, 0 m, 2 um, 3.25 um",
          "include percentiles 5 to 95.5; exclude percentiles below 7", "include rectangle all, below 3 mm",
          "exclude heights 0.1 nm to 123456.789 nm", ""}) {
        const auto region = region_from_text(text);
        EXPECT_EQ(region_from_text(processing::text(region)), region) << text;
    }
    EXPECT_EQ(processing::text(region_from_text("exclude   heights above 2e-8 m  grow 3")),
              "exclude heights above 20 nm grow 3");
}

std::string complaint(const std::string& text) {
    try {
        (void)chosen(text);
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Region, WhenInvalidIsNamedInTheError) {
    EXPECT_EQ(
        complaint("rectangle 1 um to 2 um"),
        "region 'rectangle 1 um to 2 um': 'rectangle' begins no shape; expected include or exclude before each shape");
    EXPECT_NE(complaint("exclude heights above 20").find("region 'exclude heights above 20': "), std::string::npos);
    EXPECT_NE(complaint("exclude circle 1 um").find("'circle' is not a shape; expected rectangle"), std::string::npos);
    EXPECT_NE(complaint("exclude ellipse 1 um, 2 um").find("got 2 values"), std::string::npos);
    EXPECT_NE(complaint("exclude polygon 1 um, 2 um, 3 um, 4 um").find("at least three corners, got 4 values"),
              std::string::npos);
    EXPECT_NE(complaint("exclude percentiles 5").find("'5' is not a range"), std::string::npos);
    EXPECT_NE(complaint("exclude percentiles 5 to 120").find("expected 0 … 100"), std::string::npos);
    EXPECT_NE(complaint("exclude heights 5 nm to 1 nm").find("expected from <= to"), std::string::npos);
    EXPECT_NE(complaint("exclude rectangle 0 um to 1 um grow -1").find("grow -1"), std::string::npos);
    EXPECT_NE(complaint("exclude ellipse 0 um, 0 um, 0 um, 1 um").find("expected lengths > 0"), std::string::npos);
}

TEST(MaskOut, MakesTheRegionUndefined) {
    const auto done = apply(MaskOut{region_from_text("include heights above 70.5 nm")}, ramp());
    EXPECT_EQ(map_of(done).heights.isNaN().count(), 10);
    EXPECT_EQ(number_of(done.record, "masked_points"), 10.0);
    EXPECT_DOUBLE_EQ(number_of(done.record, "masked_share"), 0.125);
    EXPECT_THROW((void)apply(MaskOut{}, ramp()), InvalidArgument);
    EXPECT_THROW((void)apply(MaskOut{region_from_text("include heights above 0 nm")}, ramp()), UndefinedDataError);
}

TEST(MaskOut, RemovesPointsOfAPolyline) {
    Profile profile{Array1D::LinSpaced(5, 0.0, 4.0), Array1D::LinSpaced(5, 0.0, 4.0), {}};
    profile.standard_error = Array1D::LinSpaced(5, 1.0, 5.0);
    const auto kept = profile_of(apply(MaskOut{region_from_text("include rectangle 1 m to 2 m")}, profile));
    ASSERT_EQ(kept.positions.size(), 3);
    EXPECT_EQ(kept.positions[1], 3.0);
    EXPECT_EQ(kept.standard_error[1], 4.0);
}

}  // namespace
}  // namespace setae::processing::region_test
