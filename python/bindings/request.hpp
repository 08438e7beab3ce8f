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

/// Options of a request, or of a part of it, as attributes that Python reads and writes.
template <class Request, class Part = Request>
void bind_options(nb::class_<Request>& request, std::span<const fields::Option> options) {
    for (const auto& option : options) {
        const std::string name(option.name);
        if (!option.keyword.empty()) keywords()[name] = option.keyword;
        const auto place = option.place;
        request.def_prop_rw(
            name.c_str(),
            [place](Request& self) {
                return std::visit([](const auto* value) { return nb::cast(*value); }, place(static_cast<Part*>(&self)));
            },
            [place](Request& self, nb::object value) {
                std::visit([&](auto* member) { *member = nb::cast<std::remove_cvref_t<decltype(*member)>>(value); },
                           place(static_cast<Part*>(&self)));
            });
    }
}
template <class Request, class Part = Request>
void bind_asked(nb::class_<Request>& request) {
    bind_options<Request, Part>(request, fields::Asked<Part>::options);
}

}  // namespace setae::python
