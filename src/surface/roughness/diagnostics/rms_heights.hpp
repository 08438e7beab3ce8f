// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "setae/core/arrays.hpp"

namespace setae::diagnostics {

/// Rms deviations of the defined heights from their mean [m], of several maps with the same defined points, computed
/// together so the sums do not wait for each other: this takes as long as one map. rows_of(i): their rows i, each read
/// before the next call; called twice for each row, in order. Sums are in the order of the points.
template <std::size_t count, class RowsOf>
std::array<double, count> rms_heights(Index rows, Index columns, const RowsOf& rows_of) {
    std::array<double, count> sum{}, mean, squares{}, rms;
    Index n = 0;
    for (Index i = 0; i < rows; ++i) {
        const std::array<const double*, count> row = rows_of(i);
        for (Index j = 0; j < columns; ++j) {
            n += !std::isnan(row[0][j]);
            for (std::size_t m = 0; m < count; ++m) sum[m] += std::isnan(row[m][j]) ? 0.0 : row[m][j];
        }
    }
    for (std::size_t m = 0; m < count; ++m) mean[m] = sum[m] / static_cast<double>(n);
    for (Index i = 0; i < rows; ++i) {
        const std::array<const double*, count> row = rows_of(i);
        for (Index j = 0; j < columns; ++j)
            for (std::size_t m = 0; m < count; ++m) {
                const double height = row[m][j], rest = height - mean[m];
                squares[m] += std::isnan(height) ? 0.0 : rest * rest;
            }
    }
    for (std::size_t m = 0; m < count; ++m) rms[m] = std::sqrt(squares[m] / static_cast<double>(n));
    return rms;
}

}  // namespace setae::diagnostics
