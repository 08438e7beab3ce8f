// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "setae/core/units.hpp"
#include "setae/fields/member_of.hpp"

namespace setae::fields {

/// Location of the value of an option in a request.
using Place = std::variant<bool*, int*, long*, std::uint64_t*, double*, std::string*, std::optional<long>*,
                           std::optional<std::uint64_t>*, std::optional<double>*, std::optional<std::string>*,
                           std::vector<std::string>*, std::vector<long>*, std::vector<double>*>;

/// Allowed integers of an option, both ends included.
struct WholeNumbers {
    int least = 0, greatest = 0;
};

/// An option of a request: name, meaning, domain and location of its value. The command line, the keys of a study, the
/// Python package and the reference pages are generated from it.
struct Option {
    std::string_view name{};                           ///< snake_case; --with-dashes on the command line
    std::string_view meaning{};                        ///< a complete noun phrase: "radius of the sphere"
    std::string_view also{};                           ///< a second, shorter name on the command line: "w"
    std::string_view keyword{};                        ///< in Python, if it differs from the name: "W_int"
    std::string_view example{};                        ///< a value: "50 mJ/m2"
    std::string_view otherwise{};                      ///< value if not given: "four pixels"
    std::string_view word{};                           ///< for a positional argument: "table"
    std::optional<Expected> quantity{};                ///< for a text with a unit
    std::string_view usual_unit{};                     ///< unit of a number without unit: "nm"
    std::optional<Domain> domain{};                    ///< for a number
    std::optional<WholeNumbers> whole{};               ///< of a whole number
    std::span<const std::string_view> choices{};       ///< allowed words
    std::vector<std::string> (*offered)() = nullptr;   ///< completions in shells; other words are allowed, too
    void (*check)(const std::string& text) = nullptr;  ///< throws InvalidArgument for a malformed text
    bool named_each_time = false;                      ///< the name is repeated before each of several values
    bool shows_default = false;                        ///< the value of a new request is shown as the default
    char separator = '\0';                             ///< between several values in one word: ',' in "12,17"
    bool is_input = false;                             ///< an input file
    bool is_required = false;                          ///< help lists it first; the request checks it
    bool is_advanced = false;                          ///< help lists it last
    Place (*place)(void* request) = nullptr;

    [[nodiscard]] consteval Option of(const Expected& expected, std::string_view unit = {}) const {
        Option option = *this;
        option.quantity = expected;
        option.usual_unit = unit;
        return option;
    }
    [[nodiscard]] consteval Option within(const Domain& values) const {
        Option option = *this;
        option.domain = values;
        return option;
    }
    [[nodiscard]] consteval Option between(int least, int greatest) const {
        Option option = *this;
        option.whole = {least, greatest};
        return option;
    }
    [[nodiscard]] consteval Option one_of(std::span<const std::string_view> words) const {
        Option option = *this;
        option.choices = words;
        return option;
    }
    [[nodiscard]] consteval Option offering(std::vector<std::string> (*words)()) const {
        Option option = *this;
        option.offered = words;
        return option;
    }
    [[nodiscard]] consteval Option read_by(void (*reader)(const std::string&)) const {
        Option option = *this;
        option.check = reader;
        return option;
    }
    [[nodiscard]] consteval Option such_as(std::string_view value) const {
        Option option = *this;
        option.example = value;
        return option;
    }
    [[nodiscard]] consteval Option or_else(std::string_view what_holds) const {
        Option option = *this;
        option.otherwise = what_holds;
        return option;
    }
    [[nodiscard]] consteval Option one_at_a_time() const {
        Option option = *this;
        option.named_each_time = true;
        return option;
    }
    [[nodiscard]] consteval Option default_shown() const {
        Option option = *this;
        option.shows_default = true;
        return option;
    }
    [[nodiscard]] consteval Option separated_by(char between) const {
        Option option = *this;
        option.separator = between;
        return option;
    }
    [[nodiscard]] consteval Option of_input() const {
        Option option = *this;
        option.is_input = true;
        return option;
    }
    [[nodiscard]] consteval Option required() const {
        Option option = *this;
        option.is_required = true;
        return option;
    }
    [[nodiscard]] consteval Option advanced() const {
        Option option = *this;
        option.is_advanced = true;
        return option;
    }
    [[nodiscard]] consteval Option short_name(std::string_view letter) const {
        Option option = *this;
        option.also = letter;
        return option;
    }
    [[nodiscard]] consteval Option or_word(std::string_view argument) const {
        Option option = *this;
        option.word = argument;
        return option;
    }
    [[nodiscard]] consteval Option in_python(std::string_view name_there) const {
        Option option = *this;
        option.keyword = name_there;
        return option;
    }
};

/// The options of a request type: specialised next to the type, with `static constexpr std::array options`.
template <class Request>
struct Asked;

namespace detail {

template <auto Member>
Place place_of(void* request) {
    using Request = typename MemberOf<decltype(Member)>::Object;
    return &(static_cast<Request*>(request)->*Member);
}

}  // namespace detail

/// A member that is an option.
template <auto Member>
consteval Option option(std::string_view name, std::string_view meaning) {
    return {.name = name, .meaning = meaning, .place = detail::place_of<Member>};
}

/// The help text: meaning, example, and value if not given.
[[nodiscard]] std::string help_of(const Option& option);

/// Spelling of an option in a front end, with a value or an empty one; empty if the front end lacks the option.
using Spelling = std::function<std::string(std::string_view name, std::string_view value)>;

/// A message in which `name` or `name = value` in back quotes is an option, spelled as in a front end: --name "value"
/// on the command line, name="value" in Python. Other words in back quotes are unchanged.
[[nodiscard]] std::string spelled(std::string_view message, const Spelling& spelling);

}  // namespace setae::fields
