// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fields/row.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::fields {

const Row& row_named(const Description& description, std::string_view name) {
    const auto& rows = description.rows;
    auto found = std::find_if(rows.begin(), rows.end(), [name](const Row& row) { return row.name == name; });
    if (found == rows.end())
        found = std::find_if(rows.begin(), rows.end(), [name](const Row& row) { return row.term == name; });
    if (found == rows.end()) throw InternalError(fmt::format("no field is called {}", name));
    return *found;
}

void put(const void* result, const Description& description, Sink& sink) {
    for (const auto& row : description.rows)
        if (row.put) row.put(result, row, sink);
}

}  // namespace setae::fields
