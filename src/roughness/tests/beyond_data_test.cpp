// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/beyond_data.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::roughness::beyond_data_test {
namespace {

/// A self-affine surface to 4 Å, known to a longer wavelength alone.
spectra::Spectrum curve(double shortest) {
    const spectra::SelfAffine model{.plateau = 5e-27,
                                    .rolloff_wavevector = 2.0 * pi / 0.3e-6,
                                    .hurst_exponent = 0.8,
                                    .short_wavevector = 2.0 * pi / 4e-10};
    spectra::Spectrum found;
    found.kind = spectra::Density::C_iso;
    found.wavevector = Array1D::LinSpaced(400, std::log(1e5), std::log(2.0 * pi / shortest)).exp();
    found.wavevector[399] = 2.0 * pi / shortest * (1.0 - 1e-12);
    found.density = found.wavevector.unaryExpr(spectra::density(model));
    found.band = {1e5, found.wavevector[399]};
    return found;
}

TEST(BeyondData, OfAPowerLawIsWhatIsThere) {
    const auto whole = spectral_parameters(curve(4e-10));
    for (const double shortest : {8e-10, 5e-9}) {
        const auto found = beyond_data(curve(shortest), 2.0 * pi / 4e-10);
        EXPECT_NEAR(found.exponent.value, -3.6, 1e-6);
        EXPECT_NEAR(found.rms_slope.value / whole.rms_slope, 1.0, 1e-5);
        EXPECT_NEAR(found.elastic_energy_per_modulus.value / whole.elastic_energy_per_modulus, 1.0,
                    3e-4);  // nodes about the kink of the roll-off differ
        EXPECT_NEAR(found.excess_area.value / (gaussian_area_ratio(whole.rms_slope) - 1.0), 1.0, 1e-5);
        EXPECT_LT(found.rms_slope.interval->lower, found.rms_slope.value);
        EXPECT_GT(found.rms_slope.interval->upper, found.rms_slope.value);
    }
    // the further, the less is known
    const auto near = beyond_data(curve(8e-10), 2.0 * pi / 4e-10), far = beyond_data(curve(5e-9), 2.0 * pi / 4e-10);
    EXPECT_GT(far.rms_slope.standard_error, 3.0 * near.rms_slope.standard_error);
}

// C1D = q⁻³ is that of C_iso = 4 q⁻⁴.
TEST(BeyondData, OfLinesHasTheClosedForm) {
    spectra::Spectrum line;
    line.kind = spectra::Density::C1D;
    line.wavevector = Array1D::LinSpaced(100, std::log(1e6), std::log(1e8)).exp();
    line.density = line.wavevector.pow(-3.0);
    line.band = {line.wavevector[0], line.wavevector[99]};
    const auto found = beyond_data(line, 1e9);
    EXPECT_NEAR(found.exponent.value, -4.0, 1e-9);
    EXPECT_NEAR(found.rms_slope.value, std::sqrt(2.0 / pi * std::log(1e3)), 1e-6);
    EXPECT_NEAR(found.elastic_energy_per_modulus.value, (1e-6 - 1e-9) / (2.0 * pi), 1e-12);
    EXPECT_THROW((void)beyond_data(line, 1e7), InvalidArgument);
}

}  // namespace
}  // namespace setae::roughness::beyond_data_test
