// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "setae/topography/measurement.hpp"

namespace setae::tests {

/// A polyline sampled as SurfaceTopography does before it takes differences: equal steps, a whole number of which make
/// the stencil's step, none longer than the polyline's mean step.
inline topography::LineScan sampled_for_differences(const topography::Profile& profile, int order, double distance) {
    const Index points = profile.positions.size();
    const double mean_step = profile.size() / static_cast<double>(points - 1);
    const double pixel = distance / std::ceil(distance / mean_step) / order;
    const auto n = static_cast<Index>(profile.size() / pixel) + 1;
    topography::LineScan scan{Array1D(n), pixel * static_cast<double>(n), false, profile.metadata};
    Index k = 0;
    for (Index i = 0; i < n; ++i) {
        const double x = profile.positions[0] + pixel * static_cast<double>(i);
        while (k + 2 < points && profile.positions[k + 1] < x) ++k;
        const double share = (x - profile.positions[k]) / (profile.positions[k + 1] - profile.positions[k]);
        scan.heights[i] = profile.heights[k] + share * (profile.heights[k + 1] - profile.heights[k]);
    }
    return scan;
}

}  // namespace setae::tests
