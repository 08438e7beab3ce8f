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

/// Description of a schema, and the names in it.
std::string described(const Json& schema) {
    const bool named = schema.contains("properties");
    auto text = fmt::format("\n{}{}.\n", named ? "" : type_of(schema) + ": ", text_of(schema, "description"));
    std::string rows;
    if (schema.value("type", "") == "array") add_rows(schema["items"], "[].", rows);
    else add_rows(schema, "", rows);
    if (!rows.empty()) text += "\n| name | type | unit | meaning |\n|---|---|---|---|\n" + rows;
    return text;
}

std::string section(const std::string& title, const Json& schema) {
    auto text = fmt::format("\n## {}\n", title);
    const bool one_of_several = schema.contains("anyOf") && schema["anyOf"].front().contains("description");
    if (!one_of_several) return text + described(schema);
    for (const auto& one : schema["anyOf"]) text += described(one);
    return text;
}

}  // namespace

std::string json_page(const JsonSchemas& schemas) {
    std::string text =
        "# Names of JSON\n\n*Reference · [all documents](../README.md)*\n\n"
        "Made by `setae schema --documentation docs/reference` from the schemas that `setae schema COMMAND` prints: edit those, not this page.\n"
        "The name of an object precedes a dot, `[]` denotes the entries of a list, NAME a name given by the user. Numbers are in SI; `null` is given where\n"
        "a number is unknown or a part is missing.\n";
    for (const auto& command : schemas.commands()) text += section("setae " + command, schemas.of(command));
    const auto parts = schemas.shared_parts();
    for (const auto& [name, part] : parts.items()) text += section(name, part);
    return text;
}

}  // namespace setae::answers
