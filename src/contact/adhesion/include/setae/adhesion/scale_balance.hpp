// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/arrays.hpp"
#include "setae/roughness/spectral_moments.hpp"

namespace setae::adhesion {

/// How roughness comes into contact and stays: what closes by itself (stored < 0.25 gained) needs nothing, what stores
/// more than it gains opens by itself, what lies between closes under pressure alone and stays closed.
enum class Closing { by_itself, under_pressure, opens };
[[nodiscard]] const char* name(
    Closing closing);  ///< "spontaneous full contact", "full contact only under pressure", "opens spontaneously"

/// Energy of conforming, scale by scale: what the roughness above each wavevector gains and stores.
struct ScaleBalance {
    Array1D wavevector;  ///< q [1/m]
    Array1D gained;  ///< W_int r_{>q} − γ1 (r_{>q} − 1) [J/m²], r_{>q} the area ratio of the roughness above q alone
    Array1D stored;        ///< U_el/A_app of the roughness above q [J/m²]
    Array1D stored_share;  ///< share of the whole U_el stored below q: cumulative, 0 … 1
    Array1D area_share;    ///< share of r − 1 reached by the roughness below q, 0 … 1
    Array1D work_share;  ///< (W_app of the roughness below q alone − W_int)/(W_app − W_int): cumulative change of W_app
    Array1D closing_pressure;      ///< [Pa] that closes the roughness above q, 0 where it closes by itself
    std::optional<Band> bridging;  ///< [1/m] wavevectors where gained < stored: lowest and highest
    std::optional<Band> pressed;   ///< [1/m] where it does not close by itself, those of `bridging` among them

    /// How the roughness above wavevector i comes into contact.
    [[nodiscard]] Closing closing(Index i) const;
};

/// For an isotropic surface, at the wavevectors of its cumulative parameters. area_shape: excess area over that of
/// Gaussian slopes, taken to be the same for every part of the spectrum.
///
/// Within `bridging` the solid would rather span the roughness shorter than 2π/q than conform to it, whatever (7) says
/// in sum; formulas for full conformity then overstate both area and energy. Gained against stored tells whether closed
/// gaps open; open ones close later. `closing_pressure` is that which closes 99 % of simulated patches of the same
/// stored and gained energy and rms height, unloaded_contact(). contact_modulus [Pa] > 0; work_of_adhesion W_int and
/// surface_energy γ1 [J/m²] >= 0.  Source: THEORY §8; docs/validation/conformity.md.
[[nodiscard]] ScaleBalance scale_balance(const roughness::CumulativeParameters& below, double contact_modulus,
                                         double work_of_adhesion, double surface_energy, double area_shape = 1.0);

}  // namespace setae::adhesion
