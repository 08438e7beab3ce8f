// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/table.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/errors.hpp"

namespace setae {

const Column* Table::find(std::string_view name) const {
    const auto found = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
    return found == columns.end() ? nullptr : &*found;
}

const Array1D& Table::at(std::string_view name) const {
    if (const auto* column = find(name)) return column->values;
    std::vector<std::string> names;
    for (const auto& column : columns) names.push_back(column.name);
    throw InvalidArgument(fmt::format("table has no column '{}'; it has: {}", name, fmt::join(names, ", ")));
}

}  // namespace setae
