// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/scales/function_of_scale.hpp"

namespace setae::scales {

/// Variable bandwidth analysis: rms of the residuals from the best plane (line) of each cell, for successively halved
/// cells.
///
///   h_ℓ = sqrt(Σ over all cells and points of residual²/points),  ℓ = size/cells
///
/// Cells: magnification m = 1, 2, 4, … while n/m >= 4 points (integer division); point i of n is in cell floor(i m/n).
/// Maps by area begin with round(size/shorter size) cells along each side, ℓ is the mean of both sides of a cell.
/// Polylines: cells of equal length and integrals over the straight segments, so collinear points change nothing.
/// Undefined points are left out. A cell with too few points for a plane, or with points on one line, contributes the
/// residuals from the best plane through them (0 for up to three points that span a plane); a cell without points
/// contributes nothing. `count` is the number of points (for polylines the length). Moments of the finest cells are
/// merged to larger cells: one pass over the heights for all magnifications. Each cell is centred separately, so
/// offsets cause no loss of digits.
/// Source: 10.1088/2051-672X/aa51f8 (definition).
struct VariableBandwidthOptions {
    Index min_points = 4;  ///< of a cell along each direction, >= 2
    spectra::ReliabilityOptions reliability;
    parallel::Threads threads;
};

/// @throws UndefinedDataError if no height is defined, InvalidArgument if even one cell has too few points.
[[nodiscard]] FunctionOfScale variable_bandwidth(const topography::LineScan& scan,
                                                 const VariableBandwidthOptions& options = {});
/// Variable bandwidth with planes in rectangles.
[[nodiscard]] FunctionOfScale variable_bandwidth_of_area(const topography::HeightMap& map,
                                                         const VariableBandwidthOptions& options = {});
/// @throws InvalidArgument for a re-entrant profile, UndefinedDataError for undefined heights.
[[nodiscard]] FunctionOfScale variable_bandwidth(const topography::Profile& profile,
                                                 const VariableBandwidthOptions& options = {});
/// Variable bandwidth of any measurement along x.
[[nodiscard]] FunctionOfScale variable_bandwidth_along_lines(const topography::Measurement& measurement,
                                                             const VariableBandwidthOptions& options = {});

}  // namespace setae::scales
