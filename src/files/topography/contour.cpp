// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/contour.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "backward_runs.hpp"
#include "setae/core/errors.hpp"

namespace setae::topography {
namespace {

double arc_length(const Profile& contour, Index first, Index last) {
    double length = 0.0;
    for (Index i = first + 1; i <= last; ++i)
        length +=
            std::hypot(contour.positions[i] - contour.positions[i - 1], contour.heights[i] - contour.heights[i - 1]);
    return length;
}

}  // namespace

Profile defined_points(Profile contour) {
    std::vector<Index> kept;
    for (Index i = 0; i < contour.positions.size(); ++i)
        if (std::isfinite(contour.positions[i]) && std::isfinite(contour.heights[i])) kept.push_back(i);
    if (kept.size() >= 2 && contour.positions[kept.back()] < contour.positions[kept.front()])
        std::reverse(kept.begin(), kept.end());
    for (Array1D* column : {&contour.positions, &contour.heights, &contour.standard_error}) {
        if (column->size() == 0) continue;
        const Array1D part = (*column)(kept);
        *column = part;
    }
    return contour;
}

CleanedContour clean_contour(Profile contour, double tolerance) {
    if (contour.positions.size() != contour.heights.size())
        throw InvalidArgument(fmt::format("contour has {} positions for {} heights; expected one height per position",
                                          contour.positions.size(), contour.heights.size()));
    if (contour.standard_error.size() != 0 && contour.standard_error.size() != contour.heights.size())
        throw InvalidArgument(fmt::format("contour has {} standard errors for {} heights; expected one per height",
                                          contour.standard_error.size(), contour.heights.size()));
    CleanedContour result;
    contour = defined_points(std::move(contour));
    const auto n = contour.positions.size();
    std::vector<Index> kept;
    double cut_length = 0.0;
    Index next = 0;
    const auto keep_until = [&](Index end) {
        for (; next < end; ++next) kept.push_back(next);
    };
    for (const auto& run : backward_runs(contour.positions)) {
        keep_until(run.first);
        next = run.last + 1;
        if (run.depth <= tolerance) {
            result.dropped_points += next - run.first;
        } else {
            result.reentrant_points += next - run.first;
            cut_length += arc_length(contour, run.first - 1, run.last);
        }
    }
    keep_until(n);
    const auto left = static_cast<Index>(kept.size());
    if (left < 2)
        throw UndefinedDataError(
            fmt::format("{} of {} contour points have increasing x, expected at least 2", left, n));
    result.profile.metadata = contour.metadata;
    result.profile.response = contour.response;
    if (contour.standard_error.size() > 0) result.profile.standard_error = contour.standard_error(kept);
    result.profile.positions = contour.positions(kept);
    result.profile.heights = contour.heights(kept);
    if (result.profile.response && result.reentrant_points > 0) result.profile.response->jumps = true;
    const double total = arc_length(contour, 0, n - 1);
    result.reentrant_share = total > 0.0 ? cut_length / total : 0.0;
    if (result.reentrant_points > 0)
        result.alerts.push_back(
            {"REENTRANT", contour.metadata.file,
             fmt::format("{} points on re-entrant stretches, {:.2g} % of the length of the contour, were removed",
                         result.reentrant_points, 100.0 * result.reentrant_share),
             "look at the contour; if the share exceeds a few per cent, slope and curvature are lower bounds"});
    return result;
}

}  // namespace setae::topography
