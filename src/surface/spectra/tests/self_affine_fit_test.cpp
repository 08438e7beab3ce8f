// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/self_affine_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::spectra::self_affine_fit_test {
namespace {

using spectra::SelfAffine;

/// Bins of a tenth of a decade without scatter.
CombinedSpectrum exact(const SelfAffine& model, double from, double to) {
    const auto count = static_cast<Index>(std::round(10.0 * std::log10(to / from)));
    CombinedSpectrum spectrum;
    spectrum.wavevector =
        from * (Array1D::LinSpaced(count, 0.0, static_cast<double>(count - 1)) * 0.1 * std::log(10.0)).exp();
    spectrum.density = spectra::profile_power_spectrum(model, spectrum.wavevector);
    spectrum.standard_error = 0.1 * spectrum.density;
    spectrum.count = Array1D::Constant(count, 4.0);
    spectrum.instrument_count = Array1D::Ones(count);
    return spectrum;
}

const SelfAffine surface{3e-27, 2.0 * pi / 5e-6, 0.72, 2.0 * pi / 5e-9};

TEST(SelfAffineFit, RecoversTheModelOfASpectrumWithoutScatter) {
    const auto fit = fit_self_affine(exact(surface, 1e5, 1.2e9), {.short_cutoff = true});
    EXPECT_EQ(fit.status, FitStatus::converged);
    EXPECT_NEAR(fit.hurst_exponent.estimate.value, 0.72, 1e-5);
    EXPECT_NEAR(fit.rolloff_wavelength.estimate.value / 5e-6, 1.0, 1e-4);
    EXPECT_NEAR(fit.shortest_wavelength.estimate.value / 5e-9, 1.0, 1e-3);
    EXPECT_NEAR(fit.plateau.estimate.value / 3e-27, 1.0, 1e-3);
    EXPECT_LT(fit.chi_squared, 1e-4);
    EXPECT_LT(fit.residual.abs().maxCoeff(), 1e-2);
    EXPECT_EQ(fit.rolloff, ScaleStatus::found);
    EXPECT_EQ(fit.short_cutoff, ScaleStatus::found);
    ASSERT_EQ(fit.parameters.size(), 4U);
    for (Index p = 0; p < 4; ++p) EXPECT_NEAR(fit.correlation(p, p), 1.0, 1e-12);
    EXPECT_TRUE(fit.alerts.empty());
}

TEST(SelfAffineFit, AgreesWithTheSlopeOfAPowerLaw) {
    // far below q_s and above q_r C1D ∝ q^(−1−2H), so H is known to (2 dlnC)⁻¹ …: least squares of logarithms in closed
    // form
    SelfAffine endless = surface;
    endless.rolloff_wavevector = 1.0;
    endless.plateau = 1.0;
    endless.short_wavevector = 1e15;
    const auto spectrum = exact(endless, 1e5, 1e9);
    const auto fit = fit_self_affine(spectrum, {.rolloff = false});
    EXPECT_NEAR(fit.hurst_exponent.estimate.value, 0.72, 1e-4);
    // ν = (C/SE)² = 100 a bin: SE(H) = 1/(2 √(Σ ν (x − x̄)²))
    const Array1D x = spectrum.wavevector.log() - spectrum.wavevector.log().mean();
    EXPECT_NEAR(fit.hurst_exponent.estimate.standard_error, 0.5 / std::sqrt(100.0 * x.square().sum()),
                1e-3 * fit.hurst_exponent.estimate.standard_error + 1e-6);
    EXPECT_EQ(fit.rolloff, ScaleStatus::not_asked);
    EXPECT_TRUE(std::isnan(fit.rolloff_wavelength.estimate.value));
    EXPECT_TRUE(std::isnan(fit.plateau.estimate.value));
}

TEST(SelfAffineFit, ReportsThatNoRolloffIsMeasured) {
    SelfAffine endless = surface;
    endless.rolloff_wavevector = 1e2;
    endless.plateau = 1e-14;
    const auto fit = fit_self_affine(exact(endless, 1e6, 1e8));
    EXPECT_EQ(fit.rolloff, ScaleStatus::bounded);
    ASSERT_TRUE(fit.rolloff_wavelength.estimate.interval);
    EXPECT_TRUE(std::isinf(fit.rolloff_wavelength.estimate.interval->upper));
    EXPECT_GT(fit.rolloff_wavelength.estimate.interval->lower, 2.0 * pi / 1e6 / 3.0);
    ASSERT_EQ(fit.alerts.size(), 1U);
    EXPECT_EQ(fit.alerts[0].code, "ROLLOFF_NOT_SEEN");
    EXPECT_NEAR(fit.hurst_exponent.estimate.value, 0.72, 0.01);
}

TEST(SelfAffineFit, UsesItsRangeOnly) {
    const Band range{3e6, 1e8};
    const auto fit = fit_self_affine(exact(surface, 1e5, 1e9), {.range = range, .rolloff = false});
    EXPECT_GE(fit.wavevector.minCoeff(), range.lower);
    EXPECT_LE(fit.wavevector.maxCoeff(), range.upper);
    EXPECT_NEAR(fit.hurst_exponent.estimate.value, 0.72, 0.01);
    const auto curve = model_spectrum(fit, Array1D{{1e5, 1e7, 1e9}});
    EXPECT_EQ(curve.band.lower, fit.range.lower);
    EXPECT_EQ(curve.band.upper, fit.range.upper);
    EXPECT_TRUE(curve.band.lower > 1e5 && curve.band.lower < 1e7 && curve.band.upper > 1e7 && curve.band.upper < 1e9);
    EXPECT_LT(curve.standard_error[1] / curve.density[1], curve.standard_error[2] / curve.density[2]);
    EXPECT_NEAR(curve.density[1], spectra::profile_power_spectrum(surface, Array1D::Constant(1, 1e7))[0],
                0.05 * curve.density[1]);
}

TEST(SelfAffineFit, WidensItsErrorsForAPoorFit) {
    auto spectrum = exact(surface, 1e5, 1e9);
    for (Index b = 0; b < spectrum.density.size(); ++b) spectrum.density[b] *= b % 2 == 0 ? 1.6 : 0.6;
    spectrum.standard_error = 0.1 * spectrum.density;
    const auto fit = fit_self_affine(spectrum), plain = fit_self_affine(exact(surface, 1e5, 1e9));
    ASSERT_FALSE(fit.alerts.empty());
    EXPECT_EQ(fit.alerts.back().code, "MODEL_MISSES");
    EXPECT_GT(fit.hurst_exponent.estimate.standard_error, 2.0 * plain.hurst_exponent.estimate.standard_error);
}

TEST(SelfAffineFit, DoesNotDependOnTheUnitOfLength) {
    const double unit = 1e3;
    SelfAffine larger{surface.plateau * std::pow(unit, 4), surface.rolloff_wavevector / unit, surface.hurst_exponent,
                      surface.short_wavevector / unit};
    const auto a = fit_self_affine(exact(surface, 1e5, 1e8)), b = fit_self_affine(exact(larger, 1e2, 1e5));
    EXPECT_NEAR(a.hurst_exponent.estimate.value, b.hurst_exponent.estimate.value, 1e-6);
    EXPECT_NEAR(a.rolloff_wavelength.estimate.value * unit / b.rolloff_wavelength.estimate.value, 1.0, 1e-5);
}

TEST(SelfAffineFit, OfTheModesOfOneMapAccountsForWindowAndAliases) {
    // sampled from a surface that continues beyond its pixels
    const SelfAffine model{1e-27, 2.0 * pi / 4e-7, 0.8, 2.0 * pi / 5e-9};
    const auto whole = synthesis::random_surface(spectra::density(model), {1024, 1024, 4e-6, 4e-6}, {.key = {3, 0}});
    topography::HeightMap map{Array2D(128, 128), {2e-6, 2e-6}, false, {}};
    for (Index i = 0; i < 128; ++i)
        for (Index j = 0; j < 128; ++j) map.heights(i, j) = whole.heights(4 * i, 4 * j);
    SpectrumOptions options;
    options.trend = topography::Trend::tilt;
    const auto spectrum = power_spectrum(map, options);
    const auto fit = fit_self_affine(spectrum, {.range = Band{spectrum.band.lower, spectrum.band.upper}});
    const auto& H = fit.hurst_exponent.estimate;
    EXPECT_NEAR(H.value, 0.8, 3.0 * H.standard_error);
    EXPECT_LT(H.standard_error, 0.05);
    const auto& interval = *fit.rolloff_wavelength.estimate.interval;
    EXPECT_LT(interval.lower, 4e-7);
    EXPECT_GT(interval.upper, 4e-7);
}

/// Modes of a line of a length without scatter, up to a wavevector.
MeasuredSpectrum modes_of(const SelfAffine& model, double length, double upper) {
    const double lowest = 2.0 * pi / length;
    const auto count = static_cast<Index>(upper / lowest);
    MeasuredSpectrum spectrum;
    spectrum.wavevector = Array1D::LinSpaced(count, lowest, lowest * static_cast<double>(count));
    spectrum.density = spectra::profile_power_spectrum(model, spectrum.wavevector);
    spectrum.standard_error = Array1D::Constant(count, undefined);
    spectrum.count = Array1D::Ones(count);
    spectrum.band.lower = lowest;
    spectrum.band.upper = upper;
    spectrum.length = length;
    spectrum.window = "none";
    return spectrum;
}

TEST(SelfAffineFit, OfMeasurementsWithoutCommonBinUsesAllModes) {
    // a scan with the plateau and one with the power law: neither determines the roll-off alone, both together do
    auto endless = surface;
    endless.short_wavevector = 1e13;
    const std::array<MeasuredSpectrum, 2> apart{modes_of(endless, 1e-3, 4e6), modes_of(endless, 2e-6, 3e8)};
    const auto fit = fit_self_affine(apart);
    EXPECT_EQ(fit.status, FitStatus::converged);
    EXPECT_NEAR(fit.hurst_exponent.estimate.value, 0.72, 0.02);
    EXPECT_NEAR(fit.rolloff_wavelength.estimate.value / 5e-6, 1.0, 0.1);
    EXPECT_LT(fit.range.lower, 1e4);
    EXPECT_GT(fit.range.upper, 5e7);
    EXPECT_THROW((void)fit_self_affine(std::span<const MeasuredSpectrum>{}), InvalidArgument);
}

TEST(SelfAffineFit, RefusesInvalidData) {
    const auto spectrum = exact(surface, 1e5, 1e9);
    EXPECT_THROW((void)fit_self_affine(spectrum, {.range = Band{1e6, 1.5e6}}), InvalidArgument);
    EXPECT_THROW((void)fit_self_affine(spectrum, {.range = Band{1e6, 1e5}}), InvalidArgument);
    EXPECT_THROW((void)fit_self_affine(spectrum, {.level = 1.0}), InvalidArgument);
    auto alone = spectrum;
    alone.standard_error.setConstant(undefined);
    EXPECT_THROW((void)fit_self_affine(alone), UndefinedDataError);
    const std::array<FittedValues, 1> uneven{FittedValues{Array1D::Ones(5), Array1D::Ones(4), Array1D::Ones(5),
                                                          [](const SelfAffine&) { return Array1D::Ones(5).eval(); }}};
    EXPECT_THROW((void)fit_self_affine(uneven), InvalidArgument);
}

TEST(SelfAffineFit, ReportsThatNoShortCutoffIsMeasured) {
    const auto fit = fit_self_affine(exact(surface, 1e5, 1e8), {.short_cutoff = true});  // waves end at 1.3e9 1/m
    EXPECT_EQ(fit.short_cutoff, ScaleStatus::bounded);
    ASSERT_EQ(fit.alerts.size(), 1U);
    EXPECT_EQ(fit.alerts[0].code, "CUTOFF_NOT_SEEN");
    EXPECT_NEAR(fit.hurst_exponent.estimate.value, 0.72, 0.01);
}

bool has_alert(const SelfAffineFit& fit, const char* code) {
    return std::any_of(fit.alerts.begin(), fit.alerts.end(), [=](const Alert& alert) { return alert.code == code; });
}

TEST(SelfAffineFit, WarnsOfReliableValuesOutsideItsRangeThatDeviate) {
    // 1024 modes of a line: the power law steepens above 0.3 of the highest wavevector
    auto endless = surface;
    endless.short_wavevector = 1e13;
    auto good = modes_of(endless, 1e-4, 6.4e7);
    good.count.setConstant(256.0);
    good.pitch = 1e-7;
    EXPECT_FALSE(has_alert(fit_self_affine(good), "MODEL_MISSES_BEYOND"));
    auto bad = good;
    for (Index k = 0; k < bad.density.size(); ++k)
        bad.density[k] *= std::pow(std::max(1.0, bad.wavevector[k] / 1.6e7), -2.0);
    const auto fit = fit_self_affine(bad);
    EXPECT_NEAR(fit.hurst_exponent.estimate.value, 0.72, 0.02);
    EXPECT_TRUE(has_alert(fit, "MODEL_MISSES_BEYOND"));
    // a given range excludes values deliberately
    EXPECT_FALSE(has_alert(fit_self_affine(bad, {.range = Band{1e6, 1.5e7}}), "MODEL_MISSES_BEYOND"));
}

TEST(SelfAffineFit, GivesFewFalseWarningsOutsideItsRange) {
    int alarms = 0;
    const int maps = 100;
    for (int m = 0; m < maps; ++m) {
        const double H = 0.5 + 0.4 * m / maps;
        const SelfAffine model{1e-27, 2.0 * pi / 1e-6, H, 2.0 * pi / 5e-9};
        const auto whole = synthesis::random_surface(spectra::density(model), {256, 256, 4e-6, 4e-6},
                                                     {.key = {static_cast<std::uint64_t>(m), 0}});
        const topography::HeightMap map{whole.heights.topLeftCorner(128, 128), {2e-6, 2e-6}, false, {}};
        SpectrumOptions options;
        options.trend = topography::Trend::tilt;
        const auto fit = fit_self_affine(std::array<MeasuredSpectrum, 1>{power_spectrum(map, options)});
        if (has_alert(fit, "MODEL_MISSES_BEYOND") || has_alert(fit, "FIT_AT_BOUND")) ++alarms;
    }
    EXPECT_LE(alarms, 2);
}

TEST(SelfAffineFit, NamesTheBoundThatItReaches) {
    auto steep = exact(surface, 1e7, 1e9);
    steep.density = steep.wavevector.pow(-6.0);
    steep.standard_error = 0.1 * steep.density;
    const auto fit = fit_self_affine(steep, {.rolloff = false});
    ASSERT_TRUE(has_alert(fit, "FIT_AT_BOUND"));
    EXPECT_NE(fit.alerts.front().message.find("hurst_exponent ended at the largest value allowed, 1.45"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::spectra::self_affine_fit_test
