// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/autocorrelation.hpp"

#include <array>

#include <fmt/format.h>

#include "autocorrelation_result.hpp"
#include "polyline_pieces.hpp"
#include "setae/core/errors.hpp"

namespace setae::scales {

FunctionOfScale autocorrelation(const topography::Profile& profile, const std::optional<Array1D>& distances,
                                const AutocorrelationOptions& options) {
    require_polyline(profile);
    const double length = profile.size(), step = length / static_cast<double>(profile.positions.size() - 1);
    const Array1D wanted = distances ? *distances : distances_on_grid(10, step, length);
    auto result = empty_autocorrelation(wanted.size(), profile.metadata);
    result.distance = wanted;
    result.count_unit = "m";
    for (Index k = 0; k < wanted.size(); ++k) {
        if (!(wanted[k] > 0.0 && wanted[k] < length))
            throw InvalidArgument(fmt::format(
                "{}: distance {} m of an autocorrelation; expected more than 0 and less than the length {} m",
                topography::label(profile.metadata), wanted[k], length));
        const std::array shifts{Shift{0.0, -1.0}, Shift{wanted[k], 1.0}};
        const auto difference = difference_moments(profile, shifts);
        const double mean = difference.moments[0] / difference.length;
        const double square =
            difference.moments[1] / difference.length + difference.origin * (2.0 * mean + difference.origin);
        result.value[k] = 0.5 * square;
        result.count[k] = difference.length;
    }
    result.reliable_from = 0.5 * shortest_reliable_wavelength(profile, options.reliability, options.threads);
    return result;
}

}  // namespace setae::scales
