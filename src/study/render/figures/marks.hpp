// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ranges.hpp"

namespace setae::figures {

/// A colour of the palette for gnuplot, in quotes. opacity: 0 … 1.
[[nodiscard]] std::string colour_name(int index, double opacity = 1.0);

/// The points of a series, one per line: x y lower upper left right. An empty line where the curve is interrupted.
[[nodiscard]] std::string data_lines(const Panel& panel, const Series& series, const Range& x, const Range& y);

/// Sizes of symbols with equal appearance in a terminal.
struct SymbolSize {
    double symbols = 1.0;
    double diamonds = 1.0;  ///< times that of the others
};

/// Elements of a plot command that draw a series.
///
/// place: position of the series in its panel.  data: name of its points.
[[nodiscard]] std::vector<std::string> elements(const Series& series, std::size_t place, const std::string& data,
                                                const SymbolSize& symbol_size);

/// The cells of a map, one per line: x y value, those of one x together.
[[nodiscard]] std::string map_lines(const HeatMap& map);

}  // namespace setae::figures
