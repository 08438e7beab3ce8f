// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/stylus.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/artefact.hpp"

namespace stylus_test {

using namespace setae;
using namespace setae::simulation;
using topography::HeightMap;
using topography::LineScan;

HeightMap rough_strip(Index nx = 600, Index ny = 20) {
    return {1e-8 * tests::random_map(nx, ny, 3),
            {static_cast<double>(nx) * 1e-7, static_cast<double>(ny) * 1e-7},
            true,
            {}};
}

StylusOptions short_scan() {
    StylusOptions options;
    options.length = 50e-6;
    options.step = 0.1e-6;
    options.start_y = 1e-6;
    options.touch.threads = {1};
    return options;
}

double rms(const Array1D& values) { return std::sqrt(values.square().mean()); }

TEST(StylusScan, ReadsTheDilatedSurfaceAtItsSteps) {
    const auto strip = rough_strip();
    auto options = short_scan();
    options.step = 0.3e-6;  // every third point
    options.length = 45e-6;
    options.start_x = 2e-6;
    const auto scan = stylus_scan(strip, options);
    const auto touched = dilated(strip, options.tip);
    ASSERT_EQ(scan.heights.size(), 150);
    for (Index i = 0; i < 150; ++i) EXPECT_EQ(scan.heights[i], touched.heights(20 + 3 * i, 10));
    EXPECT_NEAR(scan.pixel_size(), 0.3e-6, 1e-20);
    EXPECT_FALSE(scan.periodic);
    EXPECT_EQ(scan.metadata.instrument.type, "stylus");
    EXPECT_EQ(scan.metadata.instrument.tip_radius, 5e-6);
}

TEST(StylusScan, ShowsAWaveShorterThanTwoStepsAsItsAlias) {
    // wavelength 1.25 steps: the same points as wavelength 5 steps, for a tip that follows the surface to R h'²/2
    const Index n = 1000;
    HeightMap strip{Array2D(n, 4), {100e-6, 0.4e-6}, true, {}};
    const double amplitude = 1e-9, wave = 2.0 * pi / 1.25e-6;
    for (Index i = 0; i < n; ++i)
        strip.heights.row(i).setConstant(amplitude * std::cos(wave * 1e-7 * static_cast<double>(i)));
    auto options = short_scan();
    options.start_y = 0.0;
    options.step = 1e-6;
    options.tip = topography::SphereTip{1e-6};
    const auto scan = stylus_scan(strip, options);
    const double most = 0.5 * 1e-6 * std::pow(amplitude * wave, 2);
    for (Index i = 0; i < scan.heights.size(); ++i)
        EXPECT_NEAR(scan.heights[i], amplitude * std::cos(2.0 * pi * static_cast<double>(i) / 5.0), most);
}

TEST(ReferenceScan, WithTiltAndBowIsALinePlusAParabola) {
    auto options = short_scan();
    options.tilt = 1e-3;
    options.bow = 40e-9;
    const auto scan = reference_scan(options);
    const auto n = scan.heights.size();
    EXPECT_EQ(scan.heights[0], 0.0);
    EXPECT_NEAR(scan.heights[n - 1], 1e-3 * 0.1e-6 * static_cast<double>(n - 1), 1e-20);
    options.length = options.step * static_cast<double>(n + 1);  // a point in the middle
    const auto odd = reference_scan(options);
    EXPECT_NEAR(odd.heights[n / 2], 1e-3 * 0.1e-6 * static_cast<double>(n / 2) + 40e-9, 1e-20);
}

TEST(StylusScan, AddsTheArtefactThatAReferenceScanMeasures) {
    const auto strip = rough_strip();
    auto options = short_scan();
    const auto bare = stylus_scan(strip, options);
    options.tilt = 2e-4;
    options.bow = 5e-9;
    options.noise_rms = 1e-9;
    options.artefact = {3e-9, 20e-6, {7, 0}};
    options.key = {5, 2};
    const auto full = stylus_scan(strip, options);
    const auto reference = reference_scan(options);
    EXPECT_LT((full.heights - bare.heights - reference.heights).abs().maxCoeff(), 1e-20);
}

TEST(StylusScan, HasWhiteNoiseOfTheGivenRmsFromItsKey) {
    auto options = short_scan();
    options.length = 2e-3;  // 20000 points
    options.noise_rms = 0.5e-9;
    options.key = {11, 0};
    const auto scan = reference_scan(options);
    const double n = static_cast<double>(scan.heights.size());
    EXPECT_NEAR(rms(scan.heights) / 0.5e-9, 1.0, 4.0 / std::sqrt(2.0 * n));
    const Array1D shifted = scan.heights.head(scan.heights.size() - 1) * scan.heights.tail(scan.heights.size() - 1);
    EXPECT_NEAR(shifted.mean() / 0.25e-18, 0.0, 4.0 / std::sqrt(n));
    EXPECT_TRUE((reference_scan(options).heights == scan.heights).all());
    options.key = {11, 1};
    const Array1D product = reference_scan(options).heights * scan.heights;
    EXPECT_NEAR(product.mean() / 0.25e-18, 0.0, 4.0 / std::sqrt(n));
}

TEST(DriveArtefact, HasTheRequestedRmsOverTheLongestWavelength) {
    const DriveArtefact artefact{4e-9, 1e-3, {3, 0}};
    Array1D curve(240);
    for (Index i = 0; i < 240; ++i) curve[i] = drive_artefact(artefact, 1e-3 * static_cast<double>(i) / 240.0);
    EXPECT_NEAR(rms(curve), 4e-9, 1e-21);
    EXPECT_NEAR(drive_artefact(artefact, 1.1e-3), drive_artefact(artefact, 0.1e-3), 1e-21);
    EXPECT_NE(drive_artefact({4e-9, 1e-3, {4, 0}}, 0.1e-3), drive_artefact(artefact, 0.1e-3));
}

TEST(DriveArtefact, IsRemovedByReferenceScansOfTheSameSession) {
    // what the reference's own trend leaves is a line; compared after the best line is removed from both
    const auto strip = rough_strip();
    auto options = short_scan();
    const auto bare = stylus_scan(strip, options);
    options.artefact = {20e-9, 30e-6, {9, 0}};
    options.noise_rms = 0.2e-9;
    options.key = {9, 100};
    const auto scan = stylus_scan(strip, options);
    std::vector<LineScan> references;
    for (std::uint64_t k = 0; k < 9; ++k) {
        options.key = {9, k + 1};
        references.push_back(reference_scan(options));
    }
    const auto corrected = subtract_artefact(scan, topography::average_reference(references));
    Array1D left = corrected.heights - bare.heights;
    const auto n = left.size();
    const Array1D t = Array1D::LinSpaced(n, -1.0, 1.0);
    left -= left.mean();
    left -= t * ((left * t).sum() / t.square().sum());
    // noise of the scan and a third of it from nine references
    EXPECT_NEAR(rms(left), 0.2e-9 * std::sqrt(1.0 + 1.0 / 9.0), 0.2e-9 * 4.0 / std::sqrt(2.0 * static_cast<double>(n)));
}

TEST(StylusScan, IsTheSameWithAReusedDilator) {
    const auto strip = rough_strip();
    const auto options = short_scan();
    const topography::Dilator touched(strip, options.tip);
    EXPECT_TRUE((stylus_scan(touched, options).heights == stylus_scan(strip, options).heights).all());
}

TEST(StylusScan, RefusesInvalidOptions) {
    auto strip = rough_strip();
    auto options = short_scan();
    options.noise_rms = -1e-9;
    EXPECT_THROW((void)stylus_scan(strip, options), InvalidArgument);
    options = short_scan();
    options.step = 60e-6;  // one point
    EXPECT_THROW((void)stylus_scan(strip, options), InvalidArgument);
    options = short_scan();
    options.artefact = {1e-9, 0.0, {}};
    EXPECT_THROW((void)reference_scan(options), InvalidArgument);
    options = short_scan();
    options.length = 100e-6;
    EXPECT_NO_THROW((void)stylus_scan(strip, options));
    strip.periodic = false;
    EXPECT_THROW((void)stylus_scan(strip, options), InvalidArgument);
}

}  // namespace stylus_test
