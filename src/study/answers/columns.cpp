// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/columns.hpp"

#include <nlohmann/json.hpp>

namespace setae::answers {

output::Json columns_json(const Table& table) {
    output::Json json, units;
    for (const auto& column : table.columns) {
        json[column.name] = output::numbers(column.values);
        units[column.name] = column.unit;
    }
    json["units"] = units;
    return json;
}

}  // namespace setae::answers
