// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/contact_scales.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/contact/layer.hpp"
#include "setae/core/errors.hpp"

namespace setae::adhesion {
namespace {

void scale(roughness::SpectralParameters& parameters, const ContactShares& shares) {
    parameters.rms_slope *= std::sqrt(shares.squared_slope);
    parameters.elastic_energy_per_modulus *= shares.energy;
}

void require_positive(const std::optional<double>& length, const char* name) {
    if (length && !(*length > 0.0)) throw InvalidArgument(fmt::format("{} of {} m; expected > 0", name, *length));
}

}  // namespace

ContactShares contact_shares(const spectra::Spectrum& curve, const ContactScales& scales) {
    require_positive(scales.contact_diameter, "contact diameter");
    require_positive(scales.thickness, "thickness of the soft body");
    const double first = scales.contact_diameter ? 2.0 * pi / *scales.contact_diameter : 0.0;
    if (first >= curve.band.upper)
        throw InvalidArgument(fmt::format("a contact diameter of {} m is smaller than every wavelength of the spectrum",
                                          *scales.contact_diameter));
    const auto below = roughness::cumulative_parameters(curve);
    const auto n = below.wavevector.size();
    double energy = 0.0, squared_slope = 0.0;
    for (Index i = 1; i < n; ++i) {
        const double left = below.wavevector[i - 1], right = below.wavevector[i];
        if (right <= first) continue;
        // for the piece that contains the cut, the part above it in ln q
        const double part = left < first ? std::log(right / first) / std::log(right / left) : 1.0;
        const double q = std::sqrt(std::max(left, first) * right);
        const double stiffness =
            scales.thickness ? contact::layer::stiffness_ratio(q * *scales.thickness, scales.poisson_ratio) : 1.0;
        energy += part * stiffness * (below.elastic_energy_per_modulus[i] - below.elastic_energy_per_modulus[i - 1]);
        squared_slope += part * (std::pow(below.rms_slope[i], 2) - std::pow(below.rms_slope[i - 1], 2));
    }
    return {energy / below.elastic_energy_per_modulus[n - 1], squared_slope / std::pow(below.rms_slope[n - 1], 2)};
}

RoughnessInContact roughness_in_contact(const roughness::SpectralParameters& parameters,
                                        const roughness::ParameterSpread& spread, const ContactShares& shares) {
    RoughnessInContact result{parameters, spread};
    scale(result.parameters, shares);
    result.spread.each([&shares](roughness::SpectralParameters& held) { scale(held, shares); });
    return result;
}

}  // namespace setae::adhesion
