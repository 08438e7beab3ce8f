// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/afm.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace afm_test {

using namespace setae;
using namespace setae::simulation;
using topography::HeightMap;

/// A tip that follows any surface of slope below 2.
const topography::Tip needle = topography::ConeTip{0.4, 0.0};

HeightMap flat(Index nx = 64, Index ny = 64, double pixel = 1e-9) {
    return {Array2D::Zero(nx, ny), {static_cast<double>(nx) * pixel, static_cast<double>(ny) * pixel}, true, {}};
}

AfmOptions small_map(Index nx = 64, Index ny = 64, double pixel = 1e-9) {
    AfmOptions options;
    options.tip = needle;
    options.nx = nx;
    options.ny = ny;
    options.size = static_cast<double>(nx) * pixel;
    options.touch.threads = {1};
    return options;
}

TEST(AfmMap, ReadsTheDilatedSurfaceAtItsPixels) {
    HeightMap surface{2e-9 * tests::random_map(120, 90, 5), {120e-9, 90e-9}, true, {}};
    auto options = small_map(30, 20, 3e-9);
    options.tip = topography::SphereTip{8e-9};
    options.tip_radius_standard_error = 1e-9;
    options.start_x = 10e-9;
    options.start_y = 50e-9;  // over the period's end
    const auto map = afm_map(surface, options);
    const auto touched = dilated(surface, options.tip);
    for (Index i = 0; i < 30; ++i)
        for (Index j = 0; j < 20; ++j)
            EXPECT_EQ(map.heights(i, j), touched.heights((10 + 3 * i) % 120, (50 + 3 * j) % 90));
    EXPECT_NEAR(map.size[1], 60e-9, 1e-22);
    EXPECT_EQ(map.metadata.instrument.type, "afm");
    EXPECT_EQ(map.metadata.instrument.tip_radius, 8e-9);
    EXPECT_EQ(map.metadata.instrument.tip_radius_standard_error, 1e-9);
    EXPECT_TRUE((afm_map(topography::Dilator(surface, options.tip), options).heights == map.heights).all());
}

TEST(AfmMap, LagsARampByItsSlopeTimesTheFeedbackLag) {
    // λ z' + z = s x with z(0) = 0: z = s (x − λ (1 − exp(−x/λ)))
    auto surface = flat();
    surface.periodic = false;
    const double slope = 0.3, lag = 5e-9;
    for (Index i = 0; i < 64; ++i) surface.heights.row(i).setConstant(slope * 1e-9 * static_cast<double>(i));
    auto options = small_map();
    options.feedback_lag = lag;
    const auto map = afm_map(surface, options);
    for (Index i = 0; i < 64; ++i) {
        const double x = 1e-9 * static_cast<double>(i);
        EXPECT_NEAR(map.heights(i, 7), slope * (x - lag * (1.0 - std::exp(-x / lag))), 1e-22);
    }
}

TEST(AfmMap, FollowsAWaveAsAFirstOrderFilter) {
    // amplitude 1/√(1 + (qλ)²) once the start has died out; straight pieces of 40 a wave read the wave 0.2 % low
    auto surface = flat(400, 4);
    const double wave = 2.0 * pi / 40e-9, amplitude = 1e-9, lag = 10e-9;
    for (Index i = 0; i < 400; ++i)
        surface.heights.row(i).setConstant(amplitude * std::cos(wave * 1e-9 * static_cast<double>(i)));
    auto options = small_map(400, 4);
    options.feedback_lag = lag;
    const auto map = afm_map(surface, options);
    const Array1D settled = map.heights.col(0).segment(200, 160);  // four waves, 20 lags on
    double cosine = 0.0, sine = 0.0;
    for (Index i = 0; i < 160; ++i) {
        cosine += settled[i] * std::cos(wave * 1e-9 * static_cast<double>(i)) / 80.0;
        sine += settled[i] * std::sin(wave * 1e-9 * static_cast<double>(i)) / 80.0;
    }
    const double shrunk = 1.0 / (1.0 + std::pow(wave * lag, 2));
    EXPECT_NEAR(cosine, amplitude * shrunk, 0.003 * amplitude);
    EXPECT_NEAR(sine, amplitude * shrunk * wave * lag, 0.003 * amplitude);
}

TEST(AfmMap, JumpsToTheSurfaceAfterAHole) {
    auto surface = flat(20, 4);
    surface.heights.bottomRows(10).setConstant(1e-9);
    surface.heights.row(10).setConstant(undefined);
    auto options = small_map(20, 4);
    options.feedback_lag = 2e-9;
    const auto map = afm_map(surface, options);
    EXPECT_TRUE(std::isnan(map.heights(10, 2)));
    EXPECT_EQ(map.heights(9, 2), 0.0);
    EXPECT_NEAR(map.heights(11, 2), 1e-9 * (1.0 - std::exp(-0.5)), 1e-23);
    EXPECT_NEAR(map.heights(12, 2), 1e-9 * (1.0 - std::exp(-1.0)), 1e-23);
}

TEST(AfmMap, HasTheRequestedBowAndTilt) {
    auto options = small_map(65, 33);
    options.tilt_x = 0.02;
    options.tilt_y = -0.01;
    options.bow = 3e-9;
    const auto map = afm_map(flat(65, 33), options);
    EXPECT_EQ(map.heights(0, 0), 0.0);
    EXPECT_NEAR(map.heights(64, 0), 0.02 * 64e-9, 1e-23);
    EXPECT_NEAR(map.heights(0, 32), -0.01 * 32e-9, 1e-23);
    EXPECT_NEAR(map.heights(32, 5), 0.02 * 32e-9 - 0.01 * 5e-9 + 3e-9, 1e-22);
}

TEST(AfmMap, ShiftsWholeLinesByOffsetsAndARandomWalk) {
    const Index lines = 2000;
    auto options = small_map(2, lines);
    options.key = {4, 0};
    options.line_offset_rms = 0.3e-9;
    auto map = afm_map(flat(2, lines), options);
    EXPECT_TRUE((map.heights.row(0) == map.heights.row(1)).all());
    const double tolerance = 4.0 / std::sqrt(2.0 * static_cast<double>(lines));
    EXPECT_NEAR(std::sqrt(map.heights.row(0).square().mean()) / 0.3e-9, 1.0, tolerance);
    options.line_offset_rms = 0.0;
    options.line_drift_rms = 0.2e-9;
    map = afm_map(flat(2, lines), options);
    const Array1D walk = map.heights.row(1).transpose();
    EXPECT_EQ(walk[0], 0.0);
    const Array1D steps = walk.tail(lines - 1) - walk.head(lines - 1);
    EXPECT_NEAR(std::sqrt(steps.square().mean()) / 0.2e-9, 1.0, tolerance);
    EXPECT_NEAR((steps.head(lines - 2) * steps.tail(lines - 2)).mean() / 0.04e-18, 0.0,
                4.0 / std::sqrt(static_cast<double>(lines)));
}

TEST(AfmMap, HasWhiteNoiseAndTheSameBytesForAnyNumberOfThreads) {
    auto options = small_map(200, 150);
    options.noise_rms = 0.05e-9;
    options.key = {8, 1};
    const auto map = afm_map(flat(), options);
    EXPECT_NEAR(std::sqrt(map.heights.square().mean()) / 0.05e-9, 1.0, 4.0 / std::sqrt(2.0 * 30000.0));
    options.touch.threads = {3};
    EXPECT_TRUE((afm_map(flat(), options).heights == map.heights).all());
}

TEST(AfmMap, RefusesInvalidOptions) {
    const auto refuses = [](const std::function<void(AfmOptions&)>& change) {
        auto options = small_map();
        change(options);
        EXPECT_THROW((void)afm_map(flat(), options), InvalidArgument);
    };
    refuses([](AfmOptions& o) { o.nx = 1; });
    refuses([](AfmOptions& o) { o.size = 0.0; });
    refuses([](AfmOptions& o) { o.feedback_lag = -1e-9; });
    refuses([](AfmOptions& o) { o.line_drift_rms = undefined; });
    refuses([](AfmOptions& o) { o.tip = topography::SphereTip{-1e-9}; });
    auto window = flat();
    window.periodic = false;
    auto options = small_map();
    options.start_x = 1e-9;
    EXPECT_THROW((void)afm_map(window, options), InvalidArgument);
}

}  // namespace afm_test
