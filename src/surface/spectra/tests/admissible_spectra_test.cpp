// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/admissible_spectra.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::spectra::admissible_spectra_test {
namespace {

constexpr double q_s = 1e10;
const SelfAffine surface{1e-28, 1e7, 0.7, q_s};

/// Moments of the surface, each with this relative standard error.
StatedMoments stated(double relative) {
    const auto with = [=](double value) { return Estimate{value, relative * value, "given"}; };
    return {with(rms_height(surface)), with(rms_slope(surface)), with(rms_curvature(surface)), Estimate{q_s, 0.0}};
}

TEST(AdmissibleSpectra, OfExactMomentsEqualTheSpectrum) {
    const auto drawn = admissible_spectra(stated(0.0), 3, 1);
    ASSERT_EQ(drawn.draws.size(), 3U);
    EXPECT_DOUBLE_EQ(drawn.share, 1.0);
    EXPECT_NEAR(drawn.draws[2].hurst_exponent, 0.7, 1e-6);
    EXPECT_NEAR(drawn.draws[2].rolloff_wavevector / 1e7, 1.0, 1e-5);
}

TEST(AdmissibleSpectra, OfSmallErrorsHaveTheStatedScatter) {
    const double relative = 0.01;
    const auto drawn = admissible_spectra(stated(relative), 4000, 2);
    double mean = 0.0, square = 0.0;
    for (const auto& model : drawn.draws) {
        const double ratio = rms_slope(model) / rms_slope(surface);
        mean += ratio / 4000.0;
        square += ratio * ratio / 4000.0;
    }
    EXPECT_NEAR(mean, 1.0, 4.0 * relative / std::sqrt(4000.0));
    EXPECT_NEAR(std::sqrt(square - mean * mean) / relative, 1.0, 0.05);
    EXPECT_GT(drawn.share, 0.99);
}

TEST(AdmissibleSpectra, OfWideErrorsAreAllPossibleSpectra) {
    // UNCD of Dalvi et al. 2019: slope + 1 standard error gives H > 1
    const StatedMoments uncd{
        {23.4e-9, 1.3e-9, "given"}, {1.46, 0.36, "given"}, {3.37e9, 0.69e9, "given"}, {1.57e10, 0.0}};
    const auto drawn = admissible_spectra(uncd, 500, 3);
    EXPECT_LT(drawn.share, 0.99);
    for (const auto& model : drawn.draws) {
        EXPECT_GT(model.hurst_exponent, 0.0);
        EXPECT_LT(model.hurst_exponent, 1.0);
        EXPECT_LT(model.rolloff_wavevector, model.short_wavevector);
        EXPECT_GT(moment(model, 1.0), 0.0);
    }
}

TEST(AdmissibleSpectra, OfMoreDrawsStartWithTheSameDraws) {
    const auto few = admissible_spectra(stated(0.1), 5, 7), many = admissible_spectra(stated(0.1), 50, 7);
    for (std::size_t i = 0; i < few.draws.size(); ++i)
        EXPECT_EQ(few.draws[i].hurst_exponent, many.draws[i].hurst_exponent);
}

TEST(AdmissibleSpectra, OfContradictoryMomentsAreRefused) {
    auto moments = stated(0.01);
    moments.rms_curvature.value *= 1e3;
    moments.rms_curvature.standard_error *= 1e3;
    EXPECT_THROW((void)admissible_spectra(moments, 10, 1), InvalidArgument);
    EXPECT_THROW((void)admissible_spectra(stated(0.1), 0, 1), InvalidArgument);
    moments.rms_height.value = -1.0;
    EXPECT_THROW((void)admissible_spectra(moments, 10, 1), InvalidArgument);
}

}  // namespace
}  // namespace setae::spectra::admissible_spectra_test
