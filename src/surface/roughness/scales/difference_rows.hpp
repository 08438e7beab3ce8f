// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/scales/scale_dependent.hpp"

namespace setae::scales {

/// Heights by rows, contiguous along columns: a map (rows along x), or a line as a single row.
struct Field {
    const double* heights = nullptr;
    Index rows = 0, columns = 0;
    double step = 0.0;  ///< between points along the difference [m]
    bool periodic = false;
};

/// Direction of differences in a field.
enum class Running { along_columns, across_rows };

/// Differences at one distance, row by row.
struct DifferenceRows {
    Index first_row = 0, end_row = 0;                     ///< rows with values
    Index first_column = 0, end_column = 0;               ///< of their values
    std::function<void(Index row, double* values)> fill;  ///< any thread; NaN if a height in use is undefined

    [[nodiscard]] bool empty() const { return first_row >= end_row || first_column >= end_column; }
};

/// The field must outlive the result.
[[nodiscard]] DifferenceRows linear_differences(const Field& field, Running running, int order, double distance);
/// Along columns of a periodic, fully defined field.
[[nodiscard]] DifferenceRows fourier_differences(const Field& field, int order, double distance);

/// A place of a stencil in units of its step s, and its coefficient.
struct StencilPoint {
    int place = 0;
    double coefficient = 0.0;
};
/// The point at place 0 first.
[[nodiscard]] std::vector<StencilPoint> stencil(int order);

}  // namespace setae::scales
