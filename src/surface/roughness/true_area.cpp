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
    if (!(rms_slope >= 0.0)) throw InvalidArgument(fmt::format("rms slope is {}; expected a number >= 0", rms_slope));
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
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    const auto [dx, dy] = map.pixel_size();
    const auto rows = static_cast<std::size_t>(map.periodic ? nx : nx - 1);
    const Index columns = map.periodic ? ny : ny - 1;
    std::vector<Sums> partial(rows);
    parallel::for_each_index(rows, threads, [&, dx = dx, dy = dy](std::size_t i) {
        using Row = Eigen::Map<const Array1D>;
        const Row lower(map.heights.data() + static_cast<Index>(i) * ny, ny),
            upper(map.heights.data() + ((static_cast<Index>(i) + 1) % nx) * ny, ny);
        // squares of the slopes along x, and along y on either side of the cells
        thread_local Array1D x2, lower2, upper2, area, slope2;
        const auto along_y = [&, dy](const Row& row, Array1D& squares) {
            squares.resize(ny);
            squares.head(ny - 1) = ((row.tail(ny - 1) - row.head(ny - 1)) / dy).square();
            const double round = (row[0] - row[ny - 1]) / dy;
            squares[ny - 1] = round * round;
        };
        x2.resize(ny + 1);
        x2.head(ny) = ((upper - lower) / dx).square();
        x2[ny] = x2[0];
        along_y(lower, lower2);
        along_y(upper, upper2);
        // both triangulations of the cell: each pairs one slope along x with one along y
        const auto x0 = x2.head(columns), x1 = x2.segment(1, columns), y0 = lower2.head(columns),
                   y1 = upper2.head(columns);
        area =
            (1.0 + (x0 + y0)).sqrt() + (1.0 + (x1 + y1)).sqrt() + (1.0 + (x0 + y1)).sqrt() + (1.0 + (x1 + y0)).sqrt();
        slope2 = (x0 + y0) + (x1 + y1) + (x0 + y1) + (x1 + y0);
        Sums sums;
        for (Index j = 0; j < columns; ++j) {
            const bool defined = !std::isnan(slope2[j]);
            sums.area += defined ? area[j] : 0.0;
            sums.slope2 += defined ? slope2[j] : 0.0;
            sums.triangles += defined ? 4.0 : 0.0;
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
