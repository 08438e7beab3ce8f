// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/likelihood_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::spectral_fit::likelihood_spectrum_test {
namespace {

constexpr double shortest_wavelength = 20e-9;

spectra::SelfAffine model() {
    return {.plateau = 2e-30,
            .rolloff_wavevector = 2.0 * pi / 500e-9,
            .hurst_exponent = 0.8,
            .short_wavevector = 2.0 * pi / shortest_wavelength};
}

/// Points of a patch twice as wide and fine enough for the shortest waves: includes longer waves and aliases.
topography::HeightMap cut_map(std::uint64_t seed, Index points, double pixel, double factor = 1.0) {
    const auto stride = std::max<Index>(1, static_cast<Index>(std::lround(pixel / (0.5 * shortest_wavelength))));
    const Index fine = 2 * points * stride;
    const double size = 2.0 * static_cast<double>(points) * pixel;
    const auto patch = synthesis::random_surface(spectra::density(model()), {fine, fine, size, size},
                                                 {.key = {seed, 1}, .threads = {1}});
    topography::HeightMap map{Array2D(points, points), {0.5 * size, 0.5 * size}, false, {}};
    for (Index i = 0; i < points; ++i)
        for (Index j = 0; j < points; ++j) map.heights(i, j) = factor * patch.heights(i * stride, j * stride);
    map.metadata.instrument.type = "afm";
    return map;
}

/// Every third to seventh point of a fine line.
topography::Measurement traced(std::uint64_t seed) {
    const auto map = cut_map(seed, 512, 1e-9);
    std::vector<Index> places{0};
    for (std::uint64_t i = 0; places.back() + 7 < 512; ++i)
        places.push_back(places.back() + 3 + static_cast<Index>((seed * 31 + i * i * 7) % 5));
    topography::Profile profile{
        Array1D(static_cast<Index>(places.size())), Array1D(static_cast<Index>(places.size())), {}};
    for (Index p = 0; p < profile.positions.size(); ++p) {
        profile.positions[p] = 1e-9 * static_cast<double>(places[static_cast<std::size_t>(p)]);
        profile.heights[p] = map.heights(places[static_cast<std::size_t>(p)], 0);
    }
    profile.metadata.instrument.type = "tem";
    return profile;
}

std::vector<ObservedSurface> observed(double factor_of_last = 1.0) {
    std::vector<ObservedSurface> all;
    for (std::uint64_t seed : {1, 2}) all.push_back({cut_map(seed, 128, 40e-9), topography::Trend::tilt});
    auto last = cut_map(3, 128, 10e-9, factor_of_last);
    last.metadata.instrument.type = "other";
    all.push_back({last, topography::Trend::tilt});
    for (std::uint64_t seed : {4, 5}) all.push_back({traced(seed), topography::Trend::mean});
    return all;
}

const LikelihoodSpectrum& fitted() {
    static const auto fit =
        likelihood_spectrum(observed(), {.shortest_wavelength = shortest_wavelength, .threads = {1}});
    return fit;
}

TEST(LikelihoodSpectrum, CoversTheTrueSpectrumOverTheWholeBand) {
    const auto& fit = fitted();
    EXPECT_TRUE(fit.converged);
    const auto density = spectra::density(model());
    double chi_squared = 0.0;
    int count = 0;
    for (Index i = 0; i < fit.C_iso.wavevector.size(); i += 8) {  // twice per knot: errors of neighbours are similar
        const double q = fit.C_iso.wavevector[i];
        if (q < fit.C_iso.band.lower || q > 0.97 * fit.C_iso.band.upper) continue;
        const double error = std::log(fit.C_iso.density[i] / density(q));
        EXPECT_LT(std::abs(error), 4.5 * fit.log_standard_error[i] + 0.03) << q;  // 3 %: a corner in ln C, smoothed
        chi_squared += error * error / (fit.log_standard_error[i] * fit.log_standard_error[i]);
        ++count;
    }
    EXPECT_GT(count, 8);
    EXPECT_LT(chi_squared, 3.0 * count);
}

TEST(LikelihoodSpectrum, IsTheSameForAnyNumberOfThreads) {
    const auto again = likelihood_spectrum(observed(), {.shortest_wavelength = shortest_wavelength, .threads = {2}});
    EXPECT_TRUE((again.C_iso.density == fitted().C_iso.density).all());
    EXPECT_TRUE((again.covariance.array() == fitted().covariance.array()).all());
}

TEST(LikelihoodSpectrum, NamesTheInstrumentThatDisagrees) {
    EXPECT_TRUE(fitted().alerts.empty());
    const auto wrong = likelihood_spectrum(observed(1.8), {.shortest_wavelength = shortest_wavelength, .threads = {1}});
    ASSERT_FALSE(wrong.alerts.empty());
    EXPECT_EQ(wrong.alerts[0].code, "INSTRUMENTS_DISAGREE");
}

// If instruments agree, a probability below p has the frequency p: within a factor of about three, because χ² of groups
// of a few modes is not known better, and decades of one fit share its parameters.
TEST(LikelihoodSpectrum, AgreementTestHasTheStatedProbability) {
    int rows = 0, tenth = 0, hundredth = 0;
    double logs = 0.0;
    for (std::uint64_t set = 0; set < 40; ++set) {
        std::vector<ObservedSurface> all;
        for (std::uint64_t i = 0; i < 2; ++i)
            all.push_back({cut_map(1000 + 10 * set + i, 64, 40e-9), topography::Trend::tilt});
        auto fine = cut_map(1005 + 10 * set, 64, 10e-9);
        fine.metadata.instrument.type = "other";
        all.push_back({fine, topography::Trend::tilt});
        const auto fit = likelihood_spectrum(all, {.shortest_wavelength = shortest_wavelength, .threads = {1}});
        for (const auto& row : fit.agreement) {
            if (row.groups < 3) continue;
            ++rows;
            tenth += row.probability < 0.1 ? 1 : 0;
            hundredth += row.probability < 0.01 ? 1 : 0;
            logs -= std::log10(std::max(row.probability, 1e-30));
        }
    }
    ASSERT_GT(rows, 80);
    EXPECT_GT(tenth, 0.02 * rows);
    EXPECT_LT(tenth, 0.2 * rows);
    EXPECT_LT(hundredth, 0.03 * rows);
    EXPECT_NEAR(logs / rows, 1.0 / std::log(10.0), 0.25);  // the mean of −lg p is 0.43
}

TEST(LikelihoodSpectrum, ReportsThatTheRolloffIsNotMeasured) {
    std::vector<ObservedSurface> short_ones;  // 500 nm of waves up to 500 nm
    for (std::uint64_t seed : {4, 5, 6}) short_ones.push_back({traced(seed), topography::Trend::mean});
    const auto fit = likelihood_spectrum(short_ones, {.shortest_wavelength = shortest_wavelength, .threads = {1}});
    EXPECT_TRUE(
        std::any_of(fit.alerts.begin(), fit.alerts.end(), [](const Alert& a) { return a.code == "ROLLOFF_NOT_SEEN"; }));
}

// The same places measured twice as high: only the places distinguish them.
TEST(LikelihoodSpectrum, WidensItsIntervalsForScatterBetweenMeasurements) {
    auto scattered = observed();
    for (std::size_t i = 0; i < 2; ++i)
        scattered.push_back({cut_map(10 + i, 128, 40e-9, 1.5), topography::Trend::tilt});
    const auto fit = likelihood_spectrum(scattered, {.shortest_wavelength = shortest_wavelength, .threads = {1}});
    EXPECT_TRUE(std::any_of(fit.alerts.begin(), fit.alerts.end(),
                            [](const Alert& a) { return a.code == "MEASUREMENTS_SCATTER"; }));
    const Index middle = fit.C_iso.wavevector.size() / 2;
    EXPECT_GT(fit.log_standard_error[middle], 1.5 * fitted().log_standard_error[middle]);
}

TEST(LikelihoodSpectrum, DrawsHaveTheScatterOfItsErrors) {
    const auto& fit = fitted();
    constexpr Index draws = 2000;
    const Array2D spectra = drawn_spectra(fit, draws, 9);
    for (const Index i : {fit.C_iso.wavevector.size() / 3, fit.C_iso.wavevector.size() / 2}) {
        const Array1D logs = spectra.col(i).log();
        EXPECT_NEAR(logs.mean(), std::log(fit.C_iso.density[i]), 5.0 * fit.log_standard_error[i] / std::sqrt(draws));
        EXPECT_NEAR(std::sqrt((logs - logs.mean()).square().sum() / (draws - 1.0)) / fit.log_standard_error[i], 1.0,
                    5.0 / std::sqrt(2.0 * draws));
    }
    EXPECT_TRUE((drawn_spectra(fit, 3, 9) == spectra.topRows(3)).all());
}

// Points closer than half the shortest wave of the surface have modes with only leakage of the window.
TEST(LikelihoodSpectrum, EndsAtTheShortestWavelengthOfTheSurface) {
    std::vector<ObservedSurface> fine;
    for (std::uint64_t seed : {4, 5}) {
        const auto map = cut_map(seed, 512, 2e-9);
        topography::Profile profile{Array1D::LinSpaced(512, 0.0, 511.0 * 2e-9), map.heights.col(0), {}};
        profile.metadata.instrument.type = "tem";
        fine.push_back({profile, topography::Trend::mean});
    }
    const auto fit = likelihood_spectrum(fine, {.shortest_wavelength = shortest_wavelength, .threads = {1}});
    EXPECT_LE(fit.C_iso.band.upper, 2.0 * pi / shortest_wavelength);
    EXPECT_GT(fit.C_iso.band.upper, 0.9 * 2.0 * pi / shortest_wavelength);
    for (const auto& row : fit.agreement) EXPECT_GT(row.probability, 1e-3);
}

TEST(LikelihoodSpectrum, RefusesDataThatCannotBeFitted) {
    EXPECT_THROW((void)likelihood_spectrum({}, {}), InvalidArgument);
    EXPECT_THROW((void)likelihood_spectrum(observed(), {.shortest_wavelength = 0.0}), InvalidArgument);
    auto empty = observed();
    std::get<topography::HeightMap>(empty[0].measurement).heights.setConstant(undefined);
    EXPECT_THROW((void)likelihood_spectrum(empty, {.shortest_wavelength = shortest_wavelength}), UndefinedDataError);
}

}  // namespace
}  // namespace setae::spectral_fit::likelihood_spectrum_test
