// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/tables/text_numbers.hpp"

namespace setae::formats {

/// Evenly spaced positions, or numbers of rows, above or before the heights of a table.
struct AxisLabels {
    double first = 0.0, step = 0.0;  ///< as in the file; step < 0 if they decrease
    Index count = 0;
    bool counts = false;  ///< 0, 1, 2 … or 1, 2, 3 …: numbers of rows or columns, no positions

    [[nodiscard]] double last() const { return first + step * static_cast<double>(count - 1); }
};

/// Labels among the numbers of a matrix.
struct Labels {
    std::optional<AxisLabels> x, y;
    Index rows_above = 0;       ///< lines of numbers that are labels of x: 0 if they are in the header, or 1
    bool first_column = false;  ///< it contains labels of y, or numbers without even spacing
    std::string unit;           ///< of the positions; empty: not stated

    [[nodiscard]] bool any() const { return x || first_column; }
    /// "the first row holds positions 0 to 87.07 and the first column numbers of rows".
    [[nodiscard]] std::string described() const;
};

/// Labels among the lines of a matrix and in the last line of its header. is_map: the user declares a map.
///
/// A first row contains labels if its first cell is empty or text (it may then be in the header) or one cell is missing
/// at its beginning, and the others are evenly spaced; or if eight or more of its numbers are evenly spaced and those
/// of other rows are not. A first column contains labels under the same conditions, if the first row does, or if it
/// counts rows from 0 or 1.
/// @throws FormatError with a question if only the first column is evenly spaced: x of several profiles, or y of a map.
[[nodiscard]] Labels find_labels(const tables::NumberLines& lines, const std::vector<std::string>& header, bool is_map);

/// The heights of a matrix without its labels, x to the right and y downwards in increasing order.
/// numbers: all of it, (columns, rows). @throws FormatError for a first column that does not continue as it begins.
[[nodiscard]] Array2D without_labels(const Array2D& numbers, const Labels& labels, const tables::NumberLines& lines);

}  // namespace setae::formats
