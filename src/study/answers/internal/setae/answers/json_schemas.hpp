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

/// A page on all names: one table per command, and one table of shared types.
[[nodiscard]] std::string json_page();

}  // namespace setae::answers
