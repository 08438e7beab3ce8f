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

/// Where the value of an option is kept in a request.
using Place = std::variant<bool*, int*, long*, std::uint64_t*, double*, std::string*, std::optional<long>*,
                           std::optional<std::uint64_t>*, std::optional<double>*, std::optional<std::string>*,
                           std::vector<std::string>*, std::vector<long>*, std::vector<double>*>;

/// Whole numbers that an option may be, both ends among them.
struct WholeNumbers {
    int least = 0, greatest = 0;
};

/// Something a request asks for: its name, its meaning, its domain, and where its value is kept. The command line, the
/// keys of a study, the Python package and the reference pages are made from it.
struct Option {
    std::string_view name{};                           ///< snake_case; --with-dashes on the command line
    std::string_view meaning{};                        ///< a noun phrase that stands alone: "radius of the sphere"
    std::string_view also{};                           ///< a second, shorter name on the command line: "w"
    std::string_view keyword{};                        ///< in Python, where it is not the name: "W_int"
    std::string_view example{};                        ///< a value: "50 mJ/m2"
    std::string_view otherwise{};                      ///< what holds where it is not given: "four pixels"
    std::string_view word{};                           ///< of a word of the command line that may be it: "table"
    std::optional<Expected> quantity{};                ///< of a text with a unit
    std::string_view usual_unit{};                     ///< that a number without unit is told to have: "nm"
    std::optional<Domain> domain{};                    ///< of a number
    std::optional<WholeNumbers> whole{};               ///< of a whole number
    std::span<const std::string_view> choices{};       ///< words that it may be
    std::vector<std::string> (*offered)() = nullptr;   ///< words that shells offer; it may be others, too
    void (*check)(const std::string& text) = nullptr;  ///< throws InvalidArgument where a text is malformed
    bool named_each_time = false;                      ///< of several values, each of them after its name
    bool shows_default = false;                        ///< the value of a new request is shown as the default
    char separator = '\0';                             ///< of several values in one word: ',' in "12,17"
    bool is_input = false;                             ///< a file that is read
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

/// The options of a request type: specialised beside the type, with `static constexpr std::array options`.
template <class Request>
struct Asked;

namespace detail {

template <auto Member>
Place place_of(void* request) {
    using Request = typename MemberOf<decltype(Member)>::Object;
    return &(static_cast<Request*>(request)->*Member);
}

}  // namespace detail

/// A member that is asked for.
template <auto Member>
consteval Option option(std::string_view name, std::string_view meaning) {
    return {.name = name, .meaning = meaning, .place = detail::place_of<Member>};
}

/// The sentence of help: meaning, an example, and what holds without it.
[[nodiscard]] std::string help_of(const Option& option);

/// How a front end spells an option, with a value or an empty one; empty where it has no such option.
using Spelling = std::function<std::string(std::string_view name, std::string_view value)>;

/// A message in which `name` or `name = value` in back quotes stands for an option, spelled as a front end does:
/// --name "value" on the command line, name="value" in Python. Other words in back quotes stay as they are.
[[nodiscard]] std::string spelled(std::string_view message, const Spelling& spelling);

}  // namespace setae::fields
