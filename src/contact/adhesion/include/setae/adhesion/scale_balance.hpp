// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/arrays.hpp"
#include "setae/roughness/spectral_moments.hpp"

namespace setae::adhesion {

/// Formation of full contact: spontaneous full contact (stored < 0.25 gained), full contact only under pressure, or
/// spontaneous opening (stored > gained).
enum class Closing { spontaneous, under_pressure, opens };
[[nodiscard]] const char* name(
    Closing closing);  ///< "spontaneous full contact", "full contact only under pressure", "opens spontaneously"

/// Energy of full contact, scale by scale: energy that the roughness above each wavevector gains and stores.
struct ScaleBalance {
    Array1D wavevector;  ///< q [1/m]
    Array1D gained;  ///< W_int r_{>q} − γ1 (r_{>q} − 1) [J/m²], r_{>q} the area ratio of only the roughness above q
    Array1D stored;        ///< U_el/A_app of the roughness above q [J/m²]
    Array1D stored_share;  ///< share of the whole U_el stored below q: cumulative, 0 … 1
    Array1D area_share;    ///< share of r − 1 reached by the roughness below q, 0 … 1
    Array1D work_share;  ///< (W_app of only the roughness below q − W_int)/(W_app − W_int): cumulative change of W_app
    Array1D
        closing_pressure;  ///< pressure [Pa] for full contact of the roughness above q, 0 for spontaneous full contact
    std::optional<Band> bridging;  ///< [1/m] wavevectors where gained < stored: lowest and highest
    std::optional<Band> pressed;  ///< [1/m] wavevectors without spontaneous full contact, including those of `bridging`

    /// Formation of full contact of the roughness above wavevector i.
    [[nodiscard]] Closing closing(Index i) const;
};

/// Scale balance of an isotropic surface, at the wavevectors of its cumulative parameters. area_shape: excess area
/// divided by that of Gaussian slopes, assumed equal for every part of the spectrum.
///
/// Within `bridging` the roughness shorter than 2π/q stores more energy than it gains, regardless of the sum in Eq. 7;
/// formulas for full contact then overestimate both area and energy. The comparison of gained and stored energy
/// determines whether closed gaps open; open gaps close at a smaller stored energy. `closing_pressure` is the pressure
/// for contact on 99 % of simulated patches of the same stored and gained energy and rms height, unloaded_contact().
/// contact_modulus [Pa] > 0; work_of_adhesion W_int and surface_energy γ1 [J/m²] >= 0.  Source: THEORY §8;
/// docs/validation/conformity.md.
[[nodiscard]] ScaleBalance scale_balance(const roughness::CumulativeParameters& below, double contact_modulus,
                                         double work_of_adhesion, double surface_energy, double area_shape = 1.0);

}  // namespace setae::adhesion
