// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/units.hpp"
#include "setae/processing/parameters.hpp"
#include "setae/processing/region.hpp"
#include "value_text.hpp"

namespace setae::processing {

/// A visitor that handles all parameters as text: calls handle(name, values, text, meaning, set) for each; `values`
/// describes the possible values, `text` is the value (empty: absent), set(text) changes it.
template <class Handle>
struct TextVisitor {
    Handle handle;

    void length(std::string_view name, double& value, std::string_view meaning) {
        handle(name, "length", length_text(value), meaning,
               [&](std::string_view text) { value = parse_quantity(text, dimension::length); });
    }
    void optional_length(std::string_view name, std::optional<double>& value, std::string_view meaning) {
        handle(name, "length", value ? length_text(*value) : std::string(), meaning,
               [&](std::string_view text) { value = parse_quantity(text, dimension::length); });
    }
    void number(std::string_view name, double& value, std::string_view meaning) {
        handle(name, "number", number_text(value), meaning,
               [&](std::string_view text) { value = parsed_number(text); });
    }
    void angle(std::string_view name, double& value, std::string_view meaning) {
        handle(name, "angle", angle_text(value), meaning, [&](std::string_view text) { value = parsed_angle(text); });
    }
    void count(std::string_view name, Index& value, std::string_view meaning) {
        handle(name, "whole number", std::to_string(value), meaning,
               [&](std::string_view text) { value = parsed_count(text); });
    }
    void flag(std::string_view name, bool& value, std::string_view meaning) {
        handle(name, "true or false", std::string(value ? "true" : "false"), meaning,
               [&](std::string_view text) { value = parsed_flag(text); });
    }
    void text(std::string_view name, std::string& value, std::string_view meaning) {
        handle(name, "text", std::string(value), meaning, [&](std::string_view text) { value = text; });
    }
    void region(std::string_view name, Region& value, std::string_view meaning) {
        handle(name, "region", processing::text(value), meaning,
               [&](std::string_view text) { value = region_from_text(text); });
    }
    template <class Value, std::size_t n>
    void choice(std::string_view name, Value& value, const std::array<Choice<Value>, n>& choices,
                std::string_view meaning) {
        std::string values, current;
        for (const auto& option : choices) {
            values += (values.empty() ? "" : ", ") + std::string(option.name);
            if (option.value == value) current = option.name;
        }
        handle(name, values, current, meaning, [&](std::string_view text) {
            for (const auto& option : choices)
                if (option.name == text) {
                    value = option.value;
                    return;
                }
            refuse_choice(text, values);
        });
    }
};
template <class Handle>
TextVisitor(Handle) -> TextVisitor<Handle>;

}  // namespace setae::processing
