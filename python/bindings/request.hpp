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

/// Keywords of Python for options of the library: "work_of_adhesion" is W_int.
std::map<std::string, std::string, std::less<>>& keywords();

/// Notes a keyword; an option that requests call differently goes by its name.
inline void note_keyword(const fields::Option& option) {
    const std::string name(option.name), keyword(option.keyword.empty() ? option.name : option.keyword);
    const auto [noted, is_new] = keywords().emplace(name, keyword);
    if (!is_new && noted->second != keyword) noted->second = name;
}

/// Options of a request, or of a part of it, as attributes that Python reads and writes, by name and by keyword.
template <class Request, class Part = Request>
void bind_options(nb::class_<Request>& request, std::span<const fields::Option> options) {
    for (const auto& option : options) {
        note_keyword(option);
        const auto place = option.place;
        for (const auto name : {option.name, option.keyword})
            if (!name.empty())
                request.def_prop_rw(
                    std::string(name).c_str(),
                    [place](Request& self) {
                        return std::visit([](const auto* value) { return nb::cast(*value); },
                                          place(static_cast<Part*>(&self)));
                    },
                    [place](Request& self, nb::object value) {
                        std::visit(
                            [&](auto* member) { *member = nb::cast<std::remove_cvref_t<decltype(*member)>>(value); },
                            place(static_cast<Part*>(&self)));
                    });
    }
}
template <class Request, class Part = Request>
void bind_asked(nb::class_<Request>& request) {
    bind_options<Request, Part>(request, fields::Asked<Part>::options);
}

}  // namespace setae::python
