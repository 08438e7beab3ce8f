// SPDX-License-Identifier: GPL-3.0-or-later
// Simple, slow references: definitions as double loops.
#pragma once

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::scales::tests {

/// ½⟨(h(x + d) − h(x))²⟩ of a map over all pairs of defined points (k, l) pixels apart; NaN without a pair.
inline double pair_mean(const topography::HeightMap& map, Index k, Index l) {
    const auto [nx, ny] = map.shape();
    double sum = 0.0, pairs = 0.0;
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) {
            Index p = i + k, q = j + l;
            if (map.periodic) {
                p = ((p % nx) + nx) % nx;
                q = ((q % ny) + ny) % ny;
            } else if (p < 0 || p >= nx || q < 0 || q >= ny) {
                continue;
            }
            const double difference = map.heights(p, q) - map.heights(i, j);
            if (std::isnan(difference)) continue;
            sum += 0.5 * difference * difference;
            pairs += 1.0;
        }
    return pairs > 0.0 ? sum / pairs : undefined;
}

inline topography::HeightMap as_map(const topography::LineScan& scan) {
    return {
        Eigen::Map<const Array2D>(scan.heights.data(), scan.heights.size(), 1), {scan.size, 1.0}, scan.periodic, {}};
}

/// Height of a polyline at x, by searching for its segment.
inline double height_at(const topography::Profile& profile, double x) {
    Index k = 0;
    while (k + 2 < profile.positions.size() && profile.positions[k + 1] < x) ++k;
    const double share = (x - profile.positions[k]) / (profile.positions[k + 1] - profile.positions[k]);
    return profile.heights[k] + share * (profile.heights[k + 1] - profile.heights[k]);
}

/// Heights of a random walk with given steps.
inline Array1D walk(Array1D steps) {
    for (Index k = 1; k < steps.size(); ++k) steps[k] += steps[k - 1];
    return steps;
}

inline topography::HeightMap with_holes(topography::HeightMap map) {
    for (const auto& [i, j] : {std::pair<Index, Index>{0, 0}, {3, 4}, {3, 5}, {7, 1}, {8, 8}})
        map.heights(i, j) = undefined;
    return map;
}

}  // namespace setae::scales::tests
