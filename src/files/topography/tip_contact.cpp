// SPDX-License-Identifier: GPL-3.0-or-later
#include "tip_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::topography {
namespace {

struct Extremes {
    double lowest = std::numeric_limits<double>::infinity(), highest = -std::numeric_limits<double>::infinity();

    void add(double low, double high) {
        lowest = low < lowest ? low : lowest;
        highest = high > highest ? high : highest;
    }
};

/// Extremes of `points` heights in a row; the comparisons skip NaN, the lanes allow vectorisation.
Extremes extremes(const double* heights, Index points) {
    constexpr Index width = 8;
    std::array<Extremes, width> lanes;
    Index k = 0;
    for (; k + width <= points; k += width)
        for (Index lane = 0; lane < width; ++lane)
            lanes[static_cast<std::size_t>(lane)].add(heights[k + lane], heights[k + lane]);
    Extremes all;
    for (; k < points; ++k) all.add(heights[k], heights[k]);
    for (const auto& lane : lanes) all.add(lane.lowest, lane.highest);
    return all;
}

Extremes extremes(const Array2D& heights, parallel::Threads threads) {
    constexpr Index block = 1 << 16;
    std::vector<Extremes> parts(static_cast<std::size_t>((heights.size() + block - 1) / block));
    parallel::for_each_index(parts.size(), threads, [&](std::size_t part) {
        const auto first = static_cast<Index>(part) * block;
        parts[part] = extremes(heights.data() + first, std::min(block, heights.size() - first));
    });
    Extremes all;
    for (const auto& part : parts) all.add(part.lowest, part.highest);
    return all;
}

}  // namespace

double height_range(const HeightMap& surface, const DilationOptions& options) {
    const auto [lowest, highest] = extremes(surface.heights, options.threads);
    if (!(lowest <= highest))
        throw UndefinedDataError(fmt::format("{}: none of {} heights is defined; a tip needs a surface to touch",
                                             label(surface.metadata), surface.heights.size()));
    if (!std::isfinite(highest - lowest))
        throw InvalidArgument(fmt::format("{}: heights from {} m to {} m; expected finite or undefined ones",
                                          label(surface.metadata), lowest, highest));
    if (!options.height_range) return highest - lowest;
    if (!(*options.height_range >= 0.0) || !std::isfinite(*options.height_range))
        throw InvalidArgument(fmt::format("height range {} m; expected a finite number >= 0", *options.height_range));
    return *options.height_range;
}

double contact_reach(const Tip& tip, double range) {
    return tip_reach(tip, std::holds_alternative<ArrayTip>(tip) ? std::numeric_limits<double>::infinity() : range);
}

TipImage touching_tip(const HeightMap& surface, const Tip& tip, const DilationOptions& options) {
    if (!(surface.size[0] > 0.0) || !(surface.size[1] > 0.0))
        throw InvalidArgument(fmt::format("{}: surface of {} m by {} m; expected positive lengths",
                                          label(surface.metadata), surface.size[0], surface.size[1]));
    const double reach = contact_reach(tip, height_range(surface, options));
    if (!surface.periodic && (reach > surface.size[0] || reach > surface.size[1]))
        throw InvalidArgument(
            fmt::format("{}: the tip extends {:.4g} m from its axis, but the surface measures {:.4g} m by {:.4g} m; "
                        "expected a tip smaller than the surface, a periodic surface or a lower height_range",
                        label(surface.metadata), reach, surface.size[0], surface.size[1]));
    const auto pixel = surface.pixel_size();
    return tip_image(tip, pixel[0], pixel[1], reach);
}

}  // namespace setae::topography
