// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace setae::figures {

/// A part of an axis' quantity in one style.
struct Span {
    enum class Place { line, lowered, raised };
    std::string text;  ///< letter by letter
    bool italic = false;
    Place place = Place::line;
};

/// The parsed markup of Axis::quantity: between asterisks italic, _ and ^ lower and raise the word or {group} after
/// them; a backslash escapes the next letter.
[[nodiscard]] std::vector<Span> spans_of(std::string_view quantity);

/// A quantity without markup, as files of numbers name it: "rms slope h'_rms" of "rms slope *h*'_{rms}".
[[nodiscard]] std::string plain_text(std::string_view quantity);

/// A quantity without the words before its symbol: "*W*_app" of "work of adhesion *W*_app"; itself where it has no
/// symbol.
[[nodiscard]] std::string_view symbol_of(std::string_view quantity);

/// A number to so many digits as figures show it: "0.5", "-2", "3·10⁶".
[[nodiscard]] std::string number_text(double value, int digits = 6);

/// A factor of a unit: m⁻² is {"m", "-2"}.
struct UnitFactor {
    std::string symbol;    ///< with µ for a leading u
    std::string exponent;  ///< empty: 1
};

/// The factors of a unit as setae spells it, "mJ/m2" or "N/m^1.5"; none for "1".
[[nodiscard]] std::vector<UnitFactor> factors_of(std::string_view unit);

}  // namespace setae::figures
