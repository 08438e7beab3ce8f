// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/roughness/spectral_moments.hpp"
#include "setae/spectra/self_affine.hpp"

namespace setae::conversion_test {
namespace {

/// C1D of a self-affine surface with q_s/q_r = 1000 on nodes that crowd at q_s, where it falls to zero.
spectra::Spectrum lines_on(const spectra::SelfAffine& model) {
    const double q_s = model.short_wavevector;
    const auto spaced = [](double from, double to, Index n) -> Array1D {
        return Array1D::LinSpaced(n, std::log(from), std::log(to)).exp();
    };
    Array1D q(6000);
    q << spaced(1e-5 * q_s, 0.9 * q_s, 3000), q_s * (1.0 - spaced(1e-9, 0.0999, 3000).reverse());
    return {q, spectra::profile_power_spectrum(model, q), {q[0], q_s}};
}

struct Ratios {
    double hurst, height2, energy, slope2, curvature2;
};

class Eq11AgainstExact : public testing::TestWithParam<Ratios> {};

TEST_P(Eq11AgainstExact, HasTheBiasOfTheorySection41) {
    const auto& expected = GetParam();
    const auto curve = lines_on({1.0, 1.0, expected.hurst, 1000.0});
    const auto exact = roughness::spectral_parameters(curve, roughness::Conversion::exact);
    const auto eq11 = roughness::spectral_parameters(curve, roughness::Conversion::eq11);
    const auto square = [](double x) { return x * x; };
    EXPECT_NEAR(square(eq11.rms_height / exact.rms_height), expected.height2, 0.01 * expected.height2);
    EXPECT_NEAR(eq11.elastic_energy_per_modulus / exact.elastic_energy_per_modulus, expected.energy,
                0.01 * expected.energy);
    EXPECT_NEAR(square(eq11.rms_slope / exact.rms_slope), expected.slope2, 0.01 * expected.slope2);
    EXPECT_NEAR(square(eq11.rms_curvature / exact.rms_curvature), expected.curvature2, 0.01 * expected.curvature2);
}

INSTANTIATE_TEST_SUITE_P(HurstExponents, Eq11AgainstExact,
                         testing::Values(Ratios{0.3, 1.574, 1.115, 1.062, 1.033},
                                         Ratios{0.5, 1.571, 1.042, 1.000, 1.000},
                                         Ratios{0.8, 1.571, 1.003, 0.891, 0.945},
                                         Ratios{0.9, 1.571, 1.001, 0.855, 0.925}));

}  // namespace
}  // namespace setae::conversion_test
