// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Output of `setae contact persson`.

#include <array>
#include <cmath>
#include <optional>

#include "setae/answers/persson_contact.hpp"
#include "setae/fields/describe.hpp"

namespace setae::answers {

/// A contact with waves up to each wavevector.
struct ContactAlongScales {
    const Table* table;
};

}  // namespace setae::answers

namespace setae::fields {

/// Columns of a contact by Persson's theory.
inline constexpr std::array columns_of_persson{
    column("area_fraction", "1", "area fraction of the contact").with(Missing::never),
    column("mean_gap", "m", "mean gap over the cell").with(Missing::never),
    column("contact_stiffness", "Pa/m", "contact stiffness dp/du").with(Missing::never),
    column("stored_energy", "J/m2", "elastic energy per nominal area").with(Missing::never),
    column("adhesive_area_fraction", "1", "area fraction of the contact with adhesion"),
    column("effective_work", "J/m2", "effective work of adhesion"),
};

template <>
struct Described<answers::ContactAlongScales> {
    using T = answers::ContactAlongScales;
    static constexpr auto table = [](const T& of) -> const auto& { return *of.table; };
    static constexpr std::array further_rows{
        column("wavevector", "1/m", "wavevector q").with(Missing::never),
        column("rms_pressure", "Pa", "rms pressure of full contact with waves up to q").with(Missing::never),
        column("detachment_stress", "Pa", "stress at which the surfaces separate, with adhesion"),
    };
    static constexpr std::array column_rows = joined(columns_of_persson, further_rows);
    static constexpr Description columns{"", "columns along wavevectors", column_rows};
    static constexpr std::array rows{
        columns_among<T>(columns, table),
        units_of_columns<T>(table),
        inner<&T::table>(),
    };
    static constexpr Description description{"", "contact with waves up to each wavevector", rows};
};
static_assert(complete<answers::ContactAlongScales>);

template <>
struct Described<answers::PerssonContact> {
    using T = answers::PerssonContact;
    static constexpr auto table = [](const T& of) -> const auto& { return of.load; };
    static constexpr auto last = [](const Array1D& values) { return values[values.size() - 1]; };
    static constexpr std::array pressure_row{column("pressure", "Pa", "mean pressure").with(Missing::never)};
    static constexpr std::array column_rows = joined(pressure_row, columns_of_persson);
    static constexpr Description columns{"", "columns against pressure", column_rows};
    static constexpr std::array rows{
        columns_among<T>(columns, table),
        units_of_columns<T>(table),
        made<T>("scales", "contact with waves up to each wavevector, for one pressure",
                [](const T& of) -> std::optional<answers::ContactAlongScales> {
                    if (!of.along_scales) return std::nullopt;
                    return answers::ContactAlongScales{&*of.along_scales};
                }),
        field<&T::contact_modulus>("contact_modulus", "contact modulus E*").in_unit("Pa"),
        field<&T::energy_factor>("energy_factor", "factor of the stored energy of partial contact").in_unit("1"),
        made<T>("rms_pressure", "rms pressure of full contact with all waves",
                [](const T& of) { return std::sqrt(last(of.scales.pressure_variance)); })
            .in_unit("Pa"),
        made<T>("full_contact_energy", "elastic energy per nominal area in full contact",
                [](const T& of) { return last(of.scales.stored_energy); })
            .in_unit("J/m2"),
        made<T>("band", "band of wavevectors of the data",
                [](const T& of) {
                    return Band{of.scales.wavevector[0], last(of.scales.wavevector)};
                }),
        field<&T::alerts>("alerts", "warnings"),
        inner<&T::scales>(),
        inner<&T::load>(),
        inner<&T::along_scales>(),
    };
    static constexpr Description description{"", "contact by Persson's theory, against pressure", rows};
};
static_assert(complete<answers::PerssonContact>);

}  // namespace setae::fields
