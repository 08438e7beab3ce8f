// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "grids/registration.hpp"
#include "setae/core/errors.hpp"
#include "setae/processing/combine_maps.hpp"

namespace setae::processing::combine_maps_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Measurement;

/// A rough surface defined everywhere: cosines of random wavevectors, amplitude ~ 1/q².
class Surface {
public:
    Surface() {
        std::mt19937 generator(11);
        std::uniform_real_distribution<double> uniform;
        for (int k = 0; k < 100; ++k) {
            const double q = 0.1 * std::pow(12.0, uniform(generator)),
                         angle = 2.0 * std::numbers::pi * uniform(generator);
            waves_.push_back({q * std::cos(angle), q * std::sin(angle), 2.0 * std::numbers::pi * uniform(generator),
                              0.035 / (q * q)});
        }
    }
    [[nodiscard]] double operator()(double x, double y) const {
        double sum = 0.0;
        for (const auto& [qx, qy, phase, amplitude] : waves_) sum += amplitude * std::cos(qx * x + qy * y + phase);
        return sum;
    }

private:
    std::vector<std::array<double, 4>> waves_;
};

HeightMap scanned(const Surface& surface, Index nx, Index ny, double from_x, double from_y, double pixel = 1.0) {
    return {Array2D::NullaryExpr(nx, ny,
                                 [&](Index i, Index j) {
                                     return surface(from_x + pixel * static_cast<double>(i),
                                                    from_y + pixel * static_cast<double>(j));
                                 }),
            {pixel * static_cast<double>(nx), pixel * static_cast<double>(ny)},
            false,
            {}};
}

TEST(ShiftBetween, FindsSubPixelShiftsOfRoughMaps) {
    const Surface surface;
    const HeightMap fixed = scanned(surface, 72, 64, 20.0, 20.0);
    for (const auto& [dx, dy] : {std::array<double, 2>{0.0, 0.0}, {0.37, -0.81}, {7.25, 12.6}, {-15.4, 3.3}}) {
        // moved(x + d) = fixed(x): the other scan begins d earlier
        HeightMap moved = scanned(surface, 72, 64, 20.0 - dx, 20.0 - dy);
        moved.heights += 5.0 + 0.01 * Array2D::NullaryExpr(72, 64, [](Index i, Index) {
                                   return static_cast<double>(i);
                               });  // another tilt and offset
        const Shift shift = shift_between(fixed, moved);
        EXPECT_NEAR(shift.x, dx, 0.02);
        EXPECT_NEAR(shift.y, dy, 0.02);
        EXPECT_GT(shift.agreement, 0.99);
    }
}

TEST(ShiftBetween, WorksWithNoiseHolesAndOtherShapes) {
    const Surface surface;
    std::mt19937 generator(2);
    std::normal_distribution<double> noise(0.0, 0.05);
    HeightMap fixed = scanned(surface, 72, 64, 20.0, 20.0), moved = scanned(surface, 80, 70, 14.6, 17.8);
    for (HeightMap* map : {&fixed, &moved})
        for (double& height : map->heights.reshaped()) height += noise(generator);
    fixed.heights.block(30, 30, 8, 10).setConstant(std::numeric_limits<double>::quiet_NaN());
    moved.heights(50, 60) = std::numeric_limits<double>::quiet_NaN();
    const Shift shift = shift_between(fixed, moved);
    EXPECT_NEAR(shift.x, 5.4, 0.05);
    EXPECT_NEAR(shift.y, 2.2, 0.05);
}

TEST(ShiftBetween, WrapsOnPeriodicMaps) {
    const double q = 2.0 * std::numbers::pi / 64.0;
    const auto periodic = [&](double from_x, double from_y) {
        HeightMap map{Array2D(64, 64), {6.4, 6.4}, true, {}};
        for (Index i = 0; i < 64; ++i)
            for (Index j = 0; j < 64; ++j) {
                const double x = q * (static_cast<double>(i) + from_x), y = q * (static_cast<double>(j) + from_y);
                map.heights(i, j) =
                    std::cos(3.0 * x + y) + 0.5 * std::sin(5.0 * y - 2.0 * x) + 0.25 * std::cos(7.0 * x + 6.0 * y);
            }
        return map;
    };
    const Shift shift = shift_between(periodic(0.0, 0.0), periodic(-10.3, 4.6));
    EXPECT_NEAR(shift.x, 1.03, 1e-3);
    EXPECT_NEAR(shift.y, -0.46, 1e-3);
}

TEST(ShiftBetween, RefusesMapsItCannotCompare) {
    const HeightMap map{Array2D::Random(20, 20), {20.0, 20.0}, false, {}};
    EXPECT_THROW((void)shift_between(map, HeightMap{map.heights, {10.0, 20.0}, false, {}}), InvalidArgument);
    EXPECT_THROW((void)shift_between(map, HeightMap{Array2D::Random(5, 20), {5.0, 20.0}, false, {}}), InvalidArgument);
    EXPECT_THROW((void)shift_between(map, HeightMap{Array2D::Zero(20, 20), {20.0, 20.0}, false, {}}),
                 UndefinedDataError);
}

TEST(CombineMaps, AddsAndSubtractsPointByPointOnEqualGrids) {
    HeightMap a{Array2D::Random(6, 5), {6.0, 5.0}, true, {}}, b{Array2D::Random(6, 5), {6.0, 5.0}, true, {}};
    b.heights(2, 2) = std::numeric_limits<double>::quiet_NaN();
    const auto sum = std::get<HeightMap>(apply(AddMap{}, a, Measurement(b)).measurement),
               difference = std::get<HeightMap>(apply(SubtractMap{}, a, Measurement(b)).measurement);
    EXPECT_EQ(sum.heights(1, 1), a.heights(1, 1) + b.heights(1, 1));
    EXPECT_EQ(difference.heights(1, 1), a.heights(1, 1) - b.heights(1, 1));
    EXPECT_EQ(sum.heights.isNaN().count(), 1);
    EXPECT_TRUE(sum.periodic);
    b.periodic = false;
    EXPECT_FALSE(std::get<HeightMap>(apply(AddMap{}, a, Measurement(b)).measurement).periodic);
}

TEST(CombineMaps, CombinesHeightsInMetresForAnyFileUnits) {
    HeightMap nanometres{Array2D::Constant(3, 3, 5e-9), {3e-6, 3e-6}, false, {}},
        micrometres{Array2D::Constant(3, 3, 1e-6), {3e-6, 3e-6}, false, {}};
    nanometres.metadata.unit = "nm";
    micrometres.metadata.unit = "um";
    EXPECT_DOUBLE_EQ(
        std::get<HeightMap>(apply(AddMap{}, nanometres, Measurement(micrometres)).measurement).heights(1, 1), 1.005e-6);
}

TEST(CombineMaps, InterpolatesOtherGridsOnTheCommonArea) {
    // a coarser map ends earlier: SurfaceTopography raises an error, here the points beyond are undefined
    const HeightMap fine{Array2D::Constant(12, 12, 1.0), {6.0, 6.0}, false, {}};
    const HeightMap coarse{Array2D::NullaryExpr(6, 6, [](Index i, Index j) { return static_cast<double>(i + 2 * j); }),
                           {6.0, 6.0},
                           false,
                           {}};
    const auto difference = std::get<HeightMap>(apply(SubtractMap{}, fine, Measurement(coarse)).measurement);
    EXPECT_NEAR(difference.heights(3, 5), 1.0 - (1.5 + 5.0), 1e-15);
    EXPECT_TRUE(std::isnan(difference.heights(11, 0)));
    EXPECT_EQ(difference.heights.isNaN().count(), 23);
}

TEST(CombineMaps, AlignsARepeatedScanBeforeItIsSubtracted) {
    const Surface surface;
    const HeightMap first = scanned(surface, 80, 80, 20.0, 20.0), second = scanned(surface, 80, 80, 23.3, 18.9);
    const Processed plain = apply(SubtractMap{}, first, Measurement(second)),
                    aligned = apply(SubtractMap{.align = true}, first, Measurement(second));
    const auto rms = [](const Processed& processed) {
        const Array2D& heights = std::get<HeightMap>(processed.measurement).heights;
        const double n = static_cast<double>(heights.size() - heights.isNaN().count());
        return std::sqrt(heights.isNaN().select(0.0, heights).square().sum() / n);
    };
    EXPECT_LT(rms(aligned), 0.1 * rms(plain));
    EXPECT_NEAR(aligned.record.numbers.at(0).estimate.value, -3.3, 0.02);
    EXPECT_NEAR(aligned.record.numbers.at(1).estimate.value, 1.1, 0.02);
    EXPECT_EQ(aligned.record.step, "subtract_map");
}

TEST(CombineMaps, HandlesLines) {
    const LineScan a{Array1D{{1.0, 2.0, 3.0, 4.0}}, 4.0, false, {}}, b{Array1D{{0.0, 2.0}}, 4.0, false, {}};
    const auto sum = std::get<LineScan>(apply(AddMap{}, a, Measurement(b)).measurement);
    EXPECT_LT((sum.heights.head(3) - Array1D{{1.0, 3.0, 5.0}}).abs().maxCoeff(), 1e-15);
    EXPECT_TRUE(std::isnan(sum.heights[3]));
}

TEST(CombineMaps, RefusesIncompatibleMeasurements) {
    const Measurement map = HeightMap{Array2D::Random(6, 5), {6.0, 5.0}, false, {}},
                      line = LineScan{Array1D::Zero(5), 5.0, false, {}};
    const Measurement polyline = topography::Profile{Array1D{{0.0, 1.0}}, Array1D{{0.0, 1.0}}, {}};
    EXPECT_THROW((void)apply(AddMap{}, map, line), InvalidArgument);
    EXPECT_THROW((void)apply(AddMap{}, line, polyline), InvalidArgument);
    EXPECT_THROW((void)apply(AddMap{.align = true}, line, line), InvalidArgument);
    const Measurement hidden =
        HeightMap{Array2D::Constant(6, 5, std::numeric_limits<double>::quiet_NaN()), {6.0, 5.0}, false, {}};
    EXPECT_THROW((void)apply(AddMap{}, map, hidden), InvalidArgument);
}

}  // namespace
}  // namespace setae::processing::combine_maps_test
