// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/inverse_abel.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/roughness/spectral_moments.hpp"
#include "setae/spectra/self_affine.hpp"

namespace setae::roughness::inverse_abel_test {
namespace {

TEST(InverseAbel, KeepsTheMomentsOfTheSurface) {
    const spectra::SelfAffine model{1e-26, 1e6, 0.8, 1e12};
    const Array1D q = (Array1D::LinSpaced(161, std::log(1e4), std::log(1e8))).exp();
    const Array1D C1D = spectra::profile_power_spectrum(model, q);
    const auto isotropic = spectra::isotropic_from_lines(q, C1D);
    const Band band{1e4, 1e8};
    const auto from_C_iso = spectral_parameters({q, isotropic.density, band, spectra::Density::C_iso});
    const auto truth =
        spectral_parameters({q, spectra::isotropic_power_spectrum(model, q), band, spectra::Density::C_iso});
    EXPECT_NEAR(from_C_iso.rms_height / truth.rms_height, 1.0, 0.01);
    EXPECT_NEAR(from_C_iso.rms_slope / truth.rms_slope, 1.0, 0.01);
    EXPECT_NEAR(from_C_iso.rms_curvature / truth.rms_curvature, 1.0, 0.01);
    EXPECT_NEAR(from_C_iso.elastic_energy_per_modulus / truth.elastic_energy_per_modulus, 1.0, 0.01);
    // of C1D: lines contain all waves across them, the whole band except for waves beyond its end
    const auto from_C1D = spectral_parameters({q, C1D, band, spectra::Density::C1D});
    EXPECT_NEAR(from_C_iso.rms_height / from_C1D.rms_height, 1.0, 0.01);
    EXPECT_NEAR(from_C_iso.elastic_energy_per_modulus / from_C1D.elastic_energy_per_modulus, 1.0, 0.05);
}

}  // namespace
}  // namespace setae::roughness::inverse_abel_test
