// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/table.hpp"
#include "setae/persson/adhesive.hpp"
#include "setae/persson/contact.hpp"

namespace setae::persson {

struct LoadOptions {
    double energy_factor = usual_energy_factor;  ///< γ of contact_at_scales()
    std::optional<double> work_of_adhesion;      ///< w [J/m²]; absent: no adhesion
    AdhesiveOptions adhesion;
};

/// The contact of a whole spectrum against load.
///
/// columns: pressure [Pa], area_fraction, mean_gap [m], contact_stiffness [Pa/m], stored_energy [J/m2] without
/// adhesion, NaN under tension; with it also adhesive_area_fraction and effective_work [J/m2], γ_eff of the longest
/// waves, NaN where the iterations do not converge.
/// @throws as contact_at_scales and adhesive_contact_at_scales; InvalidArgument for a pressure <= 0 without adhesion.
[[nodiscard]] Table load_table(const ArrayView1D& pressure, const Scales& scales, const LoadOptions& options = {});

/// One contact against the waves that are taken into account.
///
/// columns: wavevector [1/m], area_fraction, mean_gap, contact_stiffness, stored_energy, rms_pressure [Pa] of full
/// contact, √V; with adhesion also adhesive_area_fraction, effective_work and detachment_stress [Pa]. NaN as above.
/// @throws as load_table.
[[nodiscard]] Table scale_table(double pressure, const Scales& scales, const LoadOptions& options = {});

}  // namespace setae::persson
