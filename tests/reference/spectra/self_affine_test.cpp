// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/self_affine.hpp"

#include <array>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"

namespace self_affine_test {

using namespace setae;
using namespace setae::spectra;

struct Surface {
    const char* name;
    double height, slope, curvature;                   // Table S1 [m], [1], [1/m]
    double hurst, rolloff_wavelength, energy;          // at q_s = 1.6e10 1/m; U_el/(A E*) [m]
    double hurst_at_4_angstrom, energy_at_4_angstrom;  // at q_s = 2π/4 Å
};

constexpr std::array<Surface, 4> surfaces{
    {{"polished UNCD", 4.6e-9, 0.39, 1.13e9, 0.883, 0.287e-6, 0.177e-9, 0.874, 0.173e-9},
     {"UNCD", 23.4e-9, 1.46, 3.37e9, 0.977, 0.282e-6, 4.16e-9, 0.971, 4.10e-9},
     {"NCD", 121.7e-9, 1.15, 3.19e9, 0.879, 3.76e-6, 9.57e-9, 0.872, 9.24e-9},
     {"MCD", 126.6e-9, 1.07, 2.83e9, 0.896, 3.81e-6, 9.97e-9, 0.890, 9.66e-9}}};

/// U_el/(A E*) = (1/8π) ∫ q² C_iso dq.
double energy(const SelfAffine& model) { return moment(model, 1.0) / (8.0 * pi); }

TEST(SelfAffineNanodiamond, FollowsFromThePublishedMoments) {
    for (const auto& surface : surfaces) {
        const auto model = self_affine_with_moments(surface.height, surface.slope, surface.curvature, 1.6e10);
        EXPECT_NEAR(model.hurst_exponent, surface.hurst, 0.0005) << surface.name;
        EXPECT_NEAR(2.0 * pi / model.rolloff_wavevector / surface.rolloff_wavelength, 1.0, 0.002) << surface.name;
        EXPECT_NEAR(energy(model) / surface.energy, 1.0, 0.003) << surface.name;
    }
}

TEST(SelfAffineNanodiamond, FollowsFromThePublishedMomentsUpToFourAngstrom) {
    for (const auto& surface : surfaces) {
        const auto model = self_affine_with_moments(surface.height, surface.slope, surface.curvature,
                                                    2.0 * pi / (4.0 * units::angstrom));
        EXPECT_NEAR(model.hurst_exponent, surface.hurst_at_4_angstrom, 0.0006) << surface.name;
        EXPECT_NEAR(energy(model) / surface.energy_at_4_angstrom, 1.0, 0.003) << surface.name;
    }
}

TEST(SelfAffineNanodiamond, LaterModelOfNcdHasThePublishedMoments) {
    const SelfAffine model{5.000e-27, 2.0 * pi / (2.000 * units::um), 0.8, 2.0 * pi / (72.2 * units::nm)};
    EXPECT_NEAR(rms_height(model) / units::nm, 93.9, 0.05);
    EXPECT_NEAR(rms_slope(model), 0.7465, 0.00005);
    EXPECT_NEAR(rms_curvature(model) * units::um, 15.19, 0.005);
    EXPECT_NEAR(moment(model, 1.0) / (2.0 * pi), 4.374e-8, 0.0005e-8);
}

}  // namespace self_affine_test
