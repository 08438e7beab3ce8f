// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/combination.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/bootstrap.hpp"

namespace combination_test {

using namespace setae;
using namespace setae::spectra;

/// C = level q^slope at modes from lower to upper.
MeasuredSpectrum power_law(double level, double slope, double lower, double upper,
                           const std::string& instrument = "afm") {
    MeasuredSpectrum spectrum;
    const auto modes = static_cast<Index>(std::floor(upper / lower * (1.0 + 1e-12)));
    spectrum.wavevector = Array1D::LinSpaced(modes, 1.0, static_cast<double>(modes)) * lower;
    spectrum.density = level * spectrum.wavevector.pow(slope);
    spectrum.standard_error = Array1D::Constant(modes, undefined);
    spectrum.count = Array1D::Ones(modes);
    spectrum.band.lower = lower;
    spectrum.band.upper = upper;
    spectrum.length = 2.0 * pi / lower;
    spectrum.metadata.instrument.type = instrument;
    return spectrum;
}

MeasuredSpectrum noisy(unsigned seed, double lower = 1.0, const std::string& instrument = "afm") {
    auto spectrum = power_law(1.0, -2.0, lower, 100.0 * lower, instrument);
    spectrum.density *= tests::random_heights(spectrum.density.size(), seed).square();
    return spectrum;
}

bool has_alert(const CombinedSpectrum& spectrum, const std::string& code) {
    return std::any_of(spectrum.alerts.begin(), spectrum.alerts.end(),
                       [&](const Alert& alert) { return alert.code == code; });
}

TEST(Combine, OfIdenticalMembersEqualsTheMember) {
    const std::vector<MeasuredSpectrum> one{noisy(1)}, four(4, noisy(1));
    const auto single = combine(one), many = combine(four);
    EXPECT_LT(((many.density - single.density) / single.density).abs().maxCoeff(), 1e-14);
    EXPECT_TRUE((many.count == 4.0).all());
    EXPECT_LT((many.standard_error / single.density).maxCoeff(), 1e-14);
    EXPECT_TRUE(single.standard_error.isNaN().all());
}

TEST(Combine, IsTheArithmeticMeanOverMeasurements) {
    const std::vector<MeasuredSpectrum> spectra{power_law(1.0, -2.0, 1.0, 100.0), power_law(3.0, -2.0, 1.0, 100.0),
                                                power_law(8.0, -2.0, 1.0, 100.0)};
    const auto combined = combine(spectra);
    const Array1D expected = 4.0 * combine(std::vector<MeasuredSpectrum>{spectra[0]}).density;
    EXPECT_LT((combined.density / expected - 1.0).abs().maxCoeff(), 1e-12);
    // standard deviation of 1, 3, 8 is √13
    EXPECT_LT((combined.standard_error / expected - std::sqrt(13.0 / 3.0) / 4.0).abs().maxCoeff(), 1e-12);
}

TEST(Combine, DoesNotDependOnTheOrderOfMeasurements) {
    std::vector<MeasuredSpectrum> spectra;
    for (unsigned seed = 0; seed < 6; ++seed)
        spectra.push_back(noisy(seed, seed % 2 ? 1.0 : 7.3, seed % 2 ? "afm" : "tem"));
    for (const auto weighting : {Weighting::equal, Weighting::per_instrument, Weighting::inverse_variance}) {
        const auto forward = combine(spectra, {.weighting = weighting});
        std::vector<MeasuredSpectrum> reversed(spectra.rbegin(), spectra.rend());
        const auto backward = combine(reversed, {.weighting = weighting});
        EXPECT_LT(((forward.density - backward.density) / forward.density).abs().maxCoeff(), 1e-13);
    }
}

TEST(Combine, BinsAreTheSameForAllDataAndAlignedToDecades) {
    const std::vector<MeasuredSpectrum> spectra{power_law(1.0, -1.0, 0.013, 20.0), power_law(1.0, -1.0, 1e5, 3e7)};
    const auto combined = combine(spectra);
    for (const double q : combined.wavevector) {
        const double place = 10.0 * std::log10(q) - 0.5;
        EXPECT_NEAR(place, std::round(place), 1e-9);
    }
    EXPECT_NEAR(combined.band.lower, 0.013, 1e-12);
    EXPECT_NEAR(combined.band.upper, 3e7, 1e5);
}

TEST(Combine, RecoversASteepPowerLawAtTheCentresOfItsBins) {
    for (const double slope : {0.0, -1.6, -3.0, -5.0}) {
        const std::vector<MeasuredSpectrum> spectra{power_law(2.0, slope, 1.0, 300.0),
                                                    power_law(2.0, slope, 17.0, 3000.0)};
        const auto combined = combine(spectra), plain = combine(spectra, {.slope_correction = false});
        const Array1D truth = 2.0 * combined.wavevector.pow(slope);
        EXPECT_LT((combined.density / truth - 1.0).abs().maxCoeff(), 1e-3) << slope;
        if (slope < -1.0) {
            EXPECT_GT((plain.density / truth - 1.0).abs().maxCoeff(), 0.1) << slope;
        }
    }
}

TEST(Combine, UsesEachMeasurementInItsReliableBandOnly) {
    auto low = power_law(1.0, 0.0, 1.0, 1000.0), high = power_law(5.0, 0.0, 1.0, 1000.0);
    low.band.upper = 30.0;
    high.band.lower = 50.0;
    const std::vector<MeasuredSpectrum> spectra{low, high};
    const auto combined = combine(spectra, {.slope_correction = false});
    for (Index b = 0; b < combined.wavevector.size(); ++b)
        EXPECT_NEAR(combined.density[b], combined.wavevector[b] < 35.0 ? 1.0 : 5.0, 1e-9);
    EXPECT_TRUE(has_alert(combined, "COVERAGE_GAP"));
}

TEST(Combine, PerInstrumentWeightsCountManyScansAsOne) {
    std::vector<MeasuredSpectrum> spectra(9, power_law(1.0, 0.0, 1.0, 100.0, "stylus"));
    spectra.push_back(power_law(3.0, 0.0, 1.0, 100.0, "afm"));
    EXPECT_NEAR(combine(spectra, {.weighting = Weighting::equal}).density[5], 1.2, 1e-12);
    EXPECT_NEAR(combine(spectra, {.weighting = Weighting::per_instrument}).density[5], 2.0, 1e-12);
    EXPECT_EQ(combine(spectra).instrument_count[5], 2.0);
}

TEST(Combine, InverseVarianceFavoursMeasurementsWithMoreModes) {
    // for a hundred times the length: a hundred times the modes
    const std::vector<MeasuredSpectrum> spectra{power_law(1.0, 0.0, 1.0, 100.0), power_law(2.0, 0.0, 0.01, 100.0)};
    const auto combined = combine(spectra, {.weighting = Weighting::inverse_variance, .slope_correction = false});
    const Index last = combined.density.size() - 2;
    EXPECT_NEAR(combined.density[last], (1.0 + 2.0 * 100.0) / 101.0, 0.01);
}

TEST(Combine, WarnsOfSingleInstrumentDecadesAndDisagreement) {
    std::vector<MeasuredSpectrum> spectra;
    for (const double level : {1.0, 1.1, 0.9}) {
        spectra.push_back(power_law(level, 0.0, 1.0, 100.0, "stylus"));
        spectra.push_back(power_law(2.0 * level, 0.0, 10.0, 1000.0, "afm"));
    }
    const auto combined = combine(spectra);
    EXPECT_TRUE(has_alert(combined, "SINGLE_INSTRUMENT_DECADE"));
    EXPECT_TRUE(has_alert(combined, "DISAGREE"));
    for (auto& spectrum : spectra)
        if (spectrum.metadata.instrument.type == "afm") spectrum.density *= 0.5;
    EXPECT_FALSE(has_alert(combine(spectra), "DISAGREE"));
}

TEST(Combine, OfNoDataIsRefused) {
    EXPECT_THROW((void)combine(std::vector<MeasuredSpectrum>{}), InvalidArgument);
    auto hidden = power_law(1.0, 0.0, 1.0, 10.0);
    hidden.band.upper = 0.1;
    EXPECT_THROW((void)combine(std::vector<MeasuredSpectrum>{hidden}), InvalidArgument);
}

TEST(Bootstrap, OfIdenticalMeasurementsEqualsTheCombination) {
    const std::vector<MeasuredSpectrum> spectra(3, noisy(2));
    const auto members = binned(spectra);
    const auto curves = bootstrap(members, {.resamples = 20});
    const auto combined = combine(members);
    EXPECT_LT((curves.C1D.rowwise() / combined.density.transpose() - 1.0).abs().maxCoeff(), 1e-13);
}

TEST(Bootstrap, ScatterIsTheStandardErrorOfTheMean) {
    std::vector<MeasuredSpectrum> spectra;
    for (unsigned seed = 0; seed < 12; ++seed) spectra.push_back(noisy(seed));
    const auto members = binned(spectra);
    const auto curves = bootstrap(members, {.resamples = 4000});
    const auto combined = combine(members);
    const Array1D mean = curves.C1D.colwise().mean().transpose();
    const Array1D deviation = (curves.C1D.rowwise() - mean.transpose()).square().colwise().mean().sqrt().transpose();
    EXPECT_LT((mean / combined.density - 1.0).abs().maxCoeff(), 0.03);
    // resampling n values scatters by √((n−1)/n) of the standard error
    EXPECT_LT((deviation / combined.standard_error / std::sqrt(11.0 / 12.0) - 1.0).abs().maxCoeff(), 0.05);
}

TEST(Bootstrap, FillsMissingBinsWithTheShapeOfTheFullCombination) {
    // only the second member covers the middle and the end; without it, the first gives its level
    auto first = power_law(1.0, -2.0, 1.0, 10.0), second = power_law(4.0, -2.0, 1.0, 100.0);
    const std::vector<MeasuredSpectrum> spectra{first, second};
    const auto members = binned(spectra, {.slope_correction = false});
    const auto curves = bootstrap(members, {.resamples = 50});
    const auto full = combine(members);
    EXPECT_FALSE(curves.C1D.isNaN().any());
    EXPECT_GT(curves.filled_share[full.density.size() - 1], 0.05);
    const Index last = full.density.size() - 1;
    for (Index r = 0; r < 50; ++r)
        if (std::abs(curves.C1D(r, 0) / full.density[0] - 0.4) < 1e-9) {
            EXPECT_NEAR(curves.C1D(r, last) / full.density[last], curves.C1D(r, 9) / full.density[9], 1e-12);
        }
}

TEST(Bootstrap, StratifiedDrawsIncludeEveryInstrument) {
    std::vector<MeasuredSpectrum> spectra{power_law(1.0, 0.0, 1.0, 10.0, "stylus"),
                                          power_law(1.0, 0.0, 1.0, 10.0, "stylus"),
                                          power_law(1.0, 0.0, 100.0, 1000.0, "tem")};
    EXPECT_GT(bootstrap(binned(spectra), {.resamples = 100}).filled_share.maxCoeff(), 0.1);
    EXPECT_EQ(bootstrap(binned(spectra), {.resamples = 100, .draw = Draw::within_instruments}).filled_share.maxCoeff(),
              0.0);
}

TEST(Bootstrap, GivesTheSameBytesForASeedAndAnyNumberOfThreads) {
    std::vector<MeasuredSpectrum> spectra;
    for (unsigned seed = 0; seed < 5; ++seed) spectra.push_back(noisy(seed));
    const auto members = binned(spectra);
    const auto one = bootstrap(members, {.resamples = 64, .seed = 7, .threads = {1}});
    const auto three = bootstrap(members, {.resamples = 64, .seed = 7, .threads = {3}});
    const auto other = bootstrap(members, {.resamples = 64, .seed = 8, .threads = {1}});
    EXPECT_TRUE((one.C1D == three.C1D).all());
    EXPECT_FALSE((one.C1D == other.C1D).all());
    EXPECT_THROW((void)bootstrap(members, {.resamples = 0}), InvalidArgument);
}

}  // namespace combination_test
