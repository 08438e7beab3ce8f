// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/toml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "setae/bytes/nesting.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::bytes {
namespace {

FilePosition position_at(const toml::source_position& place) { return {.line = place.line}; }

FilePosition position(const toml::node& node) { return position_at(node.source().begin); }

}  // namespace

toml::table parse_toml_file(const std::string& path) {
    const auto text = read_file(path);
    if (const auto at = toml_too_deep(text))
        throw FormatError(path,
                          {.line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(*at), '\n')},
                          fmt::format("TOML: more than {} levels of nesting", max_levels));
    try {
        return toml::parse(text, path);
    } catch (const toml::parse_error& error) {
        throw FormatError(path, position_at(error.source().begin), fmt::format("TOML: {}", error.description()));
    }
}

TomlReader::TomlReader(const toml::table& table, std::string path, std::string where)
    : table_(&table),
      path_(std::move(path)),
      where_(std::move(where)),
      warnings_(std::make_shared<std::vector<KeyWarning>>()) {}

const toml::node* TomlReader::find(const char* key) {
    known_.insert(key);
    return table_->get(key);
}

void TomlReader::fail(const char* key, const std::string& what) const {
    const auto* node = table_->get(key);
    throw FormatError(path_, position(node ? *node : static_cast<const toml::node&>(*table_)),
                      fmt::format("{}{}: {}", where_.empty() ? "" : where_ + ".", key, what));
}

void TomlReader::warn(const char* key, std::string text) {
    const auto* node = table_->get(key);
    const auto& place = node ? *node : static_cast<const toml::node&>(*table_);
    warnings_->push_back({fmt::format("{}:{}", path_, place.source().begin.line),
                          where_.empty() ? std::string(key) : fmt::format("{}.{}", where_, key), std::move(text)});
}

std::string TomlReader::without_zero_byte(const char* key, const std::string& text) const {
    if (text.find('\0') != std::string::npos) fail(key, "a text contains a zero byte (\\u0000); remove it");
    return text;
}

std::optional<std::string> TomlReader::text(const char* key) {
    const auto* node = find(key);
    if (!node) return std::nullopt;
    if (const auto* value = node->as_string()) return without_zero_byte(key, value->get());
    fail(key, "expected a text in quotes");
}

std::string TomlReader::required_text(const char* key) {
    if (auto value = text(key)) return *value;
    fail(key, "missing; expected a text");
}

std::optional<double> TomlReader::number(const char* key, const Domain& domain) {
    return quantity(key, {dimension::none, domain});
}

std::optional<bool> TomlReader::boolean(const char* key) {
    const auto* node = find(key);
    if (!node) return std::nullopt;
    if (const auto value = node->value_exact<bool>()) return value;
    fail(key, "expected true or false");
}

std::optional<std::int64_t> TomlReader::integer(const char* key) {
    const auto* node = find(key);
    if (!node) return std::nullopt;
    if (const auto* value = node->as_integer()) return value->get();
    fail(key, "expected a whole number");
}

Estimate TomlReader::parse(const char* key, const toml::node& node, const Expected& expected) const {
    if (node.is_number()) {
        const double value = *node.value<double>();
        if (expected.dimension != dimension::none)
            fail(key, fmt::format("a number without unit; write it in quotes with its unit, such as \"{} {}\"", value,
                                  si_unit(expected.dimension)));
        try {
            require_within(expected.domain, value, fmt::format("{}", value));
        } catch (const InvalidArgument& error) {
            fail(key, error.what());
        }
        return {value, 0.0};
    }
    if (!node.is_string()) fail(key, "expected a number with its unit in quotes");
    try {
        auto value = parse_text(key, node, expected);
        if (value.input.empty() && value.uncertain()) value.input = where_.empty() ? key : where_ + "." + key;
        return value;
    } catch (const InvalidArgument& error) {
        fail(key, error.what());
    }
}

Estimate TomlReader::parse_text(const char* key, const toml::node& node, const Expected& expected) const {
    const auto text = std::string(trimmed(node.as_string()->get()));
    if (!named_) return parse_uncertain_quantity(text, expected);
    if (named_->inputs.contains(text)) return named(text, "", node, expected);
    const auto equals = text.find('=');
    if (equals != std::string::npos) {
        const auto name = std::string(trimmed(text.substr(0, equals)));
        if (name.empty()) fail(key, fmt::format("'{}', expected a name before '='", text));
        return named(name, std::string(trimmed(text.substr(equals + 1))), node, expected);
    }
    try {
        return parse_uncertain_quantity(text, expected);
    } catch (const InvalidArgument& error) {
        std::vector<std::string> names;
        for (const auto& [name, input] : named_->inputs) names.push_back(name);
        const auto nearest = nearest_match(text, names);
        if (nearest.empty()) throw;
        throw InvalidArgument(fmt::format("{}; did you mean the input '{}'?", error.what(), nearest));
    }
}

/// A reference to a named input; with a value it is the first one or must repeat the value.
Estimate TomlReader::named(const std::string& name, const std::string& value, const toml::node& node,
                           const Expected& expected) const {
    const auto [at, fresh] = named_->inputs.try_emplace(name, NamedInputs::Named{value, node.source().begin, true});
    auto& input = at->second;
    input.used = true;
    auto estimate = parse_uncertain_quantity(input.text, expected);
    if (!fresh && !value.empty()) {
        const auto again = parse_uncertain_quantity(value, expected);
        const auto alike = [](double a, double b) {
            constexpr double rounding = 1e-12;  // 1250 um and 1.25 mm
            return std::abs(a - b) <= rounding * std::abs(a);
        };
        if (!alike(estimate.value, again.value) || !alike(estimate.standard_error, again.standard_error))
            throw InvalidArgument(
                fmt::format("input '{}' is '{}' here and '{}' in line {}; expected one value per name", name, value,
                            input.text, input.place.line));
    }
    estimate.input = name;
    return estimate;
}

void TomlReader::name_inputs(const char* key) {
    named_ = std::make_shared<NamedInputs>();
    table(key, [&](TomlReader group) {
        for (const auto& name : group.keys()) {
            const auto* node = group.find(name.c_str());
            if (!node->is_string() && !node->is_number())
                group.fail(name.c_str(), "expected a value with its ± and unit in quotes");
            const auto text = node->is_string() ? node->as_string()->get() : fmt::format("{}", *node->value<double>());
            named_->inputs[name] = {text, node->source().begin, false};
        }
    });
}

void TomlReader::require_inputs_used() const {
    if (!named_) return;
    for (const auto& [name, input] : named_->inputs)
        if (!input.used)
            throw FormatError(
                path_, position_at(input.place),
                fmt::format(
                    "no key uses the input '{}'; write its name in place of its value, such as surface_energy = "
                    "\"{}\"",
                    name, name));
}

TomlReader TomlReader::inner(const toml::table& table, std::string where) const {
    TomlReader reader(table, path_, std::move(where));
    reader.named_ = named_;
    reader.warnings_ = warnings_;
    return reader;
}

std::optional<Estimate> TomlReader::uncertain(const char* key, const Expected& expected) {
    const auto* node = find(key);
    if (!node) return std::nullopt;
    return parse(key, *node, expected);
}

Estimate TomlReader::required_uncertain(const char* key, const Expected& expected) {
    if (auto value = uncertain(key, expected)) return *value;
    fail(key, fmt::format("missing; expected a quantity in {}", si_unit(expected.dimension)));
}

std::optional<double> TomlReader::quantity(const char* key, const Expected& expected) {
    const auto value = uncertain(key, expected);
    return value ? std::optional(value->value) : std::nullopt;
}

template <class Value>
std::vector<Value> TomlReader::list(const char* key, const std::function<Value(const toml::node&)>& convert) {
    const auto* node = find(key);
    if (!node) return {};
    const auto* array = node->as_array();
    if (!array) fail(key, "expected a list in brackets");
    std::vector<Value> values;
    for (const auto& element : *array) values.push_back(convert(element));
    return values;
}

std::vector<std::string> TomlReader::texts(const char* key) {
    return list<std::string>(key, [&](const toml::node& node) -> std::string {
        if (const auto* value = node.as_string()) return without_zero_byte(key, value->get());
        fail(key, "expected texts in quotes");
    });
}

std::vector<Estimate> TomlReader::uncertains(const char* key, const Expected& expected) {
    std::size_t index = 0;
    const auto place = (where_.empty() ? "" : where_ + ".") + key;
    return list<Estimate>(key, [&](const toml::node& node) {
        auto value = parse(key, node, expected);
        ++index;
        if (value.input == place) value.input = fmt::format("{}[{}]", place, index);
        return value;
    });
}

std::vector<double> TomlReader::quantities(const char* key, const Expected& expected) {
    return list<double>(key, [&](const toml::node& node) { return parse(key, node, expected).value; });
}

bool TomlReader::contains(const char* key) const { return table_->contains(key); }

bool TomlReader::is_number(const char* key) const {
    const auto* node = table_->get(key);
    return node && node->is_number();
}

bool TomlReader::is_list(const char* key) const {
    const auto* node = table_->get(key);
    return node && node->is_array();
}

bool TomlReader::is_table(const char* key) const {
    const auto* node = table_->get(key);
    return node && node->is_table();
}

void TomlReader::table(const char* key, const std::function<void(TomlReader)>& body) {
    const auto* node = find(key);
    if (!node) return;
    const auto* inner = node->as_table();
    if (!inner) fail(key, "expected a table");
    body(this->inner(*inner, where_.empty() ? key : where_ + "." + key));
}

void TomlReader::named_tables(const char* key, const std::function<void(const std::string&, TomlReader)>& body) {
    table(key, [&](TomlReader group) {
        for (const auto& name : group.keys())
            group.table(name.c_str(), [&](TomlReader inner) { body(name, std::move(inner)); });
    });
}

void TomlReader::each_table(const char* key, const std::function<void(TomlReader)>& body) {
    const auto* node = find(key);
    if (!node) return;
    const auto* array = node->as_array();
    if (!array) fail(key, "expected a list of tables");
    std::size_t index = 0;
    for (const auto& element : *array) {
        const auto* inner = element.as_table();
        if (!inner) fail(key, "expected a list of tables");
        body(this->inner(*inner, fmt::format("{}{}[{}]", where_.empty() ? "" : where_ + ".", key, ++index)));
    }
}

std::string TomlReader::resolved_path(const std::string& path) const {
    const std::filesystem::path given(path);
    return given.is_absolute() ? path
                               : (std::filesystem::path(path_).parent_path() / given).lexically_normal().string();
}

std::vector<std::string> TomlReader::keys() const {
    std::vector<std::pair<toml::source_position, std::string>> found;
    for (const auto& [key, node] : *table_) {
        if (key.str().find('\0') != std::string_view::npos)
            throw FormatError(path_, position_at(key.source().begin),
                              "a key contains a zero byte (\\u0000); remove it");
        found.emplace_back(key.source().begin, std::string(key.str()));
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> names;
    for (auto& [at, name] : found) names.push_back(std::move(name));
    return names;
}

void TomlReader::finish() const {
    for (const auto& [key, node] : *table_) {
        if (known_.contains(std::string(key.str()))) continue;
        const std::vector<std::string> known(known_.begin(), known_.end());
        const auto nearest = nearest_match(key.str(), known);
        throw FormatError(path_, position_at(key.source().begin),
                          fmt::format("unknown key '{}'{}{}", key.str(), where_.empty() ? "" : " in " + where_,
                                      nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
    }
}

}  // namespace setae::bytes
