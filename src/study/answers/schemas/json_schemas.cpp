// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/json_schemas.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "schemas/described_outputs.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"

namespace setae::answers {
namespace {

using output::Json;

constexpr std::string_view place_of_shared = "#/$defs/";

/// The schema of rows; a result that has a name is one of the shared parts.
Json schema_of(const DescribedOutput& output) {
    const auto& description = *output.description;
    auto one = description.name.empty() ? output::schema_of(description)
                                        : Json{{"description", description.meaning},
                                               {"$ref", std::string(place_of_shared) + std::string(description.name)}};
    if (!output.is_list) return one;
    return {{"description", description.meaning}, {"type", "array"}, {"items", std::move(one)}};
}

/// The schema of one output, or of outputs that are alternatives.
Json schema_of(const std::vector<DescribedOutput>& outputs) {
    if (outputs.size() == 1) return schema_of(outputs.front());
    std::vector<std::string_view> meanings;
    Json schemas = Json::array();
    for (const auto& output : outputs) {
        meanings.push_back(output.description->meaning);
        schemas.push_back(schema_of(output));
    }
    return {{"description", fmt::format("{}", fmt::join(meanings, "; or "))}, {"anyOf", std::move(schemas)}};
}

std::string file_of(std::string command) {
    std::replace(command.begin(), command.end(), ' ', '_');
    return command;
}

/// Names of the shared parts that a schema refers to, and those that these refer to.
void add_references(const Json& schema, const Json& parts, std::set<std::string>& names) {
    for (const auto& [key, value] : schema.items()) {
        if (value.is_structured()) add_references(value, parts, names);
        if (key != "$ref") continue;
        const auto name = value.get<std::string>().substr(place_of_shared.size());
        if (names.insert(name).second) add_references(parts.at(name), parts, names);
    }
}

/// The parts in their own order.
Json chosen(const Json& parts, const std::set<std::string>& names) {
    Json some = Json::object();
    for (const auto& [name, part] : parts.items())
        if (names.contains(name)) some[name] = part;
    return some;
}

}  // namespace

JsonSchemas::JsonSchemas(std::span<const DescribedOutput> further) {
    const auto own = schemas::described_outputs();
    outputs_.assign(own.begin(), own.end());
    outputs_.insert(outputs_.end(), further.begin(), further.end());
}

std::vector<std::string> JsonSchemas::commands() const {
    std::set<std::string> names;
    for (const auto& output : outputs_) names.emplace(output.command);
    return {names.begin(), names.end()};
}

/// Schema of a command's output, without the shared parts.
Json JsonSchemas::own_schema(const std::string& command) const {
    std::vector<DescribedOutput> described;
    for (const auto& output : outputs_)
        if (output.command == command) described.push_back(output);
    if (!described.empty()) return schema_of(described);
    throw InvalidArgument(fmt::format("'{}' has no schema; expected {}", command, fmt::join(commands(), ", ")));
}

Json JsonSchemas::shared_parts() const {
    std::map<std::string, Json> parts;
    output::add_schemas_of_numbers(parts);
    for (const auto& output : outputs_) output::add_named_schemas(*output.description, parts);
    return parts;
}

Json JsonSchemas::of(const std::string& command) const {
    const auto own = own_schema(command);
    const auto parts = shared_parts();
    std::set<std::string> names;
    add_references(own, parts, names);
    Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                {"$id", fmt::format("urn:setae:{}:{}", SETAE_VERSION, file_of(command))},
                {"title", fmt::format("setae {} --json", command)}};
    schema.update(own);
    schema["$defs"] = chosen(parts, names);
    return schema;
}

std::string schema_file(const std::string& command) { return file_of(command) + ".schema.json"; }

}  // namespace setae::answers
