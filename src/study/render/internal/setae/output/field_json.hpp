// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "setae/fields/describe.hpp"
#include "setae/output/json.hpp"

namespace setae::output {

/// Adds every described field of a result to an object, in order. A number is a JSON number, one with a unit {"value",
/// "unit"}, one with an error as in to_json(Quantity); missing values as stated by their row.
void add_fields(Json& json, const void* result, const fields::Description& description);
template <fields::HasRows T>
void add_fields(Json& json, const T& result) {
    add_fields(json, &result, fields::Described<T>::description);
}

/// An object of only these fields.
[[nodiscard]] Json described(const void* result, const fields::Description& description);
template <fields::HasRows T>
[[nodiscard]] Json described(const T& result) {
    return described(&result, fields::Described<T>::description);
}

/// A list of such objects.
template <fields::HasRows T>
[[nodiscard]] Json described(const std::vector<T>& results) {
    Json list = Json::array();
    for (const auto& result : results) list.push_back(described(result));
    return list;
}

/// JSON Schema of an object with these fields; described types that have a name are referred to in "#/$defs/NAME".
[[nodiscard]] Json schema_of(const fields::Description& description);

/// Adds the schema of a described type under its name, and those of all named types in it.
void add_named_schemas(const fields::Description& description, std::map<std::string, Json>& schemas);

/// Adds the schemas that those of every described type refer to: "number", "value", "values" and "quantity".
void add_schemas_of_numbers(std::map<std::string, Json>& schemas);

}  // namespace setae::output
