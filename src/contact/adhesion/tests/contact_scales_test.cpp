// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/contact_scales.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/adhesion/partial_contact.hpp"
#include "setae/adhesion/scale_balance.hpp"
#include "setae/adhesion/stored_energy.hpp"
#include "setae/contact/layer.hpp"
#include "setae/core/errors.hpp"

namespace setae::adhesion::contact_scales_test {
namespace {

/// C_iso = q⁻⁴ between two wavevectors: U ∝ ∫ q⁻² dq, h'² ∝ ∫ q⁻¹ dq.
spectra::Spectrum power_law(double lower, double upper, Index nodes = 4001) {
    spectra::Spectrum curve;
    curve.kind = spectra::Density::C_iso;
    curve.wavevector = Array1D::LinSpaced(nodes, std::log(lower), std::log(upper)).exp();
    curve.density = 1e-6 * curve.wavevector.pow(-4.0);
    curve.band = {lower, upper};
    return curve;
}

TEST(ContactShares, OfAPowerLawMatchTheClosedForm) {
    const double lower = 1e4, upper = 1e10, diameter = 100e-6, first = 2.0 * pi / diameter;
    const auto shares = contact_shares(power_law(lower, upper), {.contact_diameter = diameter});
    EXPECT_NEAR(shares.energy, (1.0 / first - 1.0 / upper) / (1.0 / lower - 1.0 / upper), 1e-5);
    EXPECT_NEAR(shares.squared_slope, std::log(upper / first) / std::log(upper / lower), 1e-5);
}

TEST(ContactShares, OfOneWaveOnALayerEqualItsStiffnessRatio) {
    const double q = 2e5, h = 10e-6;
    const auto shares = contact_shares(power_law(q, 1.001 * q, 11), {.thickness = h, .poisson_ratio = 0.45});
    EXPECT_NEAR(shares.energy / contact::layer::stiffness_ratio(1.0005 * q * h, 0.45), 1.0, 1e-5);
    EXPECT_EQ(shares.squared_slope, 1.0);
    // a film a tenth as thick as the wave is long stores several times a half-space's energy, a thick lens no more
    EXPECT_GT(contact_shares(power_law(2e5, 2.1e5, 11), {.thickness = 3e-6}).energy, 5.0);
    EXPECT_NEAR(contact_shares(power_law(2e5, 2.1e5, 11), {.thickness = 700e-6}).energy, 1.0, 1e-12);
}

TEST(ContactShares, ScaleParametersAndTheirScatterEqually) {
    roughness::SpectralParameters parameters{.rms_slope = 0.5, .elastic_energy_per_modulus = 1e-8};
    roughness::ParameterSpread spread;
    spread.replicas = {parameters};
    const auto seen = roughness_in_contact(parameters, spread, {.energy = 0.5, .squared_slope = 0.81});
    EXPECT_DOUBLE_EQ(seen.parameters.rms_slope, 0.45);
    EXPECT_DOUBLE_EQ(seen.spread.replicas.front().elastic_energy_per_modulus, 5e-9);
}

TEST(ContactShares, RefuseContactsWithoutModes) {
    EXPECT_THROW((void)contact_shares(power_law(1e6, 1e9), {.contact_diameter = 1e-9}), InvalidArgument);
    EXPECT_THROW((void)contact_shares(power_law(1e6, 1e9), {.contact_diameter = 0.0}), InvalidArgument);
    EXPECT_THROW((void)contact_shares(power_law(1e6, 1e9), {.thickness = -1.0}), InvalidArgument);
}

// One wave: U = E* q h²/8 and W of a nearly flat surface; it closes as patches of its energies and height do.
TEST(ScaleBalance, MatchesFullContactOfSimulatedPatches) {
    const double q = 2.0 * pi / 20e-6, height = 50e-9, modulus = 1e6;
    auto curve = power_law(q, 1.0001 * q, 3);
    curve.density *= height * height / 2.0 / std::pow(roughness::spectral_parameters(curve).rms_height, 2);
    const double stored = modulus * q * height * height / 8.0;
    for (const double ratio : {0.2, 0.3, 0.6, 0.9, 1.5}) {
        const auto scales =
            scale_balance(roughness::cumulative_parameters(curve), modulus, stored / ratio, 0.5 * stored / ratio);
        const double expected = unloaded_contact(ratio).closing_pressure * stored / (height / std::sqrt(2.0));
        EXPECT_NEAR(scales.closing_pressure[0], expected, 1e-3 * modulus * q * height);
        EXPECT_EQ(scales.closing(0), ratio < 0.25  ? Closing::spontaneous
                                     : ratio < 1.0 ? Closing::under_pressure
                                                   : Closing::opens);
        EXPECT_EQ(scales.pressed.has_value(), ratio > 0.25);
        EXPECT_EQ(scales.bridging.has_value(), ratio > 1.0);
    }
}

}  // namespace
}  // namespace setae::adhesion::contact_scales_test
