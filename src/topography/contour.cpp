// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/contour.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::topography {
namespace {

Profile defined_points(Profile contour) {
    Index kept = 0;
    for (Index i = 0; i < contour.positions.size(); ++i) {
        if (!std::isfinite(contour.positions[i]) || !std::isfinite(contour.heights[i])) continue;
        contour.positions[kept] = contour.positions[i];
        contour.heights[kept] = contour.heights[i];
        ++kept;
    }
    contour.positions.conservativeResize(kept);
    contour.heights.conservativeResize(kept);
    return contour;
}

double arc_length(const Profile& contour, Index first, Index last) {
    double length = 0.0;
    for (Index i = first + 1; i <= last; ++i)
        length += std::hypot(contour.positions[i] - contour.positions[i - 1], contour.heights[i] - contour.heights[i - 1]);
    return length;
}

}  // namespace

CleanedContour clean_contour(Profile contour, double tolerance) {
    if (contour.positions.size() != contour.heights.size())
        throw InvalidArgument(fmt::format("contour has {} positions for {} heights", contour.positions.size(), contour.heights.size()));
    CleanedContour result;
    contour = defined_points(std::move(contour));
    const auto n = contour.positions.size();
    if (n >= 2 && contour.positions[n - 1] < contour.positions[0]) {
        contour.positions.reverseInPlace();
        contour.heights.reverseInPlace();
    }
    std::vector<Index> kept;
    double cut_length = 0.0;
    for (Index i = 0; i < n;) {
        if (kept.empty() || contour.positions[i] > contour.positions[kept.back()]) {
            kept.push_back(i++);
            continue;
        }
        const double front = contour.positions[kept.back()];
        double depth = 0.0;
        const auto first = i;
        for (; i < n && contour.positions[i] <= front; ++i) depth = std::max(depth, front - contour.positions[i]);
        if (depth <= tolerance) {
            result.dropped_points += i - first;
        } else {
            result.reentrant_points += i - first;
            cut_length += arc_length(contour, kept.back(), i - 1);
        }
    }
    const auto left = static_cast<Index>(kept.size());
    if (left < 2)
        throw UndefinedDataError(fmt::format("{} of {} contour points have increasing x, expected at least 2", left, n));
    result.profile.metadata = contour.metadata;
    result.profile.positions = contour.positions(kept);
    result.profile.heights = contour.heights(kept);
    const double total = arc_length(contour, 0, n - 1);
    result.reentrant_share = total > 0.0 ? cut_length / total : 0.0;
    if (result.reentrant_points > 0)
        result.alerts.push_back({"REENTRANT", contour.metadata.file,
                                 fmt::format("{} points on re-entrant stretches, {:.2g} % of the contour's length, were cut",
                                             result.reentrant_points, 100.0 * result.reentrant_share),
                                 "look at the contour; a share above a few per cent makes slope and curvature lower bounds"});
    return result;
}

}  // namespace setae::topography
