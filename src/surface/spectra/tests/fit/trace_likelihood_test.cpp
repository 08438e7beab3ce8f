// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/topography/trace_response.hpp"

namespace setae::spectral_fit::trace_likelihood_test {
namespace {

constexpr double nm = 1e-9, shortest_wavelength = 2.5 * nm;
constexpr topography::TraceResponse response{0.5 * nm, 0.9 * nm, 1.0 * nm, 2e-29};

spectra::SelfAffine model() {
    return {.plateau = 1e-34,
            .rolloff_wavevector = 2.0 * pi / (60.0 * nm),
            .hurst_exponent = 0.8,
            .short_wavevector = 2.0 * pi / shortest_wavelength};
}

/// A contour from a picture: C1D is twice its noise at a wavelength of 7 nm.
topography::Profile traced(std::uint64_t seed) {
    constexpr Index points = 181, grid = 1024;
    const auto kept = [](double q) { return Array1D::Constant(1, q); };
    const double end = model().short_wavevector;
    const auto curve = synthesis::random_line(
        [&](double q) {
            return q > end ? 0.0
                           : spectra::profile_power_spectrum(model(), kept(q))[0] *
                                 std::pow(topography::trace_transfer(response, kept(q))[0], 2);
        },
        {grid, grid * nm}, {.key = {seed, 1}, .threads = {1}});
    const auto noise = synthesis::random_line(
        [&](double q) {
            return response.noise_density * std::pow(topography::smoothing_transfer(response, kept(q))[0], 2);
        },
        {grid, grid * nm}, {.key = {seed, 2}, .threads = {1}});
    topography::Profile profile{
        Array1D::LinSpaced(points, 0.0, nm * (points - 1)), (curve.heights + noise.heights).head(points), {}};
    profile.metadata.instrument.type = "tem";
    profile.response = response;
    return profile;
}

/// stated: stated noise of the profile over its true noise.
LikelihoodSpectrum fitted(bool with_response, std::uint64_t first_seed = 1, double stated = 1.0) {
    std::vector<ObservedSurface> contours;
    for (std::uint64_t seed = first_seed; seed < first_seed + 8; ++seed) {
        auto profile = traced(seed);
        profile.response->noise_density *= stated;
        if (!with_response) profile.response.reset();
        contours.push_back({profile, topography::Trend::mean});
    }
    return likelihood_spectrum(contours,
                               {.shortest_wavelength = shortest_wavelength, .tip_factor = false, .threads = {1}});
}

/// ln of C_iso over the true value, in standard errors at every other knot between a wavelength of 60 nm and the end of
/// the band.
std::vector<double> departures(const LikelihoodSpectrum& fit) {
    const auto density = spectra::density(model());
    std::vector<double> found;
    for (Index i = 0; i < fit.C_iso.wavevector.size(); i += 8) {
        const double q = fit.C_iso.wavevector[i];
        if (q > 2.0 * pi / (60.0 * nm) && q < 0.97 * fit.C_iso.band.upper)
            found.push_back(std::log(fit.C_iso.density[i] / density(q)) / fit.log_standard_error[i]);
    }
    return found;
}

double mean_square(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v * v / static_cast<double>(values.size());
    return sum;
}

TEST(LikelihoodOfTraces, CoversTrueSpectraWithNoiseBlurAndSmoothing) {
    constexpr int sets = 3;
    std::vector<double> sums;
    for (std::uint64_t set = 0; set < sets; ++set) {
        const auto fit = fitted(true, 1 + 8 * set);
        EXPECT_TRUE(fit.converged);
        for (const auto& row : fit.agreement) EXPECT_GT(row.probability, 1e-3);
        const auto found = departures(fit);
        EXPECT_LT(mean_square(found), 3.0);
        sums.resize(found.size(), 0.0);
        for (std::size_t i = 0; i < found.size(); ++i) sums[i] += found[i] / sets;
    }
    EXPECT_GE(sums.size(), 5u);
    for (const double mean : sums) EXPECT_LT(std::abs(mean), 3.0 / std::sqrt(sets));
}

TEST(LikelihoodOfTraces, ToleratesNoiseStatedAThirdTooLow) {
    const auto fit = fitted(true, 1, 0.67);  // two standard deviations of its prior
    EXPECT_TRUE(fit.converged);
    EXPECT_LT(mean_square(departures(fit)), 3.0);
}

// The fit ends with the waves of the surface (2.5 nm) for any knowledge of the trace; below that blur removes power.
TEST(LikelihoodOfTraces, IsBiasedAtShortWavesWithoutTraceResponse) {
    EXPECT_LT(departures(fitted(false)).back(), -3.0);
    EXPECT_GT(departures(fitted(true)).back(), -3.0);
}

}  // namespace
}  // namespace setae::spectral_fit::trace_likelihood_test
