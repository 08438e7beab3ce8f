// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/tables/text_numbers.hpp"

namespace setae::formats {

/// Evenly spaced positions, or numbers of rows, that stand above or before the heights of a table.
struct AxisLabels {
    double first = 0.0, step = 0.0;  ///< as the file has them; step < 0 where they decrease
    Index count = 0;
    bool counts = false;  ///< 0, 1, 2 … or 1, 2, 3 …: numbers of rows or columns, no positions

    [[nodiscard]] double last() const { return first + step * static_cast<double>(count - 1); }
};

/// What of a matrix's numbers are labels.
struct Labels {
    std::optional<AxisLabels> x, y;
    Index rows_above = 0;       ///< lines of numbers that are labels of x: 0 where they stand in the header, or 1
    bool first_column = false;  ///< is labels of y, or of nothing that is evenly spaced
    std::string unit;           ///< of the positions; empty: not stated

    [[nodiscard]] bool any() const { return x || first_column; }
    /// "the first row holds positions 0 to 87.07 and the first column numbers of rows".
    [[nodiscard]] std::string described() const;
};

/// Labels among the lines of a matrix and in the last line of its header. is_map: the user says that it is a map.
///
/// A first row is labels where its first cell is empty or text (then it may stand in the header) or one cell is missing
/// at its beginning, and the others are evenly spaced; or where eight or more numbers of it are evenly spaced and those
/// of other rows are not. A first column likewise, where the first row is labels, or where it counts rows from 0 or 1.
/// @throws FormatError that asks where the first column alone is evenly spaced: x of several profiles, or y of a map.
[[nodiscard]] Labels find_labels(const tables::NumberLines& lines, const std::vector<std::string>& header, bool is_map);

/// The heights of a matrix without its labels, x to the right and y downwards in increasing order.
/// numbers: all of it, (columns, rows). @throws FormatError for a first column that does not go on as it began.
[[nodiscard]] Array2D without_labels(const Array2D& numbers, const Labels& labels, const tables::NumberLines& lines);

}  // namespace setae::formats
