// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/diagnostics/diagnose.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "known_faults.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/reliability.hpp"
#include "setae/topography/contour.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::diagnostics::diagnose_test {
namespace {

TEST(Diagnose, FindsNoProblemInAnIdealSurface) {
    for (const double hurst : {0.4, 0.8}) {
        const auto map = surface({.hurst_exponent = hurst});
        EXPECT_EQ(codes(diagnose(map)), "") << hurst;
        EXPECT_EQ(codes(diagnose(line_of(map))), "") << hurst;
    }
}

TEST(Diagnose, CountsUndefinedHeights) {
    auto map = surface({});
    map.heights.block(10, 20, 6, 5).setConstant(undefined);
    const auto found = diagnose(map);
    EXPECT_EQ(codes(found), "UNDEF");
    EXPECT_DOUBLE_EQ(value(found, "UNDEF", "undefined_share"), 30.0 / static_cast<double>(map.heights.size()));
    EXPECT_DOUBLE_EQ(value(found, "UNDEF", "undefined_heights"), 30.0);
}

TEST(Diagnose, MeasuresALargeTilt) {
    auto map = topography::detrended(surface({}), topography::Trend::tilt);
    const double rms = std::sqrt(map.heights.square().mean());
    for (Index i = 0; i < map.heights.rows(); ++i)
        for (Index j = 0; j < map.heights.cols(); ++j)
            map.heights(i, j) += 0.16 * map.pixel_size()[0] * static_cast<double>(i) -
                                 0.12 * map.pixel_size()[1] * static_cast<double>(j);
    const auto found = diagnose(map);
    EXPECT_EQ(codes(found), "TILT_LARGE");
    EXPECT_NEAR(value(found, "TILT_LARGE", "tilt"), 0.2, 1e-9);
    EXPECT_NEAR(value(found, "TILT_LARGE", "tilt_x"), 0.16, 1e-9);
    EXPECT_NEAR(value(found, "TILT_LARGE", "tilt_y"), -0.12, 1e-9);
    EXPECT_NEAR(value(found, "TILT_LARGE", "rms_height_without_tilt"), rms, 1e-9 * rms);
}

TEST(Diagnose, MeasuresRemainingCurvature) {
    auto map = topography::detrended(surface({}), topography::Trend::parabola);
    const double rms = std::sqrt(map.heights.square().mean()),
                 curvature = 20.0 * rms / (map.size[0] * map.size[0]) * 4.0;
    for (Index i = 0; i < map.heights.rows(); ++i)
        map.heights.row(i) += 0.5 * curvature * std::pow(map.pixel_size()[0] * static_cast<double>(i), 2);
    const auto found = diagnose(map);
    EXPECT_NE(codes(found).find("CURVATURE_LEFT"), std::string::npos);
    EXPECT_NEAR(value(found, "CURVATURE_LEFT", "curvature_x"), curvature, 1e-6 * curvature);
    EXPECT_NEAR(value(found, "CURVATURE_LEFT", "curvature_y"), 0.0, 1e-6 * curvature);
    EXPECT_NEAR(value(found, "CURVATURE_LEFT", "rms_height_without_curvature"), rms, 1e-6 * rms);
}

TEST(Diagnose, MeasuresTheEffectOfSpikes) {
    const auto map = surface({});
    auto spiked = map;
    constexpr int count = 37;
    for (int k = 0; k < count; ++k) spiked.heights(5 + (k * 29) % 118, 5 + (k * 47) % 118) += 80e-9;
    const auto found = diagnose(spiked);
    EXPECT_EQ(codes(found), "SPIKES");
    EXPECT_DOUBLE_EQ(value(found, "SPIKES", "spikes"), count);
    const auto rms = [](const topography::HeightMap& m) {
        return std::sqrt((topography::detrended(m, topography::Trend::tilt).heights).square().mean());
    };
    EXPECT_NEAR(value(found, "SPIKES", "rms_height_with_spikes"), rms(spiked), 1e-3 * rms(spiked));
    EXPECT_NEAR(value(found, "SPIKES", "rms_height_without_spikes"), rms(map), 2e-3 * rms(map));
    // at the shortest wavelengths the white spectrum of the spikes n h²Δ/N exceeds that of the surface
    const auto C1D = last_modes(map), lifted = last_modes(spiked);
    EXPECT_NEAR(value(found, "SPIKES", "psd_factor") / (lifted / C1D), 1.0, 0.1);
    EXPECT_GT(value(found, "SPIKES", "psd_lifted_below_wavelength"), 2.0 * map.pixel_size()[0]);
}

TEST(Diagnose, EstimatesTheLevelOfPixelNoise) {
    for (const double sigma : {4e-9, 8e-9, 16e-9}) {
        auto map = surface({.hurst_exponent = 0.8});
        const double slope2 = mean_square_slope_x(map);
        map.heights += sigma * noise(map.heights.rows(), map.heights.cols(), 7);
        const auto found = diagnose(map);
        ASSERT_EQ(codes(found), "PIXEL_NOISE") << sigma;
        const auto level = quantity(found, "PIXEL_NOISE", "noise_rms_height").estimate;
        EXPECT_NEAR(level.value, sigma, 3.0 * level.standard_error);
        EXPECT_LT(level.standard_error, 0.2 * sigma);
        const double share = 2.0 * sigma * sigma / std::pow(map.pixel_size()[0], 2) / mean_square_slope_x(map);
        EXPECT_NEAR(value(found, "PIXEL_NOISE", "noise_share_of_mean_square_slope"), share,
                    3.0 * quantity(found, "PIXEL_NOISE", "noise_share_of_mean_square_slope").estimate.standard_error);
        EXPECT_LT(slope2, mean_square_slope_x(map));
    }
}

TEST(Diagnose, FindsNoNoiseWhereItIsBelowTheSurface) {
    auto map = surface({.hurst_exponent = 0.4});
    map.heights += 0.02e-9 * noise(map.heights.rows(), map.heights.cols(), 7);
    EXPECT_EQ(codes(diagnose(map)), "");
}

TEST(Diagnose, MeasuresTheLossByTheTip) {
    auto map = surface({.hurst_exponent = 0.6});
    map.metadata.instrument.tip_radius = 20e-9;
    const auto found = diagnose(map);
    EXPECT_EQ(codes(found), "TIP_CUTOFF");
    const double cutoff = spectra::tip_cutoff(map, 20e-9).value;
    ASSERT_GT(cutoff, 0.0);
    EXPECT_DOUBLE_EQ(value(found, "TIP_CUTOFF", "tip_cutoff_wavelength"), cutoff);
    EXPECT_NEAR(value(found, "TIP_CUTOFF", "band_lost"), std::log10(cutoff / (2.0 * map.pixel_size()[0])), 1e-9);
    map.metadata.instrument.tip_radius = 1e-12;
    EXPECT_EQ(codes(diagnose(map)), "");
}

TEST(Diagnose, MeasuresGrowthOfRmsHeightWithoutRolloff) {
    // rms height of a self-affine surface without roll-off grows as size^H
    const auto map = surface({.hurst_exponent = 0.8, .rolloff_in_sizes = 40.0});
    const auto found = diagnose(map);
    ASSERT_NE(codes(found).find("LOW_Q_GAP"), std::string::npos) << codes(found);
    const auto growth = quantity(found, "LOW_Q_GAP", "rms_height_growth_per_decade").estimate;
    EXPECT_NEAR(growth.value, std::pow(10.0, 0.8), 3.0 * growth.standard_error);
    EXPECT_LT(growth.standard_error, growth.value);
}

TEST(Diagnose, CountsScars) {
    auto map = surface({.hurst_exponent = 0.9});
    const std::array<std::array<Index, 3>, 4> strokes{
        {{10, 20, 40}, {60, 50, 30}, {30, 77, 60}, {5, 100, 25}}};  // first point, line, length
    for (const auto& [first, line, length] : strokes) map.heights.col(line).segment(first, length) += 60e-9;
    const auto found = diagnose(map);
    ASSERT_EQ(codes(found), "SCARS");
    EXPECT_DOUBLE_EQ(value(found, "SCARS", "scars"), 4.0);
    EXPECT_NEAR(value(found, "SCARS", "scar_points"), 155.0, 16.0);
    EXPECT_NEAR(
        value(found, "SCARS", "rms_height_without_scars"),
        std::sqrt(
            topography::detrended(surface({.hurst_exponent = 0.9}), topography::Trend::tilt).heights.square().mean()),
        0.3e-9);
}

TEST(Diagnose, FindsOffsetsOfScanLines) {
    for (const double sigma : {4e-9, 16e-9}) {
        auto map = surface({.hurst_exponent = 0.7});
        map.heights.rowwise() += sigma * noise(1, map.heights.cols(), 3).row(0);
        const auto found = diagnose(map);
        ASSERT_EQ(codes(found), "SCAN_DIRECTION") << sigma;
        const auto offset = quantity(found, "SCAN_DIRECTION", "line_offset_rms").estimate;
        EXPECT_NEAR(offset.value, sigma, 3.0 * offset.standard_error);
        EXPECT_LT(offset.standard_error, 0.2 * sigma);
        // independent offsets give steps of twice their mean square
        const double share = 2.0 * std::pow(offset.value / map.pixel_size()[1], 2) /
                             mean_square_slope_y(topography::detrended(map, topography::Trend::tilt));
        EXPECT_NEAR(value(found, "SCAN_DIRECTION", "offset_share_of_mean_square_slope_y"), share, 1e-12 * share);
    }
}

TEST(Diagnose, MeasuresTheAnisotropyOfASurface) {
    // features twice as long along y: slopes along x are twice those along y
    const auto map = surface({.hurst_exponent = 0.8, .stretch = 2.0, .angle = 0.5 * pi});
    const auto found = diagnose(map);
    ASSERT_EQ(codes(found), "ANISOTROPIC");
    const auto ratio = quantity(found, "ANISOTROPIC", "slope_ratio").estimate;
    EXPECT_NEAR(value(found, "ANISOTROPIC", "steepest_direction"), 0.0, 1e-12);
    EXPECT_NEAR(ratio.value, std::sqrt(mean_square_slope_x(map) / mean_square_slope_y(map)),
                1e-3);  // the tilt is removed before
    EXPECT_NEAR(ratio.value, 1.8,
                3.0 * ratio.standard_error);  // 2^H of the finest pixels to 2 of waves that are resolved
}

TEST(Diagnose, FindsTheStepOfADigitiser) {
    auto map = surface({});
    const double step = 2e-9;
    map.heights = step * (map.heights / step).round();
    const auto found = diagnose(map);
    ASSERT_NE(codes(found).find("QUANTISED"), std::string::npos);
    EXPECT_NEAR(value(found, "QUANTISED", "height_step"), step, 1e-6 * step);
    EXPECT_NEAR(value(found, "QUANTISED", "rounding_rms_height"), step / std::sqrt(12.0), 1e-6 * step);
    EXPECT_GT(value(found, "QUANTISED", "plateau_share"), 0.05);
    // steps far below the difference of neighbours are no problem
    auto fine = surface({});
    fine.heights = 1e-3 * step * (fine.heights / (1e-3 * step)).round();
    EXPECT_EQ(codes(diagnose(fine)), "");
}

TEST(Diagnose, CountsClippedHeights) {
    auto map = surface({});
    Array1D sorted = Eigen::Map<const Array1D>(map.heights.data(), map.heights.size());
    std::sort(sorted.begin(), sorted.end());
    const Index clipped = 320;
    const double top = sorted[sorted.size() - clipped];
    map.heights = map.heights.min(top);
    const auto found = diagnose(map);
    EXPECT_EQ(codes(found), "CLIPPED");
    EXPECT_DOUBLE_EQ(value(found, "CLIPPED", "clipped_points"), static_cast<double>(clipped));
    EXPECT_DOUBLE_EQ(value(found, "CLIPPED", "clipped_share"),
                     static_cast<double>(clipped) / static_cast<double>(sorted.size()));
    EXPECT_DOUBLE_EQ(value(found, "CLIPPED", "clipped_height"), top);
    EXPECT_EQ(codes(diagnose(topography::scaled(map, -1.0))), "CLIPPED");
}

TEST(Diagnose, ReportsAConstantMap) {
    const topography::HeightMap map{Array2D::Constant(20, 20, 1e-6), {1e-6, 1e-6}, false, {}};
    EXPECT_EQ(codes(diagnose(map)), "QUANTISED");
    const topography::LineScan line{Array1D::Zero(2), 1e-6, false, {}};
    EXPECT_EQ(codes(diagnose(line)), "QUANTISED");
}

TEST(Diagnose, MeasuresReentrantStretches) {
    const auto line = line_of(surface({}));
    const Index n = line.heights.size();
    topography::Profile profile{
        Array1D::LinSpaced(n, 0.0, line.pixel_size() * static_cast<double>(n - 1)), line.heights, {}};
    EXPECT_EQ(codes(diagnose(profile)), "");
    profile.positions.segment(60, 6) -= 8.0 * line.pixel_size();
    const auto found = diagnose(profile);
    ASSERT_EQ(codes(found), "REENTRANT");
    EXPECT_DOUBLE_EQ(value(found, "REENTRANT", "reentrant_share"), topography::clean_contour(profile).reentrant_share);
}

TEST(Diagnose, IsUnaffectedByAnOffsetOfTenMillionRmsHeights) {
    auto map = surface({});
    for (int k = 0; k < 12; ++k) map.heights(9 + 9 * k, 20 + 5 * k) += 80e-9;
    const auto plain = diagnose(map);
    map.heights += 0.1;
    const auto shifted = diagnose(map);
    EXPECT_EQ(codes(shifted), codes(plain));
    EXPECT_DOUBLE_EQ(value(shifted, "SPIKES", "spikes"), 12.0);
    EXPECT_NEAR(value(shifted, "SPIKES", "rms_height_without_spikes"),
                value(plain, "SPIKES", "rms_height_without_spikes"),
                1e-6 * value(plain, "SPIKES", "rms_height_without_spikes"));
}

TEST(Diagnose, HandlesMapsOfAnySize) {
    for (const auto& [nx, ny] : {std::array<Index, 2>{2, 2}, {2, 33}, {33, 2}, {17, 23}, {64, 3}}) {
        const topography::HeightMap map{1e-9 * noise(nx, ny, 1), {1e-6, 1e-6}, false, {}};
        EXPECT_NO_THROW((void)diagnose(map)) << nx << " x " << ny;
    }
    for (const Index n : {2, 3, 15, 33}) {
        const topography::LineScan line{1e-9 * noise(n, 1, 1).col(0), 1e-6, false, {}};
        EXPECT_NO_THROW((void)diagnose(line)) << n;
    }
}

TEST(Diagnose, GivesTheSameNumbersForAnyNumberOfThreads) {
    auto map = surface({});
    map.heights += 4e-9 * noise(map.heights.rows(), map.heights.cols(), 5);
    const auto one = diagnose(map, {.threads = {1}}), three = diagnose(map, {.threads = {3}});
    ASSERT_EQ(one.size(), three.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_EQ(one[k].alert, three[k].alert);
        for (std::size_t e = 0; e < one[k].effects.size(); ++e)
            EXPECT_EQ(one[k].effects[e].estimate.value, three[k].effects[e].estimate.value);
    }
}

TEST(Diagnose, RefusesOptionsOutsideTheirDomainAndMapsWithoutHeights) {
    EXPECT_THROW((void)diagnose(surface({}), {.false_alarm = 0.0}), InvalidArgument);
    const topography::HeightMap empty{Array2D::Constant(4, 4, undefined), {1.0, 1.0}, false, {}};
    EXPECT_THROW((void)diagnose(empty), UndefinedDataError);
}

}  // namespace
}  // namespace setae::diagnostics::diagnose_test
