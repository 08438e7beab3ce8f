// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/persson/load_curve.hpp"

#include "setae/core/constants.hpp"

namespace setae::persson {
namespace {

/// Without adhesion; under tension, which only adhesion can bear, undefined.
ContactAtScales plain_contact(double pressure, const Scales& scales, const LoadOptions& options) {
    if (pressure > 0.0 || !options.work_of_adhesion) return contact_at_scales(pressure, scales, options.energy_factor);
    const Array1D none = Array1D::Constant(scales.wavevector.size(), undefined);
    return {none, none, none, none};
}

AdhesiveContactAtScales adhesive_contact(double pressure, const Scales& scales, const LoadOptions& options) {
    auto contact = adhesive_contact_at_scales(pressure, *options.work_of_adhesion, scales, options.adhesion);
    if (!contact.converged)
        for (auto* values : {&contact.area_fraction, &contact.effective_work, &contact.detachment_stress})
            values->setConstant(undefined);
    return contact;
}

}  // namespace

Table load_table(const ArrayView1D& pressure, const Scales& scales, const LoadOptions& options) {
    const Index n = pressure.size(), last = scales.wavevector.size() - 1;
    Array1D area(n), gap(n), stiffness(n), energy(n), adhesive_area(n), work(n);
    for (Index i = 0; i < n; ++i) {
        const auto contact = plain_contact(pressure[i], scales, options);
        area[i] = contact.area_fraction[last];
        gap[i] = contact.mean_gap[last];
        stiffness[i] = contact.contact_stiffness[last];
        energy[i] = contact.stored_energy[last];
        if (!options.work_of_adhesion) continue;
        const auto adhesive = adhesive_contact(pressure[i], scales, options);
        adhesive_area[i] = adhesive.area_fraction[last];
        work[i] = adhesive.effective_work[0];
    }
    Table table;
    table.columns = {{"pressure", "Pa", pressure},
                     {"area_fraction", "1", area},
                     {"mean_gap", "m", gap},
                     {"contact_stiffness", "Pa/m", stiffness},
                     {"stored_energy", "J/m2", energy}};
    if (options.work_of_adhesion) {
        table.columns.push_back({"adhesive_area_fraction", "1", adhesive_area});
        table.columns.push_back({"effective_work", "J/m2", work});
    }
    return table;
}

Table scale_table(double pressure, const Scales& scales, const LoadOptions& options) {
    const auto contact = plain_contact(pressure, scales, options);
    Table table;
    table.columns = {{"wavevector", "1/m", scales.wavevector},
                     {"area_fraction", "1", contact.area_fraction},
                     {"mean_gap", "m", contact.mean_gap},
                     {"contact_stiffness", "Pa/m", contact.contact_stiffness},
                     {"stored_energy", "J/m2", contact.stored_energy},
                     {"rms_pressure", "Pa", scales.pressure_variance.sqrt()}};
    if (options.work_of_adhesion) {
        const auto adhesive = adhesive_contact(pressure, scales, options);
        table.columns.push_back({"adhesive_area_fraction", "1", adhesive.area_fraction});
        table.columns.push_back({"effective_work", "J/m2", adhesive.effective_work});
        table.columns.push_back({"detachment_stress", "Pa", adhesive.detachment_stress});
    }
    return table;
}

}  // namespace setae::persson
