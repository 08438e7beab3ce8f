// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tiled_map.hpp"

namespace setae::roughness {

/// Root-mean-square parameters from heights, at the resolution of the pixels.
///
/// Lines: forward differences; maps: forward differences along x and y, five-point Laplacian; polylines: exact
/// integrals over the segments, curvature from the three-point formula for unequal steps weighted by the trapezoid
/// rule. Differences wrap in periodic data. Differences with undefined heights are left out; a parameter without a
/// defined difference is NaN. Only the mean of the heights is removed: remove trends first (topography/detrend.hpp).
struct RealSpaceParameters {
    double rms_height = 0.0;           ///< Rq or Sq, unfiltered [m]: sqrt⟨(h − ⟨h⟩)²⟩ over all points
    double rms_height_of_lines = 0.0;  ///< maps: root of the mean over lines along x of each line's variance [m]
    double rms_slope_x = 0.0;          ///< sqrt⟨(∂h/∂x)²⟩ [1]
    double rms_slope_y = 0.0;          ///< maps only, NaN otherwise [1]
    double rms_slope = 0.0;            ///< maps: sqrt⟨|∇h|²⟩; lines and polylines: equal to rms_slope_x [1]
    double rms_curvature = 0.0;        ///< maps: sqrt⟨(½∇²h)²⟩; lines and polylines: sqrt⟨(h'')²⟩ [1/m]
    double mean_height = 0.0;          ///< [m]
    Index defined = 0;                 ///< number of heights used
};

/// One pass over the heights.
/// @throws UndefinedDataError if no height is defined.
[[nodiscard]] RealSpaceParameters real_space_parameters(const topography::HeightMap& map,
                                                        parallel::Threads threads = {});
/// Parameters of a map larger than memory, in bands of scan lines: equal up to rounding. lines_together: lines per
/// band, > 0. Periodic maps are read as a whole.
[[nodiscard]] RealSpaceParameters real_space_parameters(const topography::TiledMap& map, Index lines_together,
                                                        parallel::Threads threads = {});
[[nodiscard]] RealSpaceParameters real_space_parameters(const topography::LineScan& scan);
[[nodiscard]] RealSpaceParameters real_space_parameters(const topography::Profile& profile);
[[nodiscard]] RealSpaceParameters real_space_parameters(const topography::Measurement& measurement,
                                                        parallel::Threads threads = {});

/// Arithmetic mean deviation Ra or Sa [m]: ⟨|h − ⟨h⟩|⟩ over defined points; NaN for a polyline. A second pass.
[[nodiscard]] double arithmetic_height(const topography::Measurement& measurement, double mean_height,
                                       parallel::Threads threads = {});

}  // namespace setae::roughness
