// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "setae/answers/json_schemas.hpp"

namespace setae::answers {
namespace {

using output::Json;

std::string text_of(const Json& schema, const char* key) { return schema.value(key, std::string{}); }

/// Texts with " or " between them.
template <class Items, class ToText>
std::string alternatives(const Items& items, ToText to_text) {
    std::string text;
    for (const auto& item : items) text += (text.empty() ? "" : " or ") + to_text(item);
    return text;
}

std::string type_of(const Json& schema) {
    if (schema.contains("$ref")) {
        const auto reference = text_of(schema, "$ref");
        const auto name = reference.substr(reference.rfind('/') + 1);
        return fmt::format("[{0}](#{0})", name);
    }
    if (schema.contains("anyOf")) return alternatives(schema["anyOf"], type_of);
    if (schema.contains("enum"))
        return alternatives(schema["enum"],
                            [](const Json& value) { return fmt::format("`{}`", value.get<std::string>()); });
    const auto& type = schema.at("type");
    if (type.is_array()) return alternatives(type, [](const Json& one) { return one.get<std::string>(); });
    if (type == "array") return schema.contains("items") ? "list of " + type_of(schema["items"]) : "list";
    if (type == "object" && schema.contains("additionalProperties"))
        return type_of(schema["additionalProperties"]) + " by name";
    return type;
}

void add_rows(const Json& schema, const std::string& prefix, std::string& rows);

/// Schemas that may contain further names: a part, the contents of a list or of an object by name, the part other than
/// null.
void add_rows_within(const Json& schema, const std::string& name, std::string& rows) {
    add_rows(schema, name + ".", rows);
    if (schema.contains("items")) add_rows(schema["items"], name + "[].", rows);
    if (schema.contains("additionalProperties")) add_rows(schema["additionalProperties"], name + ".NAME.", rows);
    if (schema.contains("anyOf"))
        for (const auto& one : schema["anyOf"]) add_rows_within(one, name, rows);
}

void add_rows(const Json& schema, const std::string& prefix, std::string& rows) {
    if (!schema.contains("properties")) return;
    for (const auto& [name, property] : schema["properties"].items()) {
        rows += fmt::format("| `{}{}` | {} | {} | {} |\n", prefix, name, type_of(property), text_of(property, "unit"),
                            text_of(property, "description"));
        add_rows_within(property, prefix + name, rows);
    }
}

/// Rows of a part from which on a reference to the part replaces the rows.
constexpr std::size_t min_referenced_rows = 5;

/// Whether a schema has all properties of another one and more.
bool contains(const Json& properties, const Json& others) {
    if (others.size() >= properties.size()) return false;
    for (const auto& [name, property] : others.items())
        if (!properties.contains(name) || properties[name] != property) return false;
    return true;
}

/// Name of the largest part whose properties a schema contains; empty without one.
///
/// A result that contains another result has the fields of both at one level, in JSON and in its schema.
std::string contained_part(const Json& schema, const Json& parts) {
    std::string largest;
    std::size_t size = min_referenced_rows - 1;
    for (const auto& [name, part] : parts.items()) {
        if (!part.contains("properties") || part["properties"].size() <= size) continue;
        if (!contains(schema["properties"], part["properties"])) continue;
        largest = name;
        size = part["properties"].size();
    }
    return largest;
}

/// A table of the properties of an object, or of the entries of a list; a reference to a part replaces the rows of the
/// part.
std::string table_of(Json schema, const Json& parts) {
    std::string text, rows;
    if (schema.value("type", "") == "array") add_rows(schema["items"], "[].", rows);
    else if (schema.contains("properties")) {
        const auto part = contained_part(schema, parts);
        if (!part.empty()) {
            text = fmt::format("\nThe object contains all names of [{0}](#{0}) and those of the table.\n", part);
            for (const auto& [name, property] : parts[part]["properties"].items()) schema["properties"].erase(name);
        }
        add_rows(schema, "", rows);
    }
    return rows.empty() ? text : text + "\n| name | type | unit | meaning |\n|---|---|---|---|\n" + rows;
}

/// Description of a schema, and the names in it.
std::string described(const Json& schema, const Json& parts) {
    const bool named = schema.contains("properties");
    return fmt::format("\n{}{}.\n", named ? "" : type_of(schema) + ": ", text_of(schema, "description")) +
           table_of(schema, parts);
}

std::string section(const std::string& title, const Json& schema, const Json& parts) {
    auto text = fmt::format("\n## {}\n", title);
    const bool one_of_several = schema.contains("anyOf") && schema["anyOf"].front().contains("description");
    if (!one_of_several) return text + described(schema, parts);
    for (const auto& one : schema["anyOf"]) text += described(one, parts);
    return text;
}

}  // namespace

std::string json_page(const JsonSchemas& schemas) {
    std::string text =
        "# Names of JSON\n\n*Reference · [all documents](../README.md)*\n\n"
        "Made by `setae schema --documentation docs/reference` from the schemas that `setae schema COMMAND` prints: edit those, not this page.\n"
        "The name of an object precedes a dot, `[]` denotes the entries of a list, NAME a name given by the user. Numbers are in SI; `null` is given where\n"
        "a number is unknown or a part is missing.\n";
    const auto parts = schemas.shared_parts();
    for (const auto& command : schemas.commands()) text += section("setae " + command, schemas.of(command), parts);
    for (const auto& [name, part] : parts.items()) text += section(name, part, parts);
    return text;
}

}  // namespace setae::answers
