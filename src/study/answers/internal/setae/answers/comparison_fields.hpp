// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "setae/answers/contact_comparison.hpp"
#include "setae/answers/contact_fields.hpp"

/// Output of `setae contact compare`.
namespace setae::fields {

template <>
struct Described<answers::ContactComparison> {
    using T = answers::ContactComparison;
    static constexpr auto table = [](const T& of) -> const auto& { return of.load; };
    static constexpr std::string_view error_meaning = "standard error of the mean over surfaces";
    static constexpr std::string_view theory_meaning = "value by Persson's theory";
    static constexpr std::array column_rows{
        column("pressure", "Pa", "mean pressure").with(Missing::never),
        column("area_fraction", "1",
               "area fraction of the contact, corrected for pixels at the edges of the contact; mean over surfaces")
            .with(Missing::never),
        column("area_fraction_standard_error", "1", error_meaning).with(Missing::never),
        column("area_fraction_persson", "1", theory_meaning).with(Missing::never),
        column("mean_gap", "m", "mean gap over the cell; mean over surfaces").with(Missing::never),
        column("mean_gap_standard_error", "m", error_meaning).with(Missing::never),
        column("mean_gap_persson", "m", theory_meaning).with(Missing::never),
        column("contact_stiffness", "Pa/m", "contact stiffness dp/du; mean over surfaces").with(Missing::never),
        column("contact_stiffness_standard_error", "Pa/m", error_meaning).with(Missing::never),
        column("contact_stiffness_persson", "Pa/m", theory_meaning).with(Missing::never),
        column("stored_energy", "J/m2", "elastic energy per nominal area; mean over surfaces").with(Missing::never),
        column("stored_energy_standard_error", "J/m2", error_meaning).with(Missing::never),
        column("stored_energy_persson", "J/m2", theory_meaning).with(Missing::never),
    };
    static constexpr Description columns{"", "columns against pressure", column_rows};
    static constexpr std::array roughness_rows{
        field<&T::rms_height>("rms_height", "rms height of the spectrum within its band").in_unit("m"),
        field<&T::rms_slope>("rms_slope", "rms slope of the spectrum within its band").in_unit("1"),
        made<T>("rms_height_of_surfaces", "rms height of the waves on the grid",
                [](const T& of) { return of.made.rms_height; })
            .in_unit("m"),
        made<T>("rms_slope_of_surfaces", "rms slope of the waves on the grid",
                [](const T& of) { return of.made.rms_slope; })
            .in_unit("1"),
    };
    static constexpr Description roughness{"", "roughness of the spectrum and of the surfaces", roughness_rows};
    static std::vector<std::pair<std::string, std::string>> units(const Table& load) {
        std::vector<std::pair<std::string, std::string>> units;
        for (const auto& column : load.columns) units.emplace_back(column.name, column.unit);
        for (auto& unit : answers::units_by_name({}, {&Described<answers::GridAndBody>::description}))
            units.push_back(std::move(unit));
        for (const char* name : {"rms_height_of_surfaces", "rms_height", "rms_slope_of_surfaces", "rms_slope"})
            units.emplace_back(name, row_named(roughness, name).unit);
        return units;
    }
    static constexpr std::array rows{
        columns_among<T>(columns, table),
        made<T>("units", "unit of each column and number", [](const T& of) { return units(of.load); }),
        fields_of<T>([](const T& of) {
            return answers::GridAndBody{&of.grid, &of.body};
        }),
        field<&T::surfaces>("surfaces", "number of surfaces of every mean"),
        field<&T::seed>("seed", "seed of the first surface"),
        field<&T::band>("band", "band of wavevectors of the data"),
        fields_of<T>(roughness, [](const T& of) -> const T& { return of; }),
        field<&T::energy_factor>("energy_factor", "factor of the stored energy of Persson's theory").in_unit("1"),
        field<&T::largest_duality_gap>("largest_duality_gap", "largest duality gap of all contacts"),
        field<&T::alerts>("alerts", "warnings"),
        inner<&T::scales>(),
        inner<&T::grid>(),
        inner<&T::load>(),
        inner<&T::body>(),
        inner<&T::rms_height>(),
        inner<&T::rms_slope>(),
        inner<&T::made>(),
    };
    static constexpr Description description{
        "", "solved contacts of surfaces with a spectrum, and Persson's theory for this spectrum, against pressure",
        rows};
};
static_assert(complete<answers::ContactComparison>);

}  // namespace setae::fields
