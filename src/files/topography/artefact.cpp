// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/artefact.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::topography {

LineScan average_reference(std::span<const LineScan> references) {
    if (references.empty()) throw InvalidArgument("no reference scan is given; averaging needs at least one");
    LineScan average = references.front();
    const double step = average.pixel_size();
    Array1D sum = Array1D::Zero(average.heights.size());
    Array1D count = sum;
    for (const auto& reference : references) {
        const bool same_grid =
            reference.heights.size() == sum.size() && std::abs(reference.size - average.size) < 0.1 * step;
        if (!same_grid)
            throw InvalidArgument(fmt::format(
                "reference scan {} has {} points over {} m, expected {} over {} m as in {}", reference.metadata.file,
                reference.heights.size(), reference.size, sum.size(), average.size, average.metadata.file));
        const auto level = detrended(reference, Trend::tilt).heights;
        const auto defined = !level.isNaN();
        sum += defined.select(level, 0.0);
        count += defined.cast<double>();
    }
    average.heights = sum / count;  // 0/0 makes points without a defined scan undefined
    return average;
}

LineScan subtract_artefact(const LineScan& scan, const LineScan& artefact) {
    const double step = scan.pixel_size(), artefact_step = artefact.pixel_size();
    LineScan result = scan;
    Index kept = 0;
    for (; kept < scan.heights.size(); ++kept) {
        const double at = static_cast<double>(kept) * step / artefact_step;
        const auto left = static_cast<Index>(at);
        const double fraction = at - static_cast<double>(left);
        const bool on_last_point = left + 1 == artefact.heights.size() && fraction < 1e-9;
        if (left + 1 >= artefact.heights.size() && !on_last_point) break;
        const double value = on_last_point || fraction == 0.0
                                 ? artefact.heights[left]
                                 : (1.0 - fraction) * artefact.heights[left] + fraction * artefact.heights[left + 1];
        result.heights[kept] -= value;
    }
    if (kept < 2)
        throw UndefinedDataError(
            fmt::format("the artefact covers {} points of {}, expected at least 2", kept, scan.metadata.file));
    result.heights.conservativeResize(kept);
    result.size = static_cast<double>(kept) * step;
    return result;
}

}  // namespace setae::topography
