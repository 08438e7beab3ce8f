// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "setae/fields/option.hpp"

namespace setae::python {

/// Python keywords of options of the library: "work_of_adhesion" is W_int.
std::map<std::string, std::string, std::less<>>& keywords();

/// Registers a keyword; an option with several keywords keeps its own name.
inline void note_keyword(const fields::Option& option) {
    const std::string name(option.name), keyword(option.keyword.empty() ? option.name : option.keyword);
    const auto [noted, is_new] = keywords().emplace(name, keyword);
    if (!is_new && noted->second != keyword) noted->second = name;
}

/// The kind of a Python value in messages.
template <class Value>
constexpr const char* kind_of(const Value&) {
    if constexpr (std::is_same_v<Value, bool>) return "True or False";
    else if constexpr (std::is_integral_v<Value>) return "a whole number";
    else if constexpr (std::is_floating_point_v<Value>) return "a number";
    else return "a text";
}
template <class Value>
constexpr const char* kind_of(const std::optional<Value>&) {
    return kind_of(Value());
}
template <class Value>
constexpr const char* kind_of(const std::vector<Value>&) {
    return std::is_same_v<Value, std::string> ? "a list of texts" : "a list of numbers";
}

/// Check a value as the command line does. @throws InvalidArgument that names the argument.
void require_valid_text(const fields::Option& option, std::string_view argument, const std::string& text);
void require_valid_number(const fields::Option& option, std::string_view argument, double value);

template <class Value>
void require_valid(const fields::Option& option, std::string_view argument, const Value& value) {
    if constexpr (std::is_same_v<Value, std::string>) require_valid_text(option, argument, value);
    else if constexpr (!std::is_same_v<Value, bool>) require_valid_number(option, argument, static_cast<double>(value));
}
template <class Value>
void require_valid(const fields::Option& option, std::string_view argument, const std::optional<Value>& value) {
    if (value) require_valid(option, argument, *value);
}
template <class Value>
void require_valid(const fields::Option& option, std::string_view argument, const std::vector<Value>& values) {
    for (const auto& value : values) require_valid(option, argument, value);
}

/// True for reserved words of Python: an option with this name has another keyword.
inline bool is_reserved(std::string_view name) {
    return nb::cast<bool>(nb::module_::import_("keyword").attr("iskeyword")(std::string(name)));
}

/// The help of an option and its words, the source of the documentation of keywords.
inline std::string documentation_of(const fields::Option& option) {
    auto text = fields::help_of(option);
    for (const auto& word : option.choices)
        text += (&word == &option.choices.front() ? "; one of " : ", ") + std::string(word);
    return text;
}

/// Binds the options of a request, or of a part of it, as attributes by name and by keyword, with their meaning.
template <class Request, class Part = Request>
void bind_options(nb::class_<Request>& request, std::span<const fields::Option> options) {
    for (const auto& option : options) {
        note_keyword(option);
        const auto place = option.place;
        const auto help = documentation_of(option);
        const auto get = [place](Request& self) {
            return std::visit([](const auto* value) { return nb::cast(*value); }, place(static_cast<Part*>(&self)));
        };
        for (const auto name : {option.name, option.keyword}) {
            if (name.empty() || is_reserved(name)) continue;
            const auto set = [&option, name](Request& self, nb::object value) {
                std::visit(
                    [&](auto* member) {
                        if (nb::try_cast(value, *member)) return require_valid(option, name, *member);
                        const std::string given = nb::type_name(value.type()).c_str();
                        throw nb::type_error(
                            (std::string(name) + ": " + given + "; expected " + kind_of(*member)).c_str());
                    },
                    option.place(static_cast<Part*>(&self)));
            };
            request.def_prop_rw(std::string(name).c_str(), get, set, help.c_str());
        }
    }
}
template <class Request, class Part = Request>
void bind_asked(nb::class_<Request>& request) {
    bind_options<Request, Part>(request, fields::Asked<Part>::options);
}

}  // namespace setae::python
