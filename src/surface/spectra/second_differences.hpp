// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::spectra {

/// The p-quantile over x of [h(x − l/2) − 2h(x) + h(x + l/2)]/(l/2)² for a stencil of length l; NaN where none fits.
/// p = 0 is the minimum.
using CurvatureAtScale = std::function<double(double)>;

/// Equidistant heights and the direction to look along.
struct CurvatureGrid {
    ArrayView2D heights;  ///< must outlive what curvature_on_grid returns
    bool along_x;         ///< along the first index, else along the second
    double step;
    bool periodic;
};

/// At the grid points, linear between them. Undefined heights leave out their stencils.
[[nodiscard]] CurvatureAtScale curvature_on_grid(const CurvatureGrid& grid, double percentile,
                                                 parallel::Threads threads);

/// Of a polyline, which must outlive the result: where an end or the middle of the stencil meets a point, among which a
/// piecewise linear second difference has its extremes.
[[nodiscard]] CurvatureAtScale curvature_of_profile(const topography::Profile& profile, double percentile);

}  // namespace setae::spectra
