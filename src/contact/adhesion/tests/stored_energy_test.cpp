// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/stored_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setae/adhesion/scale_balance.hpp"
#include "setae/adhesion/work_of_adhesion.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/spectra/self_affine.hpp"

namespace setae::adhesion::stored_energy_test {
namespace {

topography::HeightMap wave(Index nx, Index ny, int kx, int ky, double amplitude) {
    topography::HeightMap map{Array2D(nx, ny), {2e-6, 3e-6}, true};
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            map.heights(i, j) = amplitude * std::cos(2.0 * pi *
                                                     (kx * static_cast<double>(i) / static_cast<double>(nx) +
                                                      ky * static_cast<double>(j) / static_cast<double>(ny)));
    return map;
}

TEST(StoredEnergy, OfACosineMatchesTheClosedForm) {
    // E* q h0²/8, any direction, odd and even grids
    for (const auto& [nx, ny] : {std::pair<Index, Index>{64, 48}, {63, 49}})
        for (const auto& [kx, ky] : {std::pair{3, 0}, {0, 5}, {4, -7}}) {
            const double q = 2.0 * pi * std::hypot(kx / 2e-6, ky / 3e-6);
            EXPECT_NEAR(stored_energy(1e6, wave(nx, ny, kx, ky, 5e-9)) / (1e6 * q * 25e-18 / 8.0), 1.0, 1e-12);
        }
}

TEST(StoredEnergy, OfAMapIsIndependentOfOffset) {
    auto map = wave(32, 32, 2, 1, 5e-9);
    const double energy = stored_energy(1e6, map);
    map.heights += 1e-6;
    EXPECT_NEAR(stored_energy(1e6, map) / energy, 1.0, 1e-9);
}

TEST(StoredEnergy, IsBelowTheCauchySchwarzBound) {
    const spectra::SelfAffine model{5e-27, 2.0 * pi / 2e-6, 0.8, 2.0 * pi / 72.2e-9};
    Array1D q(3);
    q << 2.0 * pi, model.rolloff_wavevector, model.short_wavevector;
    const spectra::Spectrum curve{
        q, spectra::isotropic_power_spectrum(model, q), {q[0], q[2]}, spectra::Density::C_iso};
    const auto p = roughness::spectral_parameters(curve);
    EXPECT_LT(stored_energy(1e6, curve), stored_energy_bound(1e6, p.rms_height, p.rms_slope));
    EXPECT_GT(stored_energy(1e6, curve), 0.3 * stored_energy_bound(1e6, p.rms_height, p.rms_slope));
    EXPECT_NEAR(stored_energy(1e6, curve), 0.25 * 1e6 * 4.374e-8, 1e-5);  // THEORY §11
    EXPECT_THROW((void)stored_energy(0.0, curve), InvalidArgument);
}

roughness::CumulativeParameters rough(double factor) {
    const spectra::SelfAffine model{factor * 5e-27, 2.0 * pi / 2e-6, 0.8, 2.0 * pi / 4e-10};
    const Array1D q = Array1D::LinSpaced(200, std::log(1e4), std::log(model.short_wavevector)).exp();
    return roughness::cumulative_parameters(
        {q, spectra::isotropic_power_spectrum(model, q), {q[0], q[199]}, spectra::Density::C_iso});
}

TEST(ScaleBalance, IncreasesFromZeroToTheTotal) {
    const auto below = rough(1.0);
    const auto balance = scale_balance(below, 1e6, 0.037, 0.025);
    const auto last = balance.wavevector.size() - 1;
    EXPECT_EQ(balance.stored_share[0], 0.0);
    EXPECT_EQ(balance.stored_share[last], 1.0);
    EXPECT_NEAR(balance.work_share[0], 0.0, 1e-12);
    EXPECT_NEAR(balance.work_share[last], 1.0, 1e-12);
    // all roughness together is the balance (7) itself; none is the flat surface
    const auto whole = modified_balance(
        0.037, 0.025,
        {roughness::gaussian_area_ratio(below.rms_slope[last]), 1e6 * below.elastic_energy_per_modulus[last]});
    EXPECT_NEAR(balance.gained[0] - balance.stored[0], whole.raw, 1e-12);
    EXPECT_NEAR(balance.gained[last], 0.037, 1e-12);
    EXPECT_NEAR(balance.stored[last], 0.0, 1e-15);
}

TEST(ScaleBalance, OfAStiffBodyBridgesFromTheLongestWavelengths) {
    EXPECT_FALSE(scale_balance(rough(1.0), 1e5, 0.037, 0.025).bridging);
    const auto stiff = scale_balance(rough(1.0), 1e7, 0.037, 0.025);
    ASSERT_TRUE(stiff.bridging);
    EXPECT_EQ(stiff.bridging->lower, stiff.wavevector[0]);
    EXPECT_LT(stiff.bridging->upper, stiff.wavevector[stiff.wavevector.size() - 1]);
}

}  // namespace
}  // namespace setae::adhesion::stored_energy_test
