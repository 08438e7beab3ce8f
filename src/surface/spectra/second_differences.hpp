// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::spectra {

/// The p-quantile over x of [h(x − l/2) − 2h(x) + h(x + l/2)]/(l/2)² for a stencil of length l; NaN if none fits. p = 0
/// is the minimum.
using CurvatureAtScale = std::function<double(double)>;

/// Equidistant heights and the direction of differences.
struct CurvatureGrid {
    ArrayView2D heights;  ///< must outlive the result of curvature_on_grid
    bool along_x;         ///< along the first index, otherwise along the second
    double step;
    bool periodic;
};

/// At the grid points, linear between them. Stencils with undefined heights are left out.
[[nodiscard]] CurvatureAtScale curvature_on_grid(const CurvatureGrid& grid, double percentile,
                                                 parallel::Threads threads);

/// Curvature of a polyline, which must outlive the result, at positions where an end or the middle of the stencil is at
/// a point: these include the extremes of a piecewise linear second difference.
[[nodiscard]] CurvatureAtScale curvature_of_profile(const topography::Profile& profile, double percentile);

}  // namespace setae::spectra
