// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Adhesion on a surface, as the JSON of `setae adhesion` has it.

#include <array>
#include <optional>
#include <string_view>

#include "setae/adhesion/scale_balance.hpp"
#include "setae/answers/adhesion.hpp"
#include "setae/fields/describe.hpp"
#include "setae/output/contact_answer_fields.hpp"
#include "setae/output/quantity_rows.hpp"

namespace setae::answers {

/// Energies of waves up to each wavevector.
struct ScalesEntry {
    const adhesion::ScaleBalance* balance;
};

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<answers::ScalesEntry> {
    using T = answers::ScalesEntry;
    static constexpr std::array rows_of_columns{
        made<T>("wavevector", "wavevector q", [](const T& of) -> const auto& { return of.balance->wavevector; })
            .in_unit("1/m"),
        made<T>("gained", "work of adhesion gained by waves above q",
                [](const T& of) -> const auto& { return of.balance->gained; })
            .in_unit("J/m2"),
        made<T>("stored", "elastic energy stored by waves above q",
                [](const T& of) -> const auto& { return of.balance->stored; })
            .in_unit("J/m2"),
        made<T>("stored_share", "share of the stored energy that waves below q store",
                [](const T& of) -> const auto& { return of.balance->stored_share; })
            .in_unit("1"),
        made<T>("area_share", "share of the excess area that waves below q give",
                [](const T& of) -> const auto& { return of.balance->area_share; })
            .in_unit("1"),
    };
    static constexpr Description columns{"", "energies at each wavevector", rows_of_columns};
    static constexpr auto rows = joined(rows_of_columns, std::array{units_of(columns)});
    static constexpr Description description{"", "energies at each wavevector", rows};
};

template <>
struct Described<answers::Adhesion> {
    using T = answers::Adhesion;
    static constexpr std::array<std::string_view, 3> closings{
        "spontaneous full contact", "full contact only under pressure", "opens spontaneously"};
    static constexpr std::array own_quantities{
        possible("work_of_adhesion", "W_app", "J/m2", "W_app of contact without load, by the recommended theory")
            .as("apparent_work_of_adhesion")
            .with(Missing::never),
        possible("contact_modulus", "E*", "Pa", "contact modulus").with(Missing::never),
        possible("stored_energy", "U_el/A_app", "J/m2", "elastic energy stored in full contact per nominal area")
            .as("stored_energy_per_area")
            .with(Missing::never),
        possible("stored_energy_eq11", "U_el/A_app", "J/m2", "stored energy by Eq. 11 of [D19]"),
        possible("stored_energy_exact", "U_el/A_app", "J/m2", "stored energy by the exact conversion of C1D"),
        possible("stored_energy_bound", "U_el/A_app", "J/m2",
                 "upper bound of the stored energy of all spectra with this rms height and rms slope")
            .with(Missing::never),
        possible("stored_energy_from_C_iso", "U_el/A_app", "J/m2", "stored energy from C_iso of the map"),
        possible("stored_energy_from_map", "U_el/A_app", "J/m2",
                 "stored energy from the waves of the map in all directions"),
        possible("work_of_adhesion_modified", "W_app", "J/m2", "W_app by the full-contact balance (Eq. 7)")
            .with(Missing::never),
        possible("work_of_adhesion_modified_floored", "max(0, W_app)", "J/m2",
                 "max(0, W_app) by the full-contact balance (Eq. 7)")
            .with(Missing::never),
        possible("work_of_adhesion_persson_tosatti", "W_app", "J/m2", "W_app by the Persson–Tosatti balance (Eq. S13)")
            .with(Missing::never),
        possible("work_of_adhesion_persson_tosatti_floored", "max(0, W_app)", "J/m2",
                 "max(0, W_app) by the Persson–Tosatti balance (Eq. S13)")
            .with(Missing::never),
        possible("work_of_adhesion_without_area_change", "W_app", "J/m2", "W_app by the small-slope balance (Eq. 2)")
            .with(Missing::never),
        possible("work_of_adhesion_without_area_change_floored", "max(0, W_app)", "J/m2",
                 "max(0, W_app) by the small-slope balance (Eq. 2)")
            .with(Missing::never),
        possible("work_of_adhesion_with_unmeasured_waves", "W_app", "J/m2",
                 "W_app by the full-contact balance (Eq. 7) with waves beyond both ends of the data"),
    };
    static constexpr auto rows_of_quantities =
        joined(output::surface_quantity_rows, own_quantities, output::loop_quantity_rows);
    static constexpr Description quantities{"", "quantities of the surface, the contact and the loop",
                                            rows_of_quantities};
    static constexpr std::array rows{
        quantities_among<T>(quantities, [](const T& of) -> const auto& { return of.quantities; }).with(Missing::never),
        made<T>("conforms", "whether full contact forms spontaneously at every scale",
                [](const T& of) {
                    const auto& pair = of.result.pairs.front();
                    return pair.modified->work.conforms && pair.closing() == adhesion::Closing::spontaneous;
                }),
        made<T>("contact", "formation of full contact",
                [](const T& of) { return adhesion::name(of.result.pairs.front().closing()); })
            .one_of(closings),
        field<&T::answers>("answers", "contact without load by each theory"),
        made<T>("scales", "energies at each wavevector",
                [](const T& of) { return answers::ScalesEntry{&*of.result.pairs.front().scales}; }),
        made<T>("channel", "number of the channel within the file, counted from 0",
                [](const T& of) -> std::optional<std::size_t> {
                    const auto& measurements = of.surface().measurements;
                    if (measurements.size() != 1) return std::nullopt;
                    return measurements.front().channel;
                }),
        made<T>("alerts", "warnings", [](const T& of) { return of.alerts(); }),
        inner<&T::result>(),
        inner<&T::quantities>(),
    };
    static constexpr Description description{
        "",
        "adhesion of a soft sphere or plane on a rough surface: parameters, stored energy, apparent work of adhesion",
        rows};
};
static_assert(complete<answers::Adhesion>);

}  // namespace setae::fields
