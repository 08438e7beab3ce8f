// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/laboratory/silhouette.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::laboratory {

topography::LineScan silhouette(const topography::HeightMap& surface, double thickness, double start_y) {
    const auto nx = surface.heights.rows(), ny = surface.heights.cols();
    const double step = surface.pixel_size()[1];
    if (!(thickness >= 0.0) || !std::isfinite(thickness) || !std::isfinite(start_y))
        throw InvalidArgument(fmt::format("foil of thickness {} m from y = {} m; expected finite, thickness >= 0", thickness, start_y));
    // a grid point on the interval's end counts in spite of rounding
    const auto first = static_cast<Index>(std::llround(start_y / step));
    auto lines = static_cast<Index>(std::floor(thickness / step * (1.0 + 1e-12))) + 1;
    if (!surface.periodic && (first < 0 || first + lines > ny))
        throw InvalidArgument(fmt::format("foil from y = {} m to {} m, the surface ends at {} m; expected a foil inside it, or a periodic "
                                          "surface", start_y, start_y + thickness, static_cast<double>(ny - 1) * step));
    lines = std::min(lines, ny);
    topography::LineScan result{Array1D(nx), surface.size[0], surface.periodic, surface.metadata};
    for (Index i = 0; i < nx; ++i) {
        double highest = undefined;
        for (Index k = 0; k < lines; ++k) {
            const double height = surface.heights(i, ((first + k) % ny + ny) % ny);
            if (height == height && !(highest >= height)) highest = height;
        }
        result.heights[i] = highest;
    }
    return result;
}

}  // namespace setae::laboratory
