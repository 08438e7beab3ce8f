// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_meaning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "setae/core/number_text.hpp"

namespace setae::imaging {
namespace {

struct LengthUnit {
    std::string_view spelling, name, printed;
    int exponent;  // of ten
};

constexpr std::array<LengthUnit, 10> units{{{"pm", "pm", "pm", -12},
                                            {"A", "A", "Å", -10},
                                            {"\u00c5", "A", "Å", -10},
                                            {"\u212b", "A", "Å", -10},
                                            {"nm", "nm", "nm", -9},
                                            {"um", "um", "µm", -6},
                                            {"\u00b5m", "um", "µm", -6},
                                            {"\u03bcm", "um", "µm", -6},
                                            {"\u00b5", "um", "µm", -6},
                                            {"mm", "mm", "mm", -3}}};

/// 1, 2, 2.5 or 5 times a power of ten.
bool usual(double number) {
    const double mantissa = number / std::pow(10.0, std::floor(std::log10(number) + 1e-9));
    constexpr std::array<double, 4> mantissas{1.0, 2.0, 2.5, 5.0};
    return std::any_of(mantissas.begin(), mantissas.end(),
                       [&](double value) { return std::abs(mantissa - value) < 1e-6; });
}

}  // namespace

LabelMeaning meaning_of_label(std::string_view reading) {
    std::string text(reading);
    std::erase(text, ' ');
    std::replace(text.begin(), text.end(), ',', '.');
    LabelMeaning meaning;
    meaning.text = text;
    const auto digits = text.find_first_not_of("0123456789.");
    const auto number_text = text.substr(0, digits);
    const auto unit_text = digits == std::string::npos ? std::string() : text.substr(digits);
    if (unit_text.find('/') != std::string::npos || unit_text.ends_with("-1") || unit_text.ends_with("\u207b\u00b9")) {
        meaning.fault =
            fmt::format("label '{}' is a reciprocal length: the picture is a diffraction pattern, not an image", text);
        return meaning;
    }
    const auto* unit =
        std::find_if(units.begin(), units.end(), [&](const LengthUnit& known) { return known.spelling == unit_text; });
    const auto number = spelled<double>(number_text).value_or(0);
    const bool is_number = number > 0 && number_text.front() != '.';
    const bool leading_zero = number_text.size() > 1 && number_text[0] == '0' && number_text[1] != '.';
    if (!is_number || unit == units.end()) {
        meaning.fault = fmt::format("label read as '{}', which is not a number with a unit of length", text);
        return meaning;
    }
    meaning.text = fmt::format("{} {}", number_text, unit->printed);
    meaning.unit = unit->name;
    if (leading_zero || !usual(number)) {
        meaning.fault =
            fmt::format("label read as '{}', which is rare for a scale bar; it may be misread", meaning.text);
        return meaning;
    }
    meaning.length = number / std::pow(10.0, -unit->exponent);  // an exact power of ten
    return meaning;
}

}  // namespace setae::imaging
