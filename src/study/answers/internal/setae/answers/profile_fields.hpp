// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Heights along a line, as the JSON of `setae profile` has them.

#include <array>
#include <string>

#include "setae/core/table.hpp"
#include "setae/fields/describe.hpp"

namespace setae::answers {

/// Heights of a map along a line.
struct ProfileEntry {
    Table table;
    Index lines_averaged = 1;
    std::string file;
};

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::answers::ProfileEntry> {
    using T = answers::ProfileEntry;
    static constexpr auto table = [](const T& of) -> const Table& { return of.table; };
    static constexpr std::array rows_of_columns{
        column("distance", "m", "distance along the line").with(Missing::never),
        column("x", "m", "x of each point").with(Missing::never),
        column("y", "m", "y of each point").with(Missing::never),
        column("height", "m", "height along the line; null where it is undefined").with(Missing::never),
    };
    static constexpr Description columns{"", "columns of the profile", rows_of_columns};
    static constexpr std::array rows{
        columns_among<T>(columns, table),
        units_of_columns<T>(table),
        field<&T::lines_averaged>("lines_averaged", "number of parallel lines that are averaged"),
        field<&T::file>("file", "name of the file as it was given"),
        inner<&T::table>(),
    };
    static constexpr Description description{"", "heights along a line", rows};
};
static_assert(setae::fields::complete<setae::answers::ProfileEntry>);
