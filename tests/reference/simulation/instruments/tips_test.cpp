// SPDX-License-Identifier: GPL-3.0-or-later
// What balls do to spectra, against an independent simulation's numbers (README).
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/simulation/afm.hpp"
#include "setae/simulation/stylus.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/spectra/reliability.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace tips_test {

using namespace setae;
using namespace setae::simulation;
using spectra::SelfAffine;
using topography::HeightMap;

SelfAffine with_slope(double slope, double hurst_exponent, double rolloff_wavelength) {
    SelfAffine model{1e-30, 2.0 * pi / rolloff_wavelength, hurst_exponent, 2.0 * pi / 4e-10};
    model.plateau *= std::pow(slope / rms_slope(model), 2);
    return model;
}

const spectra::SpectrumOptions periodic_lines{.window = spectra::Window::none, .trend = topography::Trend::mean};

/// Sum of C1D between two wavevectors.
double power_between(const spectra::MeasuredSpectrum& spectrum, double lower, double upper) {
    return (spectrum.wavevector >= lower && spectrum.wavevector <= upper).select(spectrum.density, 0.0).sum();
}

TEST(AfmMap, LosesPowerAtTheTipCutoffAsInAnIndependentSimulation) {
    double at_cutoff = 0.0, at_half = 0.0;
    // surfaces down to half a nanometre: without the shortest waves the ball meets no sharp peaks
    constexpr std::uint64_t surfaces = 6;
    for (std::uint64_t seed = 0; seed < surfaces; ++seed) {
        const double hurst_exponent = 0.75 + 0.05 * static_cast<double>(seed % 3);
        const auto surface = synthesis::random_surface(density(with_slope(0.7, hurst_exponent, 1e-6)),
                                                       {4096, 1024, 1e-6, 0.25e-6}, {.key = {7, seed}});
        AfmOptions options{.tip = topography::SphereTip{10e-9}, .nx = 512, .ny = 128, .size = 1e-6};
        auto seen = afm_map(surface, options);
        seen.periodic = true;
        HeightMap truth = seen;
        for (Index i = 0; i < 512; ++i)
            for (Index j = 0; j < 128; ++j) truth.heights(i, j) = surface.heights(8 * i, 8 * j);
        const double cutoff = 2.0 * pi / spectra::tip_cutoff(seen, 10e-9).value;
        const auto measured = power_spectrum(seen, periodic_lines), known = power_spectrum(truth, periodic_lines);
        const auto factor = [&](double q) {
            return power_between(measured, 0.89 * q, 1.13 * q) / power_between(known, 0.89 * q, 1.13 * q);
        };
        at_cutoff += factor(cutoff) / surfaces;
        at_half += factor(0.5 * cutoff) / surfaces;
    }
    // 13–20 % and 7–9 % low there; maps of this size scatter by 0.03, the mean of six by 0.012
    EXPECT_GT(at_cutoff, 0.80 - 2 * 0.012);
    EXPECT_LT(at_cutoff, 0.87 + 2 * 0.012);
    EXPECT_GT(at_half, 0.91 - 2 * 0.012);
    EXPECT_LT(at_half, 0.93 + 2 * 0.012);
}

TEST(StylusScan, WithABallLowersThePlateauWhereADiscAlongALineRaisesIt) {
    const double rolloff = 1e-6, pixel = rolloff / 40.0;
    const Index nx = 6000, ny = 640;
    const auto strip = synthesis::random_surface(
        density(with_slope(0.7, 0.85, rolloff)),
        {nx, ny, static_cast<double>(nx) * pixel, static_cast<double>(ny) * pixel}, {.key = {7, 1}});
    const topography::Dilator touched(strip, topography::SphereTip{5e-6});
    double ball = 0.0, disc = 0.0, surface = 0.0;
    for (Index line = 0; line < 8; ++line) {
        StylusOptions options{
            .length = strip.size[0], .step = pixel, .start_y = static_cast<double>(80 * line) * pixel};
        auto seen = stylus_scan(touched, options);
        seen.periodic = true;
        const topography::LineScan truth{strip.heights.col(80 * line), strip.size[0], true, {}};
        const auto plateau = [&](const topography::LineScan& scan) {
            return power_between(power_spectrum(scan, periodic_lines), 0.0, pi / rolloff);
        };
        ball += plateau(seen);
        disc += plateau(dilated(truth, topography::SphereTip{5e-6}));
        surface += plateau(truth);
    }
    // 5–40 % low over the stylus' band; the disc raises the plateau
    EXPECT_GT(ball / surface, 0.60);
    EXPECT_LT(ball / surface, 0.95);
    EXPECT_GT(disc / surface, 1.0);
}

}  // namespace tips_test
