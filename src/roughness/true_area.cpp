// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/true_area.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/special_functions.hpp"

namespace setae::roughness {
namespace {

const double half_sqrt_pi = 0.5 * std::sqrt(pi);

void require_slope(double rms_slope) {
    if (!(rms_slope >= 0.0)) throw InvalidArgument(fmt::format("rms slope is {}, expected a number >= 0", rms_slope));
}

}  // namespace

double area_excess_factor(double rms_slope) {
    require_slope(rms_slope);
    if (rms_slope == 0.0) return 1.0;
    return std::sqrt(pi) / rms_slope * scaled_complementary_error_function(1.0 / rms_slope);
}

double gaussian_area_ratio(double rms_slope) {
    require_slope(rms_slope);
    if (rms_slope == 0.0) return 1.0;
    return 1.0 + half_sqrt_pi * rms_slope * scaled_complementary_error_function(1.0 / rms_slope);
}

double small_slope_area_ratio(double rms_slope) {
    require_slope(rms_slope);
    return 1.0 + 0.5 * rms_slope * rms_slope;
}

TriangulatedArea triangulated_area(const topography::HeightMap& map, parallel::Threads threads) {
    struct Sums {
        double area = 0.0, slope2 = 0.0, triangles = 0.0;
    };
    const auto nx = map.heights.rows(), ny = map.heights.cols();
    const auto [dx, dy] = map.pixel_size();
    const auto rows = static_cast<std::size_t>(map.periodic ? nx : nx - 1);
    const auto columns = map.periodic ? ny : ny - 1;
    std::vector<Sums> partial(rows);
    parallel::for_each_index(rows, threads, [&](std::size_t i) {
        const double* lower = map.heights.data() + static_cast<Index>(i) * ny;
        const double* upper = map.heights.data() + ((static_cast<Index>(i) + 1) % nx) * ny;
        Sums sums;
        for (Index j = 0; j < columns; ++j) {
            const auto next = j + 1 == ny ? 0 : j + 1;
            const double a = lower[j], b = upper[j], c = lower[next], d = upper[next];
            // both triangulations of the cell: each pairs one slope along x with one along y
            const double x0 = (b - a) / dx, x1 = (d - c) / dx, y0 = (c - a) / dy, y1 = (d - b) / dy;
            const double s00 = x0 * x0 + y0 * y0, s11 = x1 * x1 + y1 * y1, s01 = x0 * x0 + y1 * y1,
                         s10 = x1 * x1 + y0 * y0;
            const double slope2 = s00 + s11 + s01 + s10;
            if (slope2 != slope2) continue;
            sums.area += std::sqrt(1.0 + s00) + std::sqrt(1.0 + s11) + std::sqrt(1.0 + s01) + std::sqrt(1.0 + s10);
            sums.slope2 += slope2;
            sums.triangles += 4.0;
        }
        partial[i] = sums;
    });
    Sums total;
    for (const auto& sums : partial) {
        total.area += sums.area;
        total.slope2 += sums.slope2;
        total.triangles += sums.triangles;
    }
    if (total.triangles == 0.0) throw UndefinedDataError("no cell of the map has four defined corners");
    return {total.area / total.triangles, std::sqrt(total.slope2 / total.triangles),
            static_cast<Index>(total.triangles / 4.0)};
}

}  // namespace setae::roughness
