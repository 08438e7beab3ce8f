// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace setae::figures {

/// A stretch of an axis' quantity set in one way.
struct Span {
    enum class Place { line, lowered, raised };
    std::string text;  ///< letter by letter
    bool italic = false;
    Place place = Place::line;
};

/// The markup of Axis::quantity taken apart: between asterisks italic, _ and ^ lower and raise the word or {group}
/// after them; a backslash takes the next letter as it is.
[[nodiscard]] std::vector<Span> spans_of(std::string_view quantity);

/// A factor of a unit: m⁻² is {"m", "-2"}.
struct UnitFactor {
    std::string symbol;    ///< with µ for a leading u
    std::string exponent;  ///< empty: 1
};

/// The factors of a unit as setae spells it, "mJ/m2" or "N/m^1.5"; none for "1".
[[nodiscard]] std::vector<UnitFactor> factors_of(std::string_view unit);

}  // namespace setae::figures
