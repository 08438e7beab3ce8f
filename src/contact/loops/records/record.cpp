// SPDX-License-Identifier: GPL-3.0-or-later
#include "record.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "baseline.hpp"
#include "local_lines.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::loops {
namespace {

constexpr Index min_samples = 20;
void require_series(const Array1D& series, const char* name, Index expected, bool may_be_undefined) {
    if (series.size() == 0) return;
    if (series.size() != expected)
        throw InvalidArgument(fmt::format("{} has {} samples, force has {}", name, series.size(), expected));
    if (may_be_undefined) return;
    for (Index i = 0; i < series.size(); ++i)
        if (!std::isfinite(series[i]))
            throw InvalidArgument(
                fmt::format("{} is undefined at sample {}; remove such samples from all series", name, i));
}

/// Scatter of the force in free flight, averaged over a number of neighbours on both sides: 1.4826 times the median of
/// its magnitude, so that a section that extends into contact is treated as free flight.
double scatter_in_free_flight(const Array1D& level, const Segments& segments, Index neighbours) {
    constexpr double normal_scale = 1.4826;
    double largest = 0.0;
    const auto add = [&](const std::optional<IndexRange>& range) {
        if (!range) return;
        const Array1D means = local_means(level.segment(range->first, range->count()), neighbours);
        largest = std::max(largest, normal_scale * median_of(means.abs()));
    };
    add(segments.before.range);
    if (segments.after) add(segments.after->range);
    if (segments.before.range || segments.after) return largest;
    return segments.before.force_noise / std::sqrt(static_cast<double>(2 * neighbours + 1));
}

}  // namespace

bool Record::is_free(Index sample) const {
    if (has_radius() && !std::isnan(loop.contact_radius[sample])) return loop.contact_radius[sample] == 0.0;
    return std::abs(force[sample]) <= free_level;
}

double Record::position(Index sample) const {
    return has_displacement() ? loop.displacement[sample] : loop.contact_radius[sample];
}

void require_valid(const Loop& loop) {
    const Index n = loop.force.size();
    if (n < min_samples)
        throw InvalidArgument(fmt::format("force has {} samples, a loop needs at least {}", n, min_samples));
    if (loop.displacement.size() == 0 && loop.contact_radius.size() == 0)
        throw InvalidArgument(
            "a loop needs displacement or contact radius in addition to the force; map a column to one of "
            "them");
    require_series(loop.force, "force", n, false);
    require_series(loop.displacement, "displacement", n, false);
    require_series(loop.time, "time", n, true);
    require_series(loop.contact_radius, "contact radius", n, true);
}

Record make_record(const Loop& loop, const Array1D& level, const Segments& segments, const SegmentOptions& options) {
    Record record{.loop = loop, .level = level, .force = level};
    record.noise = sample_noise(segments.before);
    record.range = level.maxCoeff() - level.minCoeff();
    if (!(record.range > 0.0)) throw UndefinedDataError("the force contains only drift and no contact");
    double scatter = scatter_in_free_flight(level, segments, 0);
    constexpr double range_of_noise = 12.0;  // in standard deviations, beyond the range of noise
    if (record.range <= range_of_noise * scatter)
        throw UndefinedDataError(
            fmt::format("the force never exceeds its noise (range {}, scatter of free flight {}); the record contains "
                        "no contact",
                        format_value(record.range, "N", 3), format_value(scatter, "N", 3)));
    // noise hides no feature of so small a share of the range
    constexpr double visible_share = 0.03;
    const Index most = level.size() / 100;
    Index neighbours = 0;
    while (neighbours < most && options.feature_factor * scatter > visible_share * record.range)
        scatter = scatter_in_free_flight(level, segments, ++neighbours);
    if (neighbours > 0) {
        record.force = local_means(level, neighbours);
        record.range = record.force.maxCoeff() - record.force.minCoeff();
    }
    constexpr double rounding = 1e-9;  // share of the range: zero in a record without noise
    constexpr double free_share = 0.01;
    record.feature = std::max(options.feature_factor * scatter, rounding * record.range);
    record.free_level = std::max(record.feature, free_share * record.range);
    record.turning = std::max(options.turning_share * record.range, record.feature);
    return record;
}

}  // namespace setae::loops
