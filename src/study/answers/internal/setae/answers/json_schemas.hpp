// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/output/json.hpp"

namespace setae::answers {

/// Commands whose JSON has a schema, in the order of their names: "acf", "contact solve", … "study", which is also that
/// of study.json.
[[nodiscard]] std::vector<std::string> commands_with_schema();

/// JSON Schema (draft 2020-12) of the output of `setae COMMAND --json`: every name with its meaning, its unit where
/// that is constant, and whether it is always present. Later versions may add names, so a schema does not forbid
/// others.
/// @throws InvalidArgument for a command without one.
[[nodiscard]] output::Json json_schema(const std::string& command);

/// "contact_solve.schema.json".
[[nodiscard]] std::string schema_file(const std::string& command);

/// Schemas by name that several commands share, such as "quantity".
[[nodiscard]] output::Json shared_json_parts();

/// A quantity as the JSON of commands names it.
struct QuantityInJson {
    std::string name, symbol, unit, meaning;
    std::vector<std::string> places;  ///< "psd: limits.shortest" of a command, "pair.work_of_adhesion" of a shared part
};

/// All quantities, in the order of their names; a name has one symbol, and one unit or that of the data.
[[nodiscard]] std::vector<QuantityInJson> quantities_in_json();

/// A page on all quantities: name, symbol, unit, meaning and places.
[[nodiscard]] std::string quantities_page();

/// A page on all names: one table per command, and one table of shared types.
[[nodiscard]] std::string json_page();

}  // namespace setae::answers
