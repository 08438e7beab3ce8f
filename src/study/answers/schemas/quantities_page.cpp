// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "setae/answers/json_schemas.hpp"

namespace setae::answers {
namespace {

using output::Json;

/// Quantities by name, symbol and unit.
using Quantities = std::map<std::tuple<std::string, std::string, std::string>, QuantityInJson>;

/// The text of a key, or the texts of a list.
std::vector<std::string> texts_of(const Json& property, const char* key) {
    if (!property.contains(key)) return {""};
    if (property[key].is_array()) return property[key];
    return {property[key]};
}

/// Adds the quantity of a property, or the quantities that different results have under the same name.
void add_quantity(const Json& property, const std::string& place, Quantities& found) {
    const auto names = texts_of(property, "quantity"), symbols = texts_of(property, "symbol");
    const auto unit = property.value("unit", std::string{});
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto& quantity = found[{names[i], symbols[i], unit}];
        quantity.name = names[i];
        quantity.symbol = symbols[i];
        quantity.unit = unit;
        if (quantity.meaning.empty()) quantity.meaning = property.value("description", std::string{});
        quantity.places.push_back(place);
    }
}

void add_quantities(const Json& schema, const std::string& place, Quantities& found) {
    if (schema.contains("properties"))
        for (const auto& [name, property] : schema["properties"].items()) {
            const auto here = place + name;
            add_quantities(property, here + ".", found);
            if (property.contains("quantity")) add_quantity(property, here, found);
        }
    if (schema.contains("items")) add_quantities(schema["items"], place + "[].", found);
    if (schema.contains("additionalProperties")) add_quantities(schema["additionalProperties"], place + "NAME.", found);
    if (schema.contains("anyOf"))
        for (const auto& one : schema["anyOf"]) add_quantities(one, place, found);
}

/// The first places, and the number of the others.
std::string shown(const std::vector<std::string>& places) {
    constexpr std::size_t max_shown = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(max_shown, places.size()); ++i)
        text += fmt::format("{}`{}`", i == 0 ? "" : ", ", places[i]);
    return places.size() <= max_shown ? text : text + fmt::format(" and {} more", places.size() - max_shown);
}

}  // namespace

std::vector<QuantityInJson> quantities_in_json(const JsonSchemas& schemas) {
    Quantities found;
    for (const auto& command : schemas.commands()) {
        auto schema = schemas.of(command);
        schema.erase("$defs");
        add_quantities(schema, command + ": ", found);
    }
    const auto parts = schemas.shared_parts();
    for (const auto& [name, part] : parts.items()) add_quantities(part, name + ".", found);
    std::vector<QuantityInJson> quantities;
    for (auto& [key, quantity] : found) quantities.push_back(std::move(quantity));
    return quantities;
}

std::string quantities_page(const JsonSchemas& schemas) {
    std::string text =
        "# Quantities\n\n*Reference · [all documents](../README.md)*\n\n"
        "Made by `setae schema --documentation docs/reference`: edit the descriptions of results, not this page.\n"
        "A quantity in JSON, such as `{\"quantity\": \"apparent_work_of_adhesion\", \"symbol\": \"W_app\", …}`, has a "
        "name, a symbol\nand a unit; each name has one symbol and one unit. No unit: that of the data. \"Where\" gives "
        "places in the\n[JSON](json.md): `COMMAND: name`, or `part.name` of a part that several commands share. The "
        "[glossary](glossary.md) defines the\nterms.\n\n| quantity | symbol | unit | meaning | where |\n"
        "|---|---|---|---|---|\n";
    for (const auto& quantity : quantities_in_json(schemas))
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", quantity.name, quantity.symbol, quantity.unit,
                            quantity.meaning, shown(quantity.places));
    return text;
}

}  // namespace setae::answers
