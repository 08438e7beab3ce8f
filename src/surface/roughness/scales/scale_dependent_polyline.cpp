// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "difference_result.hpp"
#include "difference_rows.hpp"
#include "polyline_pieces.hpp"
#include "setae/core/errors.hpp"

namespace setae::scales {

DifferenceStatistics difference_statistics(const topography::Profile& profile, const DifferenceOptions& options) {
    require_differences(options, profile.metadata);
    require_polyline(profile);
    const auto label = topography::label(profile.metadata);
    if (options.along == Along::y) throw InvalidArgument(label + ": differences along y of a line; choose x");
    if (options.interpolation == Interpolation::fourier)
        throw InvalidArgument(label + ": Fourier interpolation of a polyline; choose linear interpolation");
    const double length = profile.size(), step = length / static_cast<double>(profile.positions.size() - 1);
    const Array1D distances = options.distances
                                  ? *options.distances
                                  : distances_on_grid(options.grid.bins_per_decade, options.order * step, length);
    std::vector<DifferenceMoments> moments;
    for (const double distance : distances) {
        const double spacing = distance / options.order, scale = 1.0 / std::pow(spacing, options.order);
        std::vector<Shift> shifts;
        for (const auto& point : stencil(options.order))
            shifts.push_back({point.place * spacing, point.coefficient * scale});
        const auto pieces = difference_moments(profile, shifts);
        if (!(pieces.length > 0.0) || pieces.length < static_cast<double>(options.fewest) * step * (1.0 - 1e-9))
            continue;
        moments.push_back({distance,
                           pieces.length,
                           pieces.origin,
                           {pieces.moments[0], pieces.moments[1], pieces.moments[2], pieces.moments[3]},
                           pieces.minimum,
                           pieces.maximum});
    }
    auto result = statistics_of(moments, options, profile.metadata);
    result.count_unit = "m";
    result.reliable_from =
        0.5 * options.order * shortest_reliable_wavelength(profile, options.reliability, options.threads);
    return result;
}

}  // namespace setae::scales
