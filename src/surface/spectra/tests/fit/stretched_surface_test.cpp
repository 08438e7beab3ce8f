// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces longer along one direction: mean over directions of the fit compared with the known input.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::spectral_fit::stretched_surface_test {
namespace {

constexpr double shortest_wavelength = 40e-9, pixel = 0.5 * shortest_wavelength;
constexpr Index fine = 512, points = fine / 2;

spectra::SelfAffine model() {
    return {.plateau = 2e-30,
            .rolloff_wavevector = 2.0 * pi / 400e-9,
            .hurst_exponent = 0.8,
            .short_wavevector = 2.0 * pi / shortest_wavelength};
}

Array2D heights(std::uint64_t seed, const spectra::Anisotropy& anisotropy) {
    constexpr double size = static_cast<double>(fine) * pixel;
    return synthesis::random_surface(spectra::density(model()), {fine, fine, size, size},
                                     {.key = {seed, 1}, .anisotropy = anisotropy, .threads = {1}})
        .heights;
}

std::vector<ObservedSurface> maps(const spectra::Anisotropy& anisotropy, std::uint64_t seed) {
    std::vector<ObservedSurface> all;
    for (std::uint64_t i = 0; i < 4; ++i) {
        topography::HeightMap map{
            heights(seed + i, anisotropy).topLeftCorner(points, points), {points * pixel, points * pixel}, false, {}};
        map.metadata.instrument.type = "afm";
        all.push_back({map, topography::Trend::tilt});
    }
    return all;
}

/// Eight lines of each patch, far from each other, along x or, rotated by 90°, along y. Every other point is read:
/// waves of a surface twice as long along x end where their sampling does.
std::vector<ObservedSurface> lines(const spectra::Anisotropy& anisotropy, std::uint64_t seed, bool along_y) {
    std::vector<ObservedSurface> all;
    for (std::uint64_t n = 0; n < 3; ++n) {
        const Array2D patch = heights(seed + n, anisotropy);
        for (Index line = 0; line < 8; ++line) {
            topography::LineScan scan;
            scan.size = points * pixel;
            scan.heights = Array1D::NullaryExpr(points / 2, [&, at = line * fine / 8](Index i) {
                return along_y ? patch(at, 2 * i) : patch(2 * i, at);
            });
            scan.metadata.instrument.type = "stylus";
            all.push_back({scan, topography::Trend::tilt});
            all.back().direction = along_y ? 0.5 * pi : 0.0;
        }
    }
    return all;
}

/// Mean over directions of s C_iso(q √(s² cos² + sin²)).
double known_spectrum(double q, double stretch) {
    const auto C_iso = spectra::density(model());
    constexpr int directions = 64;
    double sum = 0.0;
    for (int d = 0; d < directions; ++d) {
        const double angle = pi * d / directions;
        sum += stretch * C_iso(q * std::hypot(stretch * std::cos(angle), std::sin(angle)));
    }
    return sum / directions;
}

/// Largest deviation of ln C_iso in standard errors, and its mean, between the roll-off, whose corner is not smooth,
/// and half of the largest wavevector.
struct Departure {
    double worst = 0.0, mean = 0.0;
};
Departure departure(const LikelihoodSpectrum& fit, double stretch) {
    Departure found;
    int n = 0;
    const double end = pi / shortest_wavelength;
    for (Index i = 0; i < fit.C_iso.wavevector.size(); ++i) {
        const double q = fit.C_iso.wavevector[i];
        if (q > end || q < 0.3 * end) continue;
        const double off = std::log(fit.C_iso.density[i] / known_spectrum(q, stretch));
        found.worst = std::max(found.worst, std::abs(off) / fit.log_standard_error[i]);
        found.mean += off;
        ++n;
    }
    found.mean /= n;
    return found;
}

LikelihoodSpectrum fit_of(const std::vector<ObservedSurface>& observed) {
    return likelihood_spectrum(observed, {.shortest_wavelength = shortest_wavelength, .threads = {1}});
}

bool alerted(const LikelihoodSpectrum& fit) {
    return std::any_of(fit.alerts.begin(), fit.alerts.end(), [](const Alert& a) { return a.code == "STRETCHED"; });
}

TEST(AnisotropicSurface, SpectrumFromMapsIsTheMeanOverDirections) {
    for (const double angle : {0.0, pi / 6.0, 0.5 * pi}) {
        const auto fit = fit_of(maps({2.0, angle}, 10));
        EXPECT_TRUE(alerted(fit));
        ASSERT_EQ(fit.stretch.size(), 1u);
        EXPECT_NEAR(fit.stretch[0].ratio.value, 2.0, 3.0 * fit.stretch[0].ratio.standard_error);
        EXPECT_LT(fit.stretch[0].ratio.standard_error, 0.15);
        const double turned = fit.stretch[0].direction.value - angle;
        EXPECT_NEAR(std::abs(std::cos(turned)), 1.0, 0.01);
        const auto away = departure(fit, 2.0);
        EXPECT_LT(away.worst, 3.0) << angle;
        EXPECT_LT(std::abs(away.mean), 0.08) << angle;  // only lines along x would be 0.55 off
    }
}

TEST(AnisotropicSurface, SpectrumFromLinesAlongTwoDirectionsIsTheMean) {
    auto both = lines({2.0, 0.0}, 20, false);
    const auto one = departure(fit_of(both), 2.0);
    EXPECT_LT(one.mean, -0.3);
    for (auto& scan : lines({2.0, 0.0}, 30, true)) both.push_back(scan);
    const auto fit = fit_of(both);
    EXPECT_TRUE(alerted(fit));
    const auto away = departure(fit, 2.0);
    EXPECT_LT(away.worst, 3.0);
    EXPECT_LT(std::abs(away.mean), 0.1);
    const auto middle = fit.stretch[fit.stretch.size() / 2].ratio;
    EXPECT_NEAR(middle.value, 2.0, 3.0 * middle.standard_error);
}

TEST(AnisotropicSurface, IsNotReportedForIsotropicSurfaces) {
    EXPECT_TRUE(fit_of(maps({}, 40)).stretch.empty());
    auto both = lines({}, 50, false);
    for (auto& scan : lines({}, 60, true)) both.push_back(scan);
    const auto fit = fit_of(both);
    EXPECT_TRUE(fit.stretch.empty());
    EXPECT_FALSE(alerted(fit));
    EXPECT_LT(departure(fit, 1.0).worst, 3.0);
}

// A map rotated by 90° on the stage gives the same surface.
TEST(AnisotropicSurface, IsInvariantUnderRotationOfMaps) {
    auto straight = maps({2.0, 0.0}, 70);
    auto turned = straight;
    for (std::size_t i = 0; i < 2; ++i) {
        auto& map = std::get<topography::HeightMap>(turned[i].measurement);
        map.heights = Array2D(map.heights.transpose());
        turned[i].direction = 0.5 * pi;
    }
    const auto fit = fit_of(turned);
    ASSERT_EQ(fit.stretch.size(), 1u);
    EXPECT_NEAR(fit.stretch[0].ratio.value, 2.0, 3.0 * fit.stretch[0].ratio.standard_error);
    EXPECT_LT(departure(fit, 2.0).worst, 3.0);
}

}  // namespace
}  // namespace setae::spectral_fit::stretched_surface_test
