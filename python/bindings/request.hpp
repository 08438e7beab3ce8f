// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "setae/fields/option.hpp"

namespace setae::python {

/// Keywords of Python for options that are called otherwise in the library: "work_of_adhesion" is W_int.
std::map<std::string, std::string, std::less<>>& keywords();

/// What an option is given, as the library keeps it. @throws TypeError that names the option.
template <class Value>
Value as(const nb::object& given, const std::string& option) {
    try {
        return nb::cast<Value>(given);
    } catch (const nb::cast_error&) {
        const std::string type = nb::type_name(given.type()).c_str();
        throw nb::type_error((option + ": a value of type " + type + " is not accepted").c_str());
    }
}

/// The name of an option as an attribute; "from" and "as", which Python reserves, go by their keyword.
inline std::string attribute_of(const fields::Option& option) {
    const std::string name(option.name);
    const bool reserved = nb::cast<bool>(nb::module_::import_("keyword").attr("iskeyword")(name));
    return reserved ? std::string(option.keyword) : name;
}

/// Options of a request, or of a part of it, as attributes that Python reads and writes.
template <class Request, class Part = Request>
void bind_options(nb::class_<Request>& request, std::span<const fields::Option> options) {
    for (const auto& option : options) {
        const auto name = attribute_of(option);
        if (!option.keyword.empty()) keywords()[std::string(option.name)] = option.keyword;
        const auto place = option.place;
        request.def_prop_rw(
            name.c_str(),
            [place](Request& self) {
                return std::visit([](const auto* value) { return nb::cast(*value); }, place(static_cast<Part*>(&self)));
            },
            [place, name](Request& self, nb::object value) {
                std::visit([&](auto* member) { *member = as<std::remove_cvref_t<decltype(*member)>>(value, name); },
                           place(static_cast<Part*>(&self)));
            });
    }
}
template <class Request, class Part = Request>
void bind_asked(nb::class_<Request>& request) {
    bind_options<Request, Part>(request, fields::Asked<Part>::options);
}

}  // namespace setae::python
