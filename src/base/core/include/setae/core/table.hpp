// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae {

/// A named column of numbers in its SI unit; NaN = missing.
struct Column {
    std::string name;
    std::string unit = "1";
    Array1D values;
};

/// Columns of equal length with a free header: a loop, a spectrum, a table of an instrument.
struct Table {
    std::vector<Column> columns;
    std::map<std::string, std::string> metadata;

    [[nodiscard]] Index rows() const { return columns.empty() ? 0 : columns.front().values.size(); }

    /// nullptr if the table has no such column.
    [[nodiscard]] const Column* find(std::string_view name) const;

    /// @throws InvalidArgument that lists the available columns.
    [[nodiscard]] const Array1D& at(std::string_view name) const;
};

}  // namespace setae
