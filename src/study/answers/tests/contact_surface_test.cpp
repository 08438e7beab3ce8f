// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/contact_surface.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/answers/contact_front.hpp"
#include "setae/answers/hard_wall.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::answers::contact_surface_test {
namespace {

topography::HeightMap repeating(Index n) {
    const auto density = spectra::density(spectra::SelfAffine{1.0, 2.0 * pi / 0.3e-6, 0.8, 2.0 * pi / 40e-9});
    auto map = synthesis::random_surface(density, {n, n, 1e-6, 1e-6}, {.key = {5}});
    map.heights *= 2e-9 / std::sqrt(map.heights.square().mean());
    map.periodic = false;  // as a file of numbers has it
    return map;
}

/// A quarter of a surface, on a slope.
topography::HeightMap measured(double rise) {
    const auto whole = repeating(256);
    topography::HeightMap map{whole.heights.topLeftCorner(128, 128), {0.5e-6, 0.5e-6}, false, {}};
    for (Index j = 0; j < 128; ++j) map.heights.col(j) += rise * static_cast<double>(j) / 128.0;
    return map;
}

processing::PipelineResult taken(topography::HeightMap map, const MeasuredSurfaceRequest& request = {},
                                 BeyondMap beyond = BeyondMap::itself, const processing::Pipeline& pipeline = {}) {
    return into_contact(processing::apply(pipeline, std::move(map)), pipeline, {}, request, beyond);
}

const topography::HeightMap& map_in(const processing::PipelineResult& result) {
    return std::get<topography::HeightMap>(result.measurement);
}

double area_of(const processing::PipelineResult& result) {
    HardWallRequest request;
    request.contact_modulus = "1 GPa";
    request.pressure = "2 MPa";
    const auto answer = hard_wall("map", result.measurement, request);
    for (const auto& quantity : answer.quantities)
        if (quantity.quantity == "area_fraction") return quantity.estimate.value;
    return undefined;
}

TEST(SurfaceInContact, IsLevelledForAnyTilt) {
    const auto level = taken(measured(0.0)), tilted = taken(measured(60e-9));
    EXPECT_LT((map_in(level).heights - map_in(tilted).heights).abs().maxCoeff(), 1e-20);
    ASSERT_FALSE(tilted.records.empty());
    EXPECT_EQ(tilted.records.front().step, "level_plane");
    EXPECT_NEAR(area_of(level), area_of(tilted), 1e-12);
    const auto unlevelled = taken(measured(60e-9), {.trend = "none"});
    EXPECT_TRUE(unlevelled.records.empty());
    EXPECT_LT(area_of(unlevelled), 0.8 * area_of(level));
}

TEST(SurfaceInContact, WarnsOfTheStepAtThePeriodicBoundary) {
    const auto result = taken(measured(60e-9));
    const auto& alerts = map_in(result).metadata.alerts;
    ASSERT_EQ(alerts.size(), 1U);
    EXPECT_EQ(alerts.front().code, "MAP_NOT_PERIODIC");
    EXPECT_NE(alerts.front().message.find(" nm (rms)"), std::string::npos) << alerts.front().message;
    HardWallRequest request;
    request.contact_modulus = "1 GPa";
    request.pressure = "2 MPa";
    const auto answer = hard_wall("map", result.measurement, request);
    ASSERT_EQ(answer.alerts.size(), 1U);
    EXPECT_EQ(answer.alerts.front().code, "MAP_NOT_PERIODIC");
}

TEST(SurfaceInContact, HasNoBoundaryWarningWithFreeEdges) {
    EXPECT_TRUE(map_in(taken(measured(60e-9), {}, BeyondMap::nothing)).metadata.alerts.empty());
    EXPECT_EQ(taken(measured(60e-9), {}, BeyondMap::nothing).records.front().step, "level_plane");
}

TEST(SurfaceInContact, OfPeriodicHeightsIsUnchanged) {
    const auto map = repeating(128);
    const auto result = taken(map);
    EXPECT_TRUE(result.records.empty());
    EXPECT_TRUE(map_in(result).periodic);
    EXPECT_TRUE(map_in(result).metadata.alerts.empty());
    EXPECT_TRUE((map_in(result).heights == map.heights).all());
}

TEST(SurfaceInContact, IsPeriodicOnRequest) {
    const auto result = taken(measured(60e-9), {.edges = "periodic"});
    EXPECT_TRUE(result.records.empty());
    EXPECT_TRUE(map_in(result).periodic);
    EXPECT_TRUE(map_in(result).metadata.alerts.empty());
}

TEST(SurfaceInContact, IsPeriodicAfterAWindow) {
    const auto result = taken(measured(60e-9), {.edges = "windowed"});
    EXPECT_TRUE(map_in(result).periodic);
    EXPECT_TRUE(map_in(result).metadata.alerts.empty());
    ASSERT_EQ(result.records.size(), 2U);
    EXPECT_EQ(result.records.back().step, "window_edges");
}

TEST(SurfaceInContact, IsLevelledOnlyOnceByAPipelineThatLevels) {
    const processing::Pipeline pipeline{.entries = {{processing::step_named("level_polynomial")}}};
    const auto result = taken(measured(60e-9), {}, BeyondMap::itself, pipeline);
    ASSERT_EQ(result.records.size(), 1U);
    EXPECT_EQ(result.records.front().step, "level_polynomial");
}

TEST(SurfaceInContact, OfAStylusHasAParabolaRemoved) {
    auto map = measured(60e-9);
    map.metadata.instrument.type = "stylus";
    EXPECT_EQ(taken(map).records.front().step, "level_polynomial");
}

TEST(SurfaceInContact, RefusesUnknownOptions) {
    EXPECT_THROW((void)taken(measured(0.0), {.edges = "open"}), InvalidArgument);
    EXPECT_THROW((void)taken(measured(0.0), {.trend = "cubic"}), InvalidArgument);
}

}  // namespace
}  // namespace setae::answers::contact_surface_test
