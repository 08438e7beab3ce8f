// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/parametric_noise.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::spectra::parametric_noise_test {
namespace {

MeasuredSpectrum three_modes() {
    MeasuredSpectrum spectrum;
    spectrum.wavevector = Array1D::LinSpaced(3, 1e6, 3e6);
    spectrum.density = Array1D(3);
    spectrum.density << 4e-21, 2e-21, 1e-21;
    return spectrum;
}

// The errors from 4000 replicas are √(1/4000ν) for a mean and √((2 + 6/ν)/4000) for a variance of a gamma variate.
TEST(ParametricNoise, HasTheMeanAndTheVarianceOfAPeriodogram) {
    Array1D freedom(3);
    freedom << 0.514, 1.0, 20.0;
    constexpr Index count = 4000;
    const auto spectrum = three_modes();
    const Array2D replicas = parametric_noise(spectrum, freedom, count, 3);
    for (Index k = 0; k < 3; ++k) {
        const Array1D ratio = replicas.col(k) / spectrum.density[k];
        EXPECT_NEAR(ratio.mean(), 1.0, 4.0 / std::sqrt(count * freedom[k]));
        EXPECT_NEAR((ratio - ratio.mean()).square().mean() * freedom[k], 1.0,
                    4.0 * std::sqrt((2.0 + 6.0 / freedom[k]) / count));
    }
}

TEST(ParametricNoise, StartsEquallyForTheSameSeed) {
    const Array1D freedom = Array1D::Ones(3);
    const Array2D few = parametric_noise(three_modes(), freedom, 3, 5),
                  many = parametric_noise(three_modes(), freedom, 7, 5);
    EXPECT_TRUE((many.topRows(3) == few).all());
    EXPECT_FALSE((parametric_noise(three_modes(), freedom, 3, 6) == few).any());
}

TEST(ParametricNoise, RefusesInconsistentInput) {
    EXPECT_THROW((void)parametric_noise(three_modes(), Array1D::Ones(2), 3, 1), InvalidArgument);
    EXPECT_THROW((void)parametric_noise(three_modes(), Array1D::Zero(3), 3, 1), InvalidArgument);
    EXPECT_THROW((void)parametric_noise(three_modes(), Array1D::Ones(3), 0, 1), InvalidArgument);
}

}  // namespace
}  // namespace setae::spectra::parametric_noise_test
