// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/geometry/perimeter.hpp"
#include "setae/core/arrays.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::geometry {
namespace {

using topography::Mask;

Mask square(Index n, Index first, Index side) {
    Mask mask = Mask::Zero(n, n);
    mask.block(first, first, side, side) = 1;
    return mask;
}

TEST(EdgeLength, OfACheckerboardIsEveryEdge) {
    const auto mask =
        Mask::NullaryExpr(6, 8, [](Index i, Index j) { return static_cast<std::uint8_t>((i + j) % 2); }).eval();
    const auto open = edge_length(mask, {{1.0, 1.0}, false}), closed = edge_length(mask, {{2.0, 3.0}, true});
    EXPECT_DOUBLE_EQ(open.along_x, 6.0 * 7.0);
    EXPECT_DOUBLE_EQ(open.along_y, 5.0 * 8.0);
    EXPECT_DOUBLE_EQ(closed.along_x, 48.0 * 2.0);
    EXPECT_DOUBLE_EQ(closed.along_y, 48.0 * 3.0);
}

TEST(EdgeLength, OfARingIsThatOfBothItsSquares) {
    Mask ring = square(20, 3, 12);
    ring.block(6, 6, 4, 5) = 0;
    EXPECT_DOUBLE_EQ(edge_length(ring, {}).total(), 4.0 * 12.0 + 2.0 * (4.0 + 5.0));
}

TEST(EdgeLength, HasNoEdgeAtTheBorderOfAnOpenGrid) {
    const Mask half = Mask::NullaryExpr(10, 10, [](Index i, Index) { return static_cast<std::uint8_t>(i < 4); });
    EXPECT_DOUBLE_EQ(edge_length(half, {}).total(), 10.0);
    EXPECT_DOUBLE_EQ(edge_length(half, {{1.0, 1.0}, true}).total(), 20.0);
    EXPECT_DOUBLE_EQ(edge_length(Mask::Ones(4, 4), {}).total(), 0.0);
}

TEST(EdgeLength, OfOneRowOrColumnIsItsEnds) {
    Mask row = Mask::Zero(1, 9);
    row(0, 4) = 1;
    EXPECT_DOUBLE_EQ(edge_length(row, {}).total(), 2.0);
    EXPECT_DOUBLE_EQ(edge_length(row.transpose(), {{1.0, 2.0}, false}).along_y, 4.0);
}

TEST(IsotropicPerimeter, IsRightOnAverageForLinesOfAllDirections) {
    // half planes cut out of a disc: length of the cut is the chord through the centre
    const Index n = 401;
    const double centre = 200.0, radius = 180.0;
    double ratio = 0.0;
    const int directions = 24;
    for (int d = 0; d < directions; ++d) {
        const double angle = std::numbers::pi * (d + 0.37) / directions;
        double edges = 0.0;
        const auto inside = [&](Index i, Index j) {
            return std::hypot(static_cast<double>(i) - centre, static_cast<double>(j) - centre) < radius;
        };
        const auto chosen = [&](Index i, Index j) {
            return (static_cast<double>(i) - centre) * std::cos(angle) +
                       (static_cast<double>(j) - centre) * std::sin(angle) >
                   0.0;
        };
        for (Index i = 0; i + 1 < n; ++i)
            for (Index j = 0; j + 1 < n; ++j) {
                if (inside(i, j) && inside(i + 1, j)) edges += chosen(i, j) != chosen(i + 1, j);
                if (inside(i, j) && inside(i, j + 1)) edges += chosen(i, j) != chosen(i, j + 1);
            }
        ratio += isotropic_perimeter(edges) / (2.0 * radius) / directions;
    }
    EXPECT_NEAR(ratio, 1.0, 5e-3);
}

TEST(CorrectedContactArea, TakesTwelveHundredthsOfAPixelAnEdge) {
    // (π − 1 + ln 2)/24 = 0.11811415976
    EXPECT_NEAR(corrected_contact_area(100.0, 40.0, 1.0), 100.0 - 40.0 * 0.11811415976, 1e-8);
    EXPECT_DOUBLE_EQ(corrected_contact_area(5.0, 0.0, 1.0), 5.0);
    EXPECT_THROW((void)corrected_contact_area(-1.0, 0.0, 1.0), InvalidArgument);
}

TEST(PerimeterPoints, OfASquareAreItsRimInsideAndOutside) {
    const auto mask = square(12, 4, 5);
    EXPECT_EQ(inner_perimeter(mask).cast<int>().sum(), 16);
    EXPECT_EQ(inner_perimeter(mask, Neighbours::edges).cast<int>().sum(), 16);
    EXPECT_EQ(outer_perimeter(mask).cast<int>().sum(), 24);
    EXPECT_EQ(outer_perimeter(mask, Neighbours::edges).cast<int>().sum(), 20);
    EXPECT_EQ(inner_perimeter(mask)(6, 6), 0);
    EXPECT_EQ(outer_perimeter(mask)(3, 3), 1);
}

TEST(PerimeterPoints, OfTheInverseExchangeInsideAndOutside) {
    const auto mask = square(12, 4, 5);
    const Mask inverse = 1 - mask;
    EXPECT_TRUE((inner_perimeter(mask) == outer_perimeter(inverse)).all());
    EXPECT_TRUE(
        (inner_perimeter(mask, Neighbours::edges, true) == outer_perimeter(inverse, Neighbours::edges, true)).all());
}

TEST(PerimeterPoints, MeetAcrossAPeriodicBorder) {
    Mask mask = Mask::Zero(6, 6);
    mask.row(0) = 1;
    EXPECT_EQ(outer_perimeter(mask, Neighbours::edges, false).cast<int>().sum(), 6);
    EXPECT_EQ(outer_perimeter(mask, Neighbours::edges, true).cast<int>().sum(), 12);
}

TEST(EdgeLength, RefusesAnEmptyMaskAndPixelsWithoutSize) {
    EXPECT_THROW((void)edge_length(Mask(0, 0), {}), InvalidArgument);
    EXPECT_THROW((void)edge_length(Mask::Ones(2, 2), {{1.0, std::nan("")}, false}), InvalidArgument);
    EXPECT_THROW((void)inner_perimeter(Mask(3, 0)), InvalidArgument);
}

}  // namespace
}  // namespace setae::geometry
