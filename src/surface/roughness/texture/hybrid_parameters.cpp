// SPDX-License-Identifier: GPL-3.0-or-later
#include "hybrid_parameters.hpp"

#include <cmath>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/roughness/real_space.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::texture {
namespace {

struct Sums {
    double slope2 = 0.0, excess = 0.0, points = 0.0;
};

/// Central differences of one row of points; previous and next are the adjacent rows.
Sums central_sums(const double* previous, const double* row, const double* next, Index ny, bool periodic, double dx,
                  double dy) {
    Sums sums;
    for (Index j = periodic ? 0 : 1; j < (periodic ? ny : ny - 1); ++j) {
        const double x = (next[j] - previous[j]) / (2.0 * dx),
                     y = (row[j + 1 == ny ? 0 : j + 1] - row[j == 0 ? ny - 1 : j - 1]) / (2.0 * dy);
        const double slope2 = x * x + y * y;
        if (std::isnan(slope2) || std::isnan(row[j])) continue;
        sums.slope2 += slope2;
        sums.excess += slope2 / (1.0 + std::sqrt(1.0 + slope2));
        sums.points += 1.0;
    }
    return sums;
}

}  // namespace

HybridParameters hybrid_parameters(const topography::HeightMap& map, parallel::Threads threads) {
    const auto real_space = roughness::real_space_parameters(map, threads);
    const auto area = roughness::triangulated_area(map, threads);
    const auto nx = map.heights.rows(), ny = map.heights.cols();
    const auto [dx, dy] = map.pixel_size();
    std::vector<Sums> rows(static_cast<std::size_t>(nx));
    parallel::for_each_index(rows.size(), threads, [&](std::size_t row) {
        const auto i = static_cast<Index>(row);
        if (!map.periodic && (i == 0 || i + 1 == nx)) return;
        const auto at = [&](Index k) { return map.heights.data() + (k + nx) % nx * ny; };
        rows[row] = central_sums(at(i - 1), at(i), at(i + 1), ny, map.periodic, dx, dy);
    });
    Sums total;
    for (const auto& sums : rows) {
        total.slope2 += sums.slope2;
        total.excess += sums.excess;
        total.points += sums.points;
    }
    const bool any = total.points > 0.0;
    return {real_space.rms_slope, area.area_ratio - 1.0, any ? std::sqrt(total.slope2 / total.points) : undefined,
            any ? total.excess / total.points : undefined, real_space.defined};
}

}  // namespace setae::texture
