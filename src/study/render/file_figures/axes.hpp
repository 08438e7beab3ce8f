// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/core/arrays.hpp"
#include "setae/core/display_unit.hpp"
#include "setae/figures/figure.hpp"

namespace setae::file_figures {

inline constexpr int black = 4;  ///< index in the palette of figures
inline constexpr double normal_95 = 1.959963984540054;
inline constexpr double column_mm = 85.0, page_mm = 178.0;

/// The unit with the prefix that suits the largest of some values, as axes spell it: "um", "nm2", "1/um".
[[nodiscard]] DisplayUnit axis_unit(const Array1D& values, std::string_view si_unit);

/// A quantity's name without underscores, as an axis takes it.
[[nodiscard]] std::string in_words(std::string quantity);

/// "map.ibw": a path without its folders.
[[nodiscard]] std::string file_name(const std::string& path);
/// "map": that without its ending.
[[nodiscard]] std::string stem(const std::string& path);

}  // namespace setae::file_figures
