// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/silhouette.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::simulation {

topography::LineScan silhouette(const topography::HeightMap& surface, double thickness, double start_y) {
    const auto nx = surface.heights.rows(), ny = surface.heights.cols();
    const double step = surface.pixel_size()[1];
    if (!(thickness >= 0.0) || !std::isfinite(thickness) || !std::isfinite(start_y))
        throw InvalidArgument(
            fmt::format("foil of thickness {} m from y = {} m; expected finite, thickness >= 0", thickness, start_y));
    // a grid point on the interval's end counts in spite of rounding
    const auto first = static_cast<Index>(std::llround(start_y / step));
    auto lines = static_cast<Index>(std::floor(thickness / step * (1.0 + 1e-12))) + 1;
    if (!surface.periodic && (first < 0 || first + lines > ny))
        throw InvalidArgument(fmt::format(
            "foil from y = {} m to {} m, the surface ends at {} m; expected a foil inside it, or a periodic "
            "surface",
            start_y, start_y + thickness, static_cast<double>(ny - 1) * step));
    lines = std::min(lines, ny);
    topography::LineScan result{Array1D(nx), surface.size[0], surface.periodic, surface.metadata};
    // the foil may cross a periodic map's end: two runs of contiguous heights
    const Index begin = (first % ny + ny) % ny, before_end = std::min(lines, ny - begin);
    for (Index i = 0; i < nx; ++i) {
        double highest = -std::numeric_limits<double>::infinity();
        const auto run = [&](const double* heights, Index count) {
            for (Index k = 0; k < count; ++k) highest = heights[k] > highest ? heights[k] : highest;
        };
        const double* row = surface.heights.data() + i * ny;
        run(row + begin, before_end);
        run(row, lines - before_end);
        result.heights[i] = std::isinf(highest) ? undefined : highest;
    }
    return result;
}

}  // namespace setae::simulation
