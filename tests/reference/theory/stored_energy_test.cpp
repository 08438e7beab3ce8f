// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "self_affine_map.hpp"
#include "setae/adhesion/stored_energy.hpp"
#include "setae/spectra/isotropic.hpp"
#include "setae/spectra/power_spectrum.hpp"

namespace setae::stored_energy_test {
namespace {

spectra::Spectrum from_lines(const topography::HeightMap& map) {
    spectra::Spectrum spectrum = spectra::power_spectrum(map);
    spectrum.band.lower = 0.5 * spectrum.wavevector[0];
    return spectrum;
}

TEST(StoredEnergy, OfAMapIsEqualByEveryRoute) {
    // roughness in modes 16 to 60 of a 256² map, so that neither window nor trend reaches it. C1D contains one
    // direction of one realisation only, which leaves a per cent; the other two share their data and differ by rounding
    // and bins.
    auto map = tests::self_affine_map(0.6, 256, 16, 60, 9);
    const double by_modes = adhesion::stored_energy(1e6, map);
    const double by_iso =
        adhesion::stored_energy(1e6, spectra::isotropic_power_spectrum(map, {}, spectra::LogGrid{100}));
    EXPECT_NEAR(adhesion::stored_energy(1e6, from_lines(map)) / by_modes, 1.0, 0.02);
    EXPECT_NEAR(by_iso / by_modes, 1.0, 0.02);
    // measured as an open map, levelled and windowed, it stays the same surface
    map.periodic = false;
    EXPECT_NEAR(adhesion::stored_energy(1e6, map) / by_modes, 1.0, 0.03);
    EXPECT_NEAR(adhesion::stored_energy(1e6, from_lines(map)) / by_modes, 1.0, 0.03);
}

TEST(StoredEnergy, OfAGratingDeviatesFromTheIsotropicFormula) {
    // a grating along x taken for an isotropic surface by its lines: π/2 times too large, THEORY §4.1 turned round
    topography::HeightMap map{Array2D(128, 64), {1.0, 0.5}, true};
    for (Index i = 0; i < 128; ++i)
        map.heights.row(i).setConstant(std::cos(2.0 * pi * 8.0 * static_cast<double>(i) / 128.0));
    EXPECT_NEAR(adhesion::stored_energy(1e6, from_lines(map)) / adhesion::stored_energy(1e6, map), 0.5 * pi, 1e-9);
}

}  // namespace
}  // namespace setae::stored_energy_test
