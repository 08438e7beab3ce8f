// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "two_phases.hpp"

namespace setae::imaging {

/// One number per square of pixels.
using CellMap = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The division with minimum energy
///
///   Σ over squares labelled sample of difference + border_cost · length of the border [squares]
///
/// difference: cost of sample minus cost of vacuum. The length of the border is the sum over the sides and diagonals it
/// cuts, π/4 and π/(8√2) each (Boykov, Kolmogorov, ICCV 2003). Squares with free = 0 keep their label.
[[nodiscard]] PixelMask minimum_cut(const CellMap& difference, double border_cost, const PixelMask& free,
                                    const PixelMask& labels);

/// Means and ln of variances over squares of pixels.
struct Cells {
    CellMap mean, log_variance;
    CellMap weight;  ///< 0 if most of a square is hidden
};

/// Values for the squares of `side` pixels from (first_row, first_column) on, counted in squares.
[[nodiscard]] Cells cells_of(const FramePixels& pixels, const PixelMask& hidden, long side, long first_row,
                             long first_column, long rows, long columns);

/// Repeats the cut within `width` squares of the border: each square of `side` pixels against Gaussians with mean and
/// deviation of either phase within 12 squares around it. Works in tiles: squares far from the border only need memory
/// for their label.
[[nodiscard]] PixelMask cut_in_band(const FramePixels& pixels, const PixelMask& hidden, long side,
                                    const PixelMask& labels, long width, double border_cost);

/// 1 if no other label is within `distance` squares along rows and columns.
[[nodiscard]] PixelMask away_from_border(const PixelMask& labels, long distance);

}  // namespace setae::imaging
