// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/field_json.hpp"

#include <vector>

#include <nlohmann/json.hpp>

namespace setae::output {
namespace {

using fields::Kind;
using fields::Missing;
using fields::Row;

/// Whether a field NAME_reason gives the reason for a missing value.
bool has_reason(const Row& row) {
    return row.if_missing == Missing::with_reason || row.if_missing == Missing::as_asked;
}

/// Whether every result has the field, with a value or without.
bool is_required(const Row& row) { return row.if_missing != Missing::left_out && row.if_missing != Missing::as_asked; }

class JsonSink final : public fields::Sink {
public:
    explicit JsonSink(Json& json) : open_{&json} {}

    void flag(const Row& row, bool value) override { add(row, value); }
    void whole(const Row& row, long long value) override { add(row, value); }
    void whole(const Row& row, std::uint64_t value) override { add(row, value); }
    void number(const Row& row, double value) override { add(row, output::number(value)); }
    void value(const Row& row, double value) override {
        add(row, {{"value", output::number(value)}, {"unit", row.unit}});
    }
    void quantity(const Row& row, const Estimate& value) override { quantity(row, Quantity{.estimate = value}); }
    void quantity(const Row& row, const Quantity& value) override {
        auto whole = value;
        const auto fill = [](std::string& text, std::string_view of_row) {
            if (text.empty()) text = of_row;
        };
        if (!row.term.empty()) whole.quantity = row.term;
        fill(whole.quantity, row.name);
        fill(whole.symbol, row.symbol);
        fill(whole.unit, row.unit);
        fill(whole.source, row.source);
        add(row, to_json(whole));
    }
    void fields_of(const Quantity& value) override { open_.back()->update(to_json(value)); }
    void text(const Row& row, std::string_view value) override { add(row, value); }
    void begin_list(const Row& row) override {
        if (row.kind != Kind::values) return open(row, Json::array());
        open(row, {{"values", Json::array()}, {"unit", row.unit}});
        open_.push_back(&open_.back()->at("values"));
    }
    void end_list(const Row& row) override {
        if (row.kind == Kind::values) open_.pop_back();
        open_.pop_back();
    }
    void begin(const Row& row) override { open(row, Json::object()); }
    void end(const Row&) override { open_.pop_back(); }
    void key(std::string_view name) override { key_ = name; }
    void missing(const Row& row, std::string_view reason) override {
        add(row, nullptr);
        if (has_reason(row)) (*open_.back())[std::string(row.name) + "_reason"] = reason;
    }

private:
    Json& add(const Row& row, Json value) {
        auto& in = *open_.back();
        if (in.is_array()) return in.emplace_back(std::move(value));
        const bool by_name = !key_.empty();
        auto& place = in[by_name ? key_ : std::string(row.name)];
        key_.clear();
        return place = std::move(value);
    }
    void open(const Row& row, Json value) { open_.push_back(&add(row, std::move(value))); }

    std::vector<Json*> open_;
    std::string key_;  ///< key of the next entry, in an object by name
};

Json reference(std::string_view name) { return {{"$ref", "#/$defs/" + std::string(name)}}; }
Json type(const char* name) { return {{"type", name}}; }
Json by_name(Json held) { return {{"type", "object"}, {"additionalProperties", std::move(held)}}; }
Json list_of(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

/// Names and which of them every result has.
Json object_of(const fields::Description& description);

Json inner_type(const Row& row) { return row.inner->name.empty() ? object_of(*row.inner) : reference(row.inner->name); }

/// Type of the value under a name, with one level of lists.
Json flat_type_of(const Row& row) {
    switch (row.kind) {
        case Kind::flag: return type("boolean");
        case Kind::whole: return type("integer");
        case Kind::number: return reference("number");
        case Kind::value: return reference("value");
        case Kind::values: return reference("values");
        case Kind::quantity: return reference("quantity");
        case Kind::text: return type("string");
        case Kind::choice: return {{"enum", row.choices}};
        case Kind::numbers: return list_of(reference("number"));
        case Kind::matrix: return list_of(list_of(reference("number")));
        case Kind::texts: return list_of(type("string"));
        case Kind::wholes: return list_of(type("integer"));
        case Kind::object: return inner_type(row);
        case Kind::objects: return list_of(inner_type(row));
        case Kind::quantities: return list_of(reference("quantity"));
        case Kind::quantity_of: return by_name(reference("quantity"));
        case Kind::number_of: return by_name(reference("number"));
        case Kind::whole_of: return by_name(type("integer"));
        case Kind::text_of: return by_name(type("string"));
        case Kind::objects_of: return by_name(inner_type(row));
    }
    return {};
}

/// Type of the value under a name.
Json type_of(const Row& row) {
    auto type = flat_type_of(row);
    for (int level = 1; level < row.levels; ++level) type = list_of(std::move(type));
    return type;
}

Json property_of(const Row& row) {
    Json property{{"description", row.meaning}};
    if (row.kind == Kind::quantity) property["quantity"] = row.term.empty() ? row.name : row.term;
    if (!row.symbol.empty()) property["symbol"] = row.symbol;
    if (!row.unit.empty()) property["unit"] = row.unit;
    const bool may_be_null = row.if_missing != Missing::never && row.if_missing != Missing::left_out;
    if (may_be_null) property["anyOf"] = {type_of(row), type("null")};
    else property.update(type_of(row));
    return property;
}

/// Adds a property, or the term and symbol of a quantity that other results have under the same name.
void add_property(Json& property, const Row& row) {
    auto added = property_of(row);
    if (property.contains("quantity") && added.contains("quantity") && property["quantity"] != added["quantity"])
        for (const char* key : {"quantity", "symbol"})
            added[key] = Json::array({property.value(key, ""), added.value(key, "")});
    property = std::move(added);
}

Json object_of(const fields::Description& description) {
    Json required = Json::array(), properties = Json::object();
    for (const auto& row : description.rows) {
        if (row.among) {
            auto base = object_of(*row.inner);
            if (is_required(row))
                for (auto& name : base["required"]) required.push_back(std::move(name));
            properties.update(base["properties"]);
        }
        if (row.name.empty()) continue;
        const std::string name(row.name);
        if (is_required(row)) required.push_back(name);
        add_property(properties[name], row);
        if (has_reason(row)) properties[name + "_reason"] = {{"description", "why it is missing"}, {"type", "string"}};
    }
    return {{"type", "object"}, {"required", std::move(required)}, {"properties", std::move(properties)}};
}

}  // namespace

void add_fields(Json& json, const void* result, const fields::Description& description) {
    JsonSink sink(json);
    fields::put(result, description, sink);
}

Json described(const void* result, const fields::Description& description) {
    Json json = Json::object();
    add_fields(json, result, description);
    return json;
}

Json schema_of(const fields::Description& description) {
    Json schema{{"description", description.meaning}};
    schema.update(object_of(description));
    return schema;
}

void add_named_schemas(const fields::Description& description, std::map<std::string, Json>& schemas) {
    if (!description.name.empty() && !description.rows.empty())
        schemas[std::string(description.name)] = schema_of(description);
    for (const auto& row : description.rows)
        if (row.inner) add_named_schemas(*row.inner, schemas);
}

void add_schemas_of_numbers(std::map<std::string, Json>& schemas) {
    schemas["number"] = {{"description", "number; null where it is unknown"},
                         {"anyOf", {type("number"), type("null"), {{"enum", {"infinity", "-infinity"}}}}}};
    for (const auto* description :
         {&fields::value_description, &fields::values_description, &fields::quantity_description})
        add_named_schemas(*description, schemas);
}

}  // namespace setae::output
