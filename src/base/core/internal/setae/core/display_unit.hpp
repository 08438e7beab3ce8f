// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace setae {

/// A unit for readers: a value in SI divided by `factor` is the number printed with `name`.
struct DisplayUnit {
    double factor = 1.0;
    std::string name;
};

/// The unit with the prefix that puts the magnitude of a value in [1, 1000), as format_value() chooses it; without
/// prefix for 0, NaN, and units that setae does not print with prefixes.
[[nodiscard]] DisplayUnit display_unit(double value, std::string_view si_unit);

/// A whole number in raised digits: "⁻¹²".
[[nodiscard]] std::string superscript(int number);

}  // namespace setae
