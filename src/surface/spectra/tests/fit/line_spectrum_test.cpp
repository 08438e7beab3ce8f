// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/line_spectrum.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectral_fit/hat_node.hpp"

namespace setae::spectral_fit::line_spectrum_test {
namespace {

Array1D nodes_up_to(double shortest, Index count) {
    return shortest * (Array1D::LinSpaced(count, static_cast<double>(1 - count), 0.0) * node_spacing).exp();
}

// C_iso = q^-4 has C1D = q^-3/4. Its mean over a cell exceeds that by h²/8 (h²/24 α(α − 2), α = 3), and chords of q^2
// C_iso between nodes are above the curve by h²/3 (h²/12 of the second derivative 4).
TEST(LineSpectrum, OfAPowerLawMatchesTheClosedForm) {
    const Array1D q = nodes_up_to(1e10, 240);
    const Array1D C1D = line_spectrum(q, q.pow(-4.0));
    const double excess = node_spacing * node_spacing * (1.0 / 8.0 + 1.0 / 3.0);
    for (const Index b : {60, 100, 140}) EXPECT_NEAR(C1D[b] * 4.0 * std::pow(q[b], 3.0), 1.0 + excess, 1e-5) << q[b];
}

// Constant up to q_s: C1D = √(q_s² − q²)/π.
TEST(LineSpectrum, OfADiscIsASemicircle) {
    const Array1D q = nodes_up_to(2.0, 200);
    const Array1D C1D = line_spectrum(q, Array1D::Ones(q.size()));
    for (const Index b : {0, 1, 50, 150, 190}) EXPECT_NEAR(C1D[b], std::sqrt(4.0 - q[b] * q[b]) / pi, 2e-3) << q[b];
}

// ∫ C1D dq/π = ∫ C_iso q dq/2π: the variance of a line is that of the surface.
TEST(LineSpectrum, KeepsTheVariance) {
    const Array1D q = nodes_up_to(1e9, 200);
    const Array1D C_iso = (1.0 + (q / 1e7).square()).pow(-1.8);
    const Array1D C1D = line_spectrum(q, C_iso);
    const double cell = 2.0 * std::sinh(0.5 * node_spacing);
    const double below = q[0] * std::exp(-0.5 * node_spacing) * C1D[0];
    double surface = 0.5 * q[0] * q[0] * C_iso[0];
    for (Index i = 1; i < q.size(); ++i)
        surface += 0.5 * node_spacing * (C_iso[i - 1] * q[i - 1] * q[i - 1] + C_iso[i] * q[i] * q[i]);
    EXPECT_NEAR(((C1D * q).sum() * cell + below) / pi, surface / (2.0 * pi), 2e-3 * surface / (2.0 * pi));
}

TEST(LineSpectrum, RefusesOtherRatiosAndSizes) {
    EXPECT_THROW((void)line_spectrum(Array1D::LinSpaced(5, 1.0, 5.0), Array1D::Ones(5)), InvalidArgument);
    EXPECT_THROW((void)line_spectrum(nodes_up_to(1.0, 5), Array1D::Ones(4)), InvalidArgument);
}

}  // namespace
}  // namespace setae::spectral_fit::line_spectrum_test
