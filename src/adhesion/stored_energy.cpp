// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/stored_energy.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::adhesion {
namespace {

void require_modulus(double contact_modulus) {
    if (!(contact_modulus > 0.0)) throw InvalidArgument(fmt::format("contact modulus is {} Pa, expected > 0", contact_modulus));
}

}  // namespace

double stored_energy(double contact_modulus, const roughness::SpectrumCurve& curve, roughness::Conversion conversion) {
    require_modulus(contact_modulus);
    return contact_modulus / 8.0 * roughness::spectral_integral(curve, 1.0, conversion);
}

double stored_energy(double contact_modulus, const roughness::IsotropicCurve& curve) {
    require_modulus(contact_modulus);
    return contact_modulus * roughness::spectral_parameters(curve).elastic_energy_per_modulus;
}

double stored_energy_bound(double contact_modulus, double rms_height, double rms_slope) {
    require_modulus(contact_modulus);
    return 0.25 * contact_modulus * rms_height * rms_slope;
}

}  // namespace setae::adhesion
