// SPDX-License-Identifier: GPL-3.0-or-later
#include "value_text.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"

namespace setae::processing {
namespace {

constexpr double degree = pi / 180.0;

}  // namespace

std::string length_text(double length) {
    constexpr std::array<std::string_view, 5> units{"m", "mm", "um", "nm", "pm"};
    std::string shortest = fmt::format("{} m", length);
    for (const auto unit : units) {
        const double factor = unit_factor(unit, dimension::length);
        // the quotient may differ from the number by a rounding that a shorter one hides
        for (const double value : {length / factor, std::stod(fmt::format("{:.15g}", length / factor))}) {
            const auto text = fmt::format("{} {}", value, unit);
            const bool plain = text.find('e') == std::string::npos;
            const bool shorter = text.size() < shortest.size() || shortest.find('e') != std::string::npos;
            if (plain && shorter && parse_quantity(text, dimension::length) == length) shortest = text;
        }
    }
    return shortest;
}

std::string angle_text(double angle) {
    const auto text = fmt::format("{:.15g} deg", angle / degree);
    return parsed_angle(text) == angle ? text : fmt::format("{} rad", angle);
}

double parsed_angle(std::string_view text) {
    const auto whole = trimmed(text);
    for (const auto& [unit, factor] : std::array<std::pair<std::string_view, double>, 4>{
             {{"degrees", degree}, {"deg", degree}, {"°", degree}, {"rad", 1.0}}})
        if (whole.ends_with(unit)) return parsed_number(whole.substr(0, whole.size() - unit.size())) * factor;
    if (const double number = parsed_number(whole); number == 0.0) return 0.0;
    throw InvalidArgument(fmt::format("'{}' is an angle without unit; append deg or rad", whole));
}

std::string number_text(double number) { return fmt::format("{}", number); }

bool parsed_flag(std::string_view text) {
    const auto whole = trimmed(text);
    if (whole != "true" && whole != "false") refuse_choice(whole, "true, false");
    return whole == "true";
}

void refuse_choice(std::string_view text, std::string_view values) {
    throw InvalidArgument(fmt::format("'{}' is unknown; expected one of {}", text, values));
}

double parsed_number(std::string_view text) {
    const auto whole = trimmed(text);
    const auto value = spelled<double>(whole);
    if (!value || !std::isfinite(*value)) throw InvalidArgument(fmt::format("'{}' is not a number", whole));
    return *value;
}

long long parsed_count(std::string_view text) {
    const auto whole = trimmed(text);
    const auto value = spelled<long long>(whole);
    if (!value) throw InvalidArgument(fmt::format("'{}' is not a whole number", whole));
    return *value;
}

}  // namespace setae::processing
