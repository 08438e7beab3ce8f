// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Output of `setae jkr import`.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/fields/describe.hpp"
#include "setae/study/open_loop.hpp"
#include "setae/tables/column_guess.hpp"

namespace setae::answers {

/// A foreign table that was read as a loop.
struct ImportedLoop {
    std::string file;
    const study::OpenedLoop* opened;
    std::map<std::string, std::string> metadata;
    std::optional<tables::ColumnGuess> guess;  ///< where no mapping was given
    std::optional<std::string> mapping;        ///< as TOML
    std::optional<std::string> output;         ///< path of the loop file, where one was written
};

/// A column of a loop.
struct ImportedColumn {
    const Column* column;
};

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<answers::ImportedColumn> {
    using T = answers::ImportedColumn;
    static constexpr std::array rows{
        made<T>("name", "name of the column in a loop file",
                [](const T& of) -> const std::string& { return of.column->name; }),
        made<T>("unit", "unit of the column", [](const T& of) -> const std::string& { return of.column->unit; }),
        inner<&T::column>(),
    };
    static constexpr Description description{"", "column of a loop", rows};
};
static_assert(complete<answers::ImportedColumn>);

template <>
struct Described<tables::ColumnGuess::Shown> {
    using T = tables::ColumnGuess::Shown;
    static constexpr std::array rows{
        field<&T::name>("name", "name in the file; may be empty"),
        field<&T::unit>("unit", "unit in the file; may be empty"),
        field<&T::first_values>("first_values", "first values of the column, as in the file"),
        field<&T::note>("note", "remark on the column; may be empty"),
    };
    static constexpr Description description{"", "column of a foreign table", rows};
};
static_assert(complete<tables::ColumnGuess::Shown>);

template <>
struct Described<tables::RoleCandidate> {
    using T = tables::RoleCandidate;
    static constexpr std::array rows{
        made<T>("column", "number of the column, counted from 1", [](const T& of) { return of.column + 1; }),
        field<&T::confidence>("confidence", "confidence from 0 to 1"),
        field<&T::reason>("reason", "reason for the confidence"),
        made<T>("from_area", "whether the radius would be computed from an area",
                [](const T& of) { return of.derivation == tables::Derivation::radius_of_area; }),
        made<T>("negative", "whether the sign of the column would be reversed",
                [](const T& of) { return of.derivation == tables::Derivation::negative; }),
        inner<&T::column>(),
        inner<&T::derivation>(),
        inner<&T::unit>(),
    };
    static constexpr Description description{"", "column that may have a role", rows};
};
static_assert(complete<tables::RoleCandidate>);

template <>
struct Described<tables::RoleGuess> {
    using T = tables::RoleGuess;
    static constexpr std::array<std::string_view, 4> roles{"force", "displacement", "contact_radius", "time"};
    static constexpr std::array rows{
        field<&T::role>("role", "role of a column of a loop").one_of(roles),
        field<&T::candidates>("candidates", "columns that may have this role, the best first"),
    };
    static constexpr Description description{"", "role and columns that may have the role", rows};
};
static_assert(complete<tables::RoleGuess>);

template <>
struct Described<tables::ColumnGuess> {
    using T = tables::ColumnGuess;
    static constexpr std::array rows{
        field<&T::columns>("columns", "one entry per column of the file"),
        field<&T::roles>("roles", "one entry per role"),
        inner<&T::path>(),
        inner<&T::file>(),
    };
    static constexpr Description description{"", "proposed mapping", rows};
};
static_assert(complete<tables::ColumnGuess>);

template <>
struct Described<loops::ClockAlignment> {
    using T = loops::ClockAlignment;
    static constexpr std::array rows{
        quantity<&T::offset>("offset", "t0", "s", "time to add to the times of the camera").as("clock_offset"),
        field<&T::doubt>("doubt", "reason for which the offset may be wrong; may be empty"),
        inner<&T::explained>(),
        inner<&T::runner_up>(),
        inner<&T::by_onset>(),
        inner<&T::frame_interval>(),
        inner<&T::frames>(),
        inner<&T::method>(),
    };
    static constexpr Description description{"", "clock of the camera relative to that of the force", rows};
};
static_assert(complete<loops::ClockAlignment>);

template <>
struct Described<answers::ImportedLoop> {
    using T = answers::ImportedLoop;
    static constexpr std::array rows{
        field<&T::file>("file", "name of the file as it was given"),
        made<T>("samples", "number of samples", [](const T& of) { return of.opened->table.rows(); }),
        field<&T::metadata>("metadata", "metadata of the loop file"),
        made<T>("alerts", "warnings", [](const T& of) -> const auto& { return of.opened->alerts; }),
        made<T>("columns", "one entry per column of the loop",
                [](const T& of) {
                    std::vector<answers::ImportedColumn> columns;
                    for (const auto& column : of.opened->table.columns) columns.push_back({&column});
                    return columns;
                }),
        field<&T::guess>("guess", "proposed mapping, if no mapping was given"),
        field<&T::mapping>("mapping", "mapping that was used, as TOML"),
        made<T>("clock", "clock of the camera relative to that of the force",
                [](const T& of) -> const auto& { return of.opened->clock; }),
        field<&T::output>("output", "path of the file that was written"),
        inner<&T::opened>(),
    };
    static constexpr Description description{"", "import of a foreign table as a loop", rows};
};
static_assert(complete<answers::ImportedLoop>);

}  // namespace setae::fields
