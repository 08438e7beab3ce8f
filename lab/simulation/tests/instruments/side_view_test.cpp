// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/side_view.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/simulation/silhouette.hpp"
#include "setae/topography/contour.hpp"

namespace side_view_test {

using namespace setae;
using namespace setae::simulation;
using topography::HeightMap;

HeightMap map_of(const std::function<double(double, double)>& height, Index nx, Index ny, bool periodic = true) {
    HeightMap map{Array2D(nx, ny), {static_cast<double>(nx), static_cast<double>(ny)}, periodic, {}};
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) map.heights(i, j) = height(static_cast<double>(i), static_cast<double>(j));
    return map;
}

TEST(Silhouette, OfAFoilWithoutThicknessEqualsTheLineScan) {
    const HeightMap map{tests::random_map(30, 20), {30.0, 20.0}, true, {}};
    EXPECT_TRUE((silhouette(map, 0.0, 7.0).heights == map.heights.col(7)).all());
    EXPECT_TRUE((silhouette(map, 0.0, -1.0).heights == map.heights.col(19)).all());
}

TEST(Silhouette, OfRidgesAlongTheBeamEqualsTheirSection) {
    const auto map = map_of([](double x, double) { return std::sin(x); }, 30, 20);
    EXPECT_TRUE((silhouette(map, 13.0).heights == map.heights.col(0)).all());
}

TEST(Silhouette, OfCrossedWavesRisesByTheAmplitudeAlongTheBeam) {
    const auto map =
        map_of([](double x, double y) { return std::sin(0.3 * x) + 0.5 * std::cos(0.1 * pi * y); }, 30, 20);
    const Array1D shift = silhouette(map, 19.0, 3.0).heights - map.heights.col(10);
    EXPECT_LT((shift - 1.0).abs().maxCoeff(), 1e-15);  // cos = −1 at y = 10: 2 · 0.5
}

TEST(Silhouette, IncludesTheGridPointOnTheFarFaceOfTheFoil) {
    auto map = map_of([](double, double) { return 0.0; }, 4, 10, false);
    map.size[1] = 10 * 0.1;  // 0.1 is no binary number
    map.heights.col(7).setConstant(1.0);
    EXPECT_EQ(silhouette(map, 0.3, 0.4).heights[0], 1.0);
    EXPECT_EQ(silhouette(map, 0.25, 0.4).heights[0], 0.0);
}

TEST(Silhouette, IgnoresUndefinedHeights) {
    auto map = map_of([](double, double y) { return y; }, 4, 10);
    map.heights(1, 5) = undefined;
    map.heights.row(2).setConstant(undefined);
    const auto seen = silhouette(map, 5.0).heights;
    EXPECT_EQ(seen[0], 5.0);
    EXPECT_EQ(seen[1], 4.0);
    EXPECT_TRUE(std::isnan(seen[2]));
}

TEST(Silhouette, RefusesAFoilOutsideTheSurface) {
    const auto map = map_of([](double, double y) { return y; }, 4, 10, false);
    EXPECT_NO_THROW((void)silhouette(map, 9.0));
    EXPECT_THROW((void)silhouette(map, 10.0), InvalidArgument);
    EXPECT_THROW((void)silhouette(map, 3.0, 7.0), InvalidArgument);
    EXPECT_THROW((void)silhouette(map, -1.0), InvalidArgument);
    EXPECT_THROW((void)silhouette(map, undefined), InvalidArgument);
}

FoilContourOptions contour_of(double length, double step) {
    FoilContourOptions options;
    options.length = length;
    options.step = step;
    options.key = {21, 0};
    return options;
}

TEST(SideViewContour, FollowsTheSilhouetteBetweenGridPoints) {
    const auto map = map_of([](double x, double y) { return x * (x < 20.0 ? 1.0 : 0.0) - y; }, 40, 20, false);
    auto options = contour_of(15.0, 0.5);
    options.steps = ContourSteps::regular;
    options.start_x = 2.0;
    options.start_y = 3.0;
    options.thickness = 6.0;
    const auto contour = projected_contour(map, options);
    ASSERT_EQ(contour.positions.size(), 31);
    for (Index k = 0; k < 31; ++k) {
        EXPECT_EQ(contour.positions[k], 0.5 * static_cast<double>(k));
        EXPECT_NEAR(contour.heights[k], contour.positions[k] + 2.0 - 3.0, 1e-14);
    }
    EXPECT_EQ(contour.metadata.instrument.type, "tem");
    EXPECT_EQ(contour.metadata.attributes.at("foil_thickness"), "6 m");
}

TEST(SideViewContour, StepsFollowTheirDistribution) {
    const auto map = map_of([](double, double) { return 0.0; }, 8, 8);
    for (const auto law : {ContourSteps::uniform, ContourSteps::gamma}) {
        auto options = contour_of(10000.0, 0.5);
        options.steps = law;
        options.step_spread = law == ContourSteps::gamma ? 0.5 : 0.4;  // gamma: ν = 8 exactly
        const auto x = projected_contour(map, options).positions;
        const auto n = x.size() - 1;
        const Array1D steps = (x.tail(n) - x.head(n)) / 0.5;
        const double points = static_cast<double>(n);
        EXPECT_GT(steps.minCoeff(), 0.0);
        EXPECT_NEAR(steps.mean(), 1.0, 4.0 * options.step_spread / std::sqrt(points));
        // standard error of the rms: √((κ − 1)/4n), kurtosis κ = 3 + 12/ν of the gamma law, below 3 of the uniform
        const double spread = std::sqrt((steps - steps.mean()).square().mean());
        EXPECT_NEAR(spread / options.step_spread, 1.0, 4.0 * std::sqrt(3.5 / (4.0 * points)));
        if (law == ContourSteps::uniform) {
            EXPECT_GE(steps.minCoeff(), 1.0 - std::sqrt(3.0) * 0.4 - 1e-9);
        }
    }
}

TEST(SideViewContour, BlurDampsAWaveByItsGaussian) {
    const double wave = 2.0 * pi / 50.0, blur = 6.0;
    const auto map = map_of([&](double x, double) { return std::cos(wave * x); }, 200, 4);
    auto options = contour_of(199.0, 1.0);
    options.steps = ContourSteps::regular;
    options.blur = blur;
    const auto contour = projected_contour(map, options);
    const double damping = std::exp(-0.5 * std::pow(wave * blur, 2));
    for (Index k = 0; k < contour.heights.size(); ++k)
        EXPECT_NEAR(contour.heights[k], damping * std::cos(wave * static_cast<double>(k)),
                    1e-7);  // cut at six rms radii
}

TEST(SideViewContour, TraceNoiseHasItsRmsAndCorrelationLength) {
    const auto map = map_of([](double, double) { return 0.0; }, 8, 8);
    auto options = contour_of(30000.0, 0.5);
    options.steps = ContourSteps::regular;
    options.trace_noise_rms = 0.2;
    options.trace_noise_length = 2.0;
    const auto heights = projected_contour(map, options).heights;
    // independent values: length/(√π ℓ), as ∫ exp(−d²/ℓ²) dd = √π ℓ
    const double error = std::sqrt(2.0 * std::sqrt(pi) * 2.0 / 30000.0);
    const auto correlation = [&](Index lag) {
        return (heights.head(heights.size() - lag) * heights.tail(heights.size() - lag)).mean() / 0.04;
    };
    EXPECT_NEAR(correlation(0), 1.0, 4.0 * error);
    EXPECT_NEAR(correlation(4), std::exp(-0.5), 4.0 * error);
    EXPECT_NEAR(correlation(16), std::exp(-8.0), 4.0 * error);
    EXPECT_TRUE((projected_contour(map, options).heights == heights).all());
}

TEST(SideViewContour, CleaningCutsOnlyReentrantStretches) {
    const HeightMap map{tests::random_map(300, 4), {300.0, 4.0}, true, {}};
    auto options = contour_of(299.0, 0.5);
    const auto straight = projected_contour(map, options);
    options.reentrant_share = 0.1;
    options.reentrant_points = 3;
    const auto traced = projected_contour(map, options);
    ASSERT_TRUE((traced.heights == straight.heights).all());
    std::vector<Index> kept;
    for (Index k = 0; k < traced.positions.size(); ++k)
        if (traced.positions[k] == straight.positions[k]) kept.push_back(k);
    const auto cleaned = topography::clean_contour(traced);
    const auto moved = straight.positions.size() - static_cast<Index>(kept.size());
    EXPECT_EQ(cleaned.reentrant_points, moved);
    EXPECT_TRUE((cleaned.profile.positions == straight.positions(kept)).all());
    EXPECT_TRUE((cleaned.profile.heights == straight.heights(kept)).all());
    // whole blocks of 30 points have three each
    EXPECT_NEAR(static_cast<double>(moved) / static_cast<double>(straight.positions.size()), 0.1,
                3.0 / static_cast<double>(straight.positions.size()));
}

TEST(SideViewContour, RefusesInvalidOptions) {
    auto map = map_of([](double, double) { return 0.0; }, 20, 8, false);
    const auto refuses = [&](const std::function<void(FoilContourOptions&)>& change) {
        auto options = contour_of(10.0, 0.5);
        change(options);
        EXPECT_THROW((void)projected_contour(map, options), InvalidArgument);
    };
    refuses([](FoilContourOptions& o) { o.step = 0.0; });
    refuses([](FoilContourOptions& o) { o.step = 11.0; });
    refuses([](FoilContourOptions& o) { o.step_spread = 2.0; });
    refuses([](FoilContourOptions& o) { o.reentrant_share = 0.6; });
    refuses([](FoilContourOptions& o) { o.length = 25.0; });
    refuses([](FoilContourOptions& o) { o.thickness = 9.0; });
    refuses([](FoilContourOptions& o) { o.blur = -1.0; });
    map.heights.row(5).setConstant(undefined);
    EXPECT_THROW((void)projected_contour(map, contour_of(10.0, 0.5)), UndefinedDataError);
}

}  // namespace side_view_test
