// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/roughness/parameter_spread.hpp"

namespace setae::adhesion {

/// Limits of the waves in which a soft body can store energy.
struct ContactScales {
    std::optional<double> contact_diameter;  ///< longest wave within the contact [m]
    std::optional<double> thickness;         ///< thickness of the soft body, bonded to a rigid base [m]
    double poisson_ratio = 0.5;              ///< Poisson ratio of the soft body
};

/// Parts of a spectrum that act within one contact, divided by the whole on a half-space.
///
///   U = (E*/8π) ∫_{2π/D}^{q_s} m(qh) q² C_iso dq,   h'² = (1/2π) ∫_{2π/D}^{q_s} q³ C_iso dq
///
/// m: stiffness of the layer divided by that of a half-space, contact::layer::stiffness_ratio.
struct ContactShares {
    double energy = 1.0;         ///< share of U; above 1 in a thin layer
    double squared_slope = 1.0;  ///< share of h'²
};

/// @throws InvalidArgument for a diameter or a thickness that is not positive, or a diameter below every wave.
[[nodiscard]] ContactShares contact_shares(const spectra::Spectrum& curve, const ContactScales& scales);

/// Parameters within one contact. Replicas and all other parts of the spread are scaled by the same shares, because
/// shares do not scatter.
struct RoughnessInContact {
    roughness::SpectralParameters parameters;
    roughness::ParameterSpread spread;
};
[[nodiscard]] RoughnessInContact roughness_in_contact(const roughness::SpectralParameters& parameters,
                                                      const roughness::ParameterSpread& spread,
                                                      const ContactShares& shares);

}  // namespace setae::adhesion
