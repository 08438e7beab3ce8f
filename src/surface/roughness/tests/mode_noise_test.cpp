// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/mode_noise.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/spectra/parametric_noise.hpp"

namespace setae::roughness::mode_noise_test {
namespace {

/// Modes of a self-affine line whose periodogram scatters.
spectra::MeasuredSpectrum modes(Index n) {
    spectra::MeasuredSpectrum spectrum;
    spectrum.nodes = spectra::Nodes::modes;
    spectrum.wavevector = Array1D::LinSpaced(n, 2e4, 2e4 * static_cast<double>(n));
    spectrum.density = 1e-12 * (spectrum.wavevector / 1e4).pow(-2.6);
    const spectra::NoiseNumbers random(9, 0);
    for (Index k = 0; k < n; ++k) spectrum.density[k] *= random.gamma(static_cast<std::uint64_t>(k), 1.0);
    spectrum.band = {1e4, 2e4 * (static_cast<double>(n) + 0.5)};
    spectrum.count = Array1D::Ones(n);
    spectrum.standard_error = Array1D::Constant(n, undefined);
    return spectrum;
}

/// The same modes one by one: every replica is a separate spectrum.
std::vector<SpectralParameters> one_by_one(const spectra::MeasuredSpectrum& spectrum, const Array1D& freedom,
                                           const ModeNoiseOptions& options) {
    const Array2D drawn = spectra::parametric_noise(spectrum, freedom, options.count, options.seed);
    std::vector<SpectralParameters> replicas;
    auto replica = spectrum;
    for (Index r = 0; r < drawn.rows(); ++r) {
        replica.density = drawn.row(r).transpose();
        replicas.push_back(
            spectral_parameters(limited(spectra::within_band(replica), options.limits), options.conversion));
    }
    return replicas;
}

using Value = std::function<double(const SpectralParameters&)>;
const std::vector<Value>& values() {
    static const std::vector<Value> all{
        [](const auto& p) { return p.rms_height; },    [](const auto& p) { return p.rms_slope; },
        [](const auto& p) { return p.rms_curvature; }, [](const auto& p) { return p.elastic_energy_per_modulus; },
        [](const auto& p) { return p.decade_C1D[0]; }, [](const auto& p) { return p.decade_C1D[1]; },
        [](const auto& p) { return p.decade_C1D[3]; }};
    return all;
}

TEST(ModeNoise, OfFewModesMatchesIndividualDraws) {
    const auto spectrum = modes(2000);
    const Array1D freedom = Array1D::LinSpaced(2000, 0.5142857142857142, 3.0);
    for (const auto conversion : {Conversion::exact, Conversion::eq11}) {
        const ModeNoiseOptions options{
            .limits = {3e-4, 1e-6}, .conversion = conversion, .count = 3, .seed = 4, .threads = {2}};
        const auto found = parameters_of_noise(spectrum, freedom, options),
                   expected = one_by_one(spectrum, freedom, options);
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t v = 0; v < values().size(); ++v) {
                const double is = values()[v](found[r]), should = values()[v](expected[r]);
                if (std::isnan(should)) EXPECT_TRUE(std::isnan(is)) << v;
                else EXPECT_NEAR(is / should, 1.0, 1e-11) << v;
            }
    }
}

/// Standard deviation over mean.
double scatter(const std::vector<SpectralParameters>& replicas, const Value& value) {
    const double n = static_cast<double>(replicas.size());
    double mean = 0.0, squares = 0.0;
    for (const auto& p : replicas) mean += value(p) / n;
    for (const auto& p : replicas) squares += std::pow(value(p) - mean, 2) / n;
    return std::sqrt(squares) / mean;
}

// the error of a standard deviation from 400 replicas is 3.5 %
TEST(ModeNoise, OfManyModesHasTheScatterOfTheModes) {
    const auto spectrum = modes(6000);
    const Array1D freedom = Array1D::Constant(6000, spectra::share_under_hann);
    for (const auto limits : {WavelengthLimits{}, WavelengthLimits{1e-7, {}}}) {  // the second: bands only
        const ModeNoiseOptions options{.limits = limits, .count = 400, .seed = 11, .threads = {2}};
        const auto found = parameters_of_noise(spectrum, freedom, options),
                   expected = one_by_one(spectrum, freedom, options);
        for (std::size_t v = 0; v < values().size(); ++v) {
            const double should = scatter(expected, values()[v]);
            if (std::isnan(should)) EXPECT_TRUE(std::isnan(values()[v](found[0]))) << v;
            else EXPECT_NEAR(scatter(found, values()[v]) / should, 1.0, 0.2) << v;
        }
    }
}

TEST(ModeNoise, HasTheSameBytesForAnyNumberOfThreads) {
    const auto spectrum = modes(5000);
    const Array1D freedom = Array1D::Ones(5000);
    const auto one = parameters_of_noise(spectrum, freedom, {.count = 5, .seed = 2, .threads = {1}}),
               four = parameters_of_noise(spectrum, freedom, {.count = 5, .seed = 2, .threads = {4}});
    for (std::size_t r = 0; r < one.size(); ++r) EXPECT_EQ(one[r].rms_curvature, four[r].rms_curvature);
}

TEST(ModeNoise, RefusesInconsistentInput) {
    auto spectrum = modes(100);
    EXPECT_THROW((void)parameters_of_noise(spectrum, Array1D::Ones(99), {}), InvalidArgument);
    EXPECT_THROW((void)parameters_of_noise(spectrum, Array1D::Zero(100), {}), InvalidArgument);
    EXPECT_THROW((void)parameters_of_noise(spectrum, Array1D::Ones(100), {.count = 0}), InvalidArgument);
    spectrum.nodes = spectra::Nodes::power_law;
    EXPECT_THROW((void)parameters_of_noise(spectrum, Array1D::Ones(100), {}), InvalidArgument);
}

}  // namespace
}  // namespace setae::roughness::mode_noise_test
