// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/independent_lines.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace setae::spectral_fit::independent_lines_test {
namespace {

// C = exp(−q² l²): lines a distance y apart have ρ = exp(−y²/4l²) at every q, so n = N²/Σ exp(−y²/2l²).
TEST(IndependentLines, OfAGaussianSpectrumMatchTheClosedForm) {
    constexpr double length = 40e-9, pitch = 4e-9;
    constexpr Index lines = 128;
    const auto C_iso = [](double q) { return std::exp(-q * q * length * length); };
    double sum = 0.0;
    for (Index i = 0; i < lines; ++i)
        for (Index j = 0; j < lines; ++j)
            sum += std::exp(-std::pow(static_cast<double>(i - j) * pitch / length, 2) / 2.0);
    Array1D q(2);
    q << 0.2 / length, 1.0 / length;
    const Array1D found = independent_lines(C_iso, q, Array1D::Ones(2), lines, pitch);
    for (Index k = 0; k < 2; ++k) EXPECT_NEAR(found[k] * sum / static_cast<double>(lines * lines), 1.0, 0.02) << q[k];
}

TEST(IndependentLines, AreAllLinesForNoiseAndOneForAConstant) {
    const auto C_iso = [](double q) { return q < 1e6 ? 1.0 : 0.0; };
    const Array1D q = Array1D::Constant(1, 5e5);
    EXPECT_NEAR(independent_lines(C_iso, q, Array1D::Zero(1), 64, 1e-9)[0], 64.0, 1e-9);
    EXPECT_NEAR(independent_lines(C_iso, q, Array1D::Ones(1), 64, 1e-9)[0], 1.0, 1e-3);
}

}  // namespace
}  // namespace setae::spectral_fit::independent_lines_test
