// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "setae/fields/row.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {

/// The JSON output of a command whose result is described by rows. Outputs of one command are alternatives.
struct DescribedOutput {
    std::string_view command;  ///< such as "jkr lens"
    const fields::Description* description;
    bool is_list = false;  ///< a list of such results
};

/// JSON Schemas (draft 2020-12) of the output of `setae COMMAND --json`: every name with its meaning, its unit where
/// that is constant, and whether it is always present. Later versions may add names, so a schema does not forbid
/// others.
class JsonSchemas {
public:
    /// Schemas of the commands of this module, and of `further` commands.
    explicit JsonSchemas(std::span<const DescribedOutput> further = {});

    /// Commands whose JSON has a schema, in the order of their names: "acf", "contact solve", … "study", which is also
    /// that of study.json.
    [[nodiscard]] std::vector<std::string> commands() const;

    /// The schema of a command. @throws InvalidArgument for a command without one.
    [[nodiscard]] output::Json of(const std::string& command) const;

    /// Schemas by name that several commands share, such as "quantity".
    [[nodiscard]] output::Json shared_parts() const;

private:
    [[nodiscard]] output::Json own_schema(const std::string& command) const;

    std::vector<DescribedOutput> outputs_;
};

/// "contact_solve.schema.json".
[[nodiscard]] std::string schema_file(const std::string& command);

/// A quantity as the JSON of commands names it.
struct QuantityInJson {
    std::string name, symbol, unit, meaning;
    std::vector<std::string> places;  ///< "psd: limits.shortest" of a command, "pair.work_of_adhesion" of a shared part
};

/// All quantities, in the order of their names; a name has one symbol, and one unit or that of the data.
[[nodiscard]] std::vector<QuantityInJson> quantities_in_json(const JsonSchemas& schemas);

/// A page on all quantities: name, symbol, unit, meaning and places.
[[nodiscard]] std::string quantities_page(const JsonSchemas& schemas);

/// A page on all names: one table per command, and one table of shared types.
[[nodiscard]] std::string json_page(const JsonSchemas& schemas);

}  // namespace setae::answers
