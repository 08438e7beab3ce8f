// SPDX-License-Identifier: GPL-3.0-or-later
#include "record.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "baseline.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::loops {
namespace {

constexpr Index fewest_samples = 20;
constexpr Index fewest_free_samples = 5;

void require_series(const Array1D& series, const char* name, Index expected, bool may_be_undefined) {
    if (series.size() == 0) return;
    if (series.size() != expected)
        throw InvalidArgument(fmt::format("{} has {} samples, force has {}", name, series.size(), expected));
    if (may_be_undefined) return;
    for (Index i = 0; i < series.size(); ++i)
        if (!std::isfinite(series[i]))
            throw InvalidArgument(
                fmt::format("{} is undefined at sample {}; remove such samples from every series", name, i));
}

/// Samples before the first with a contact radius > 0.
Index leading_free_samples(const Array1D& contact_radius) {
    Index i = 0;
    while (i < contact_radius.size() && !(contact_radius[i] > 0.0)) ++i;
    return i;
}

/// Samples before the force leaves free flight for good: the first two in a row (or the last one) so far from the
/// median that no noise takes them there, the scatter being that of the middle half. All of them where there are none.
Index samples_before_contact(const ArrayView1D& force) {
    constexpr double far = 8.0, scatter_over_median_deviation = 1.4826;
    const double zero = median_of(force);
    const double limit = far * scatter_over_median_deviation * median_of((force - zero).abs());
    const auto is_far = [&](Index i) { return i == force.size() || std::abs(force[i] - zero) > limit; };
    for (Index i = 0; i < force.size() && limit > 0.0; ++i)
        if (is_far(i) && is_far(i + 1)) return i;
    return force.size();
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
    if (n < fewest_samples)
        throw InvalidArgument(fmt::format("force has {} samples, a loop needs at least {}", n, fewest_samples));
    if (loop.displacement.size() == 0 && loop.contact_radius.size() == 0)
        throw InvalidArgument(
            "a loop needs displacement or contact radius beside the force; map a column to one of them");
    require_series(loop.force, "force", n, false);
    require_series(loop.displacement, "displacement", n, false);
    require_series(loop.time, "time", n, true);
    require_series(loop.contact_radius, "contact radius", n, true);
}

Baseline find_baseline(const Loop& loop, const SegmentOptions& options) {
    if (!(options.baseline_share > 0.0 && options.baseline_share < 1.0))
        throw InvalidArgument(fmt::format("baseline share must lie in (0, 1), got {}", options.baseline_share));
    if (options.force_baseline) return {.force = *options.force_baseline};
    if (options.edits.baseline_before) return given_baseline(loop, *options.edits.baseline_before, "baseline");
    auto count = static_cast<Index>(options.baseline_share * static_cast<double>(loop.force.size()));
    count = std::max(count, fewest_free_samples);
    if (loop.contact_radius.size() > 0) {
        count = std::min(count, leading_free_samples(loop.contact_radius));
        if (count < fewest_free_samples) return {};  // recorded in contact only: the zero of force is taken as given
    }
    // a share of a long record can reach into the contact, which a camera slower than the force shows late
    if (const Index free = samples_before_contact(loop.force.head(count)); free >= fewest_free_samples) count = free;
    const Baseline baseline = baseline_over(loop, {.first = 0, .last = count - 1});
    const double range = loop.force.maxCoeff() - loop.force.minCoeff();
    constexpr double wander_limit = 0.05;  // of the force range
    constexpr double wander_over_noise = 2.0;
    if (baseline.force_scatter > wander_limit * range &&
        baseline.force_scatter > wander_over_noise * baseline.force_noise)
        throw UndefinedDataError(
            fmt::format("the first {} samples are no free flight: their force wanders by {}, {:.0f} % of the whole "
                        "range; shorten the baseline share or give the zero of force",
                        count, format_value(baseline.force_scatter, "N", 3), 100.0 * baseline.force_scatter / range));
    return baseline;
}

Record make_record(const Loop& loop, const Baseline& baseline, const SegmentOptions& options) {
    Record record{.loop = loop, .force = loop.force - baseline.force};
    record.range = record.force.maxCoeff() - record.force.minCoeff();
    if (!(record.range > 0.0)) throw UndefinedDataError("the force is constant: no contact to analyse");
    constexpr double range_of_noise = 12.0;  // in standard deviations, beyond any that noise reaches
    if (record.range <= range_of_noise * baseline.force_scatter)
        throw UndefinedDataError(
            fmt::format("the force never leaves its noise: range {}, scatter of free flight "
                        "{}; no contact to analyse",
                        format_value(record.range, "N", 3), format_value(baseline.force_scatter, "N", 3)));
    constexpr double rounding = 1e-9;  // of the range: what counts as zero in a record without noise
    constexpr double free_share = 0.01;
    record.feature = std::max(options.feature_factor * baseline.force_scatter, rounding * record.range);
    record.free_level = std::max(record.feature, free_share * record.range);
    record.turning = std::max(options.turning_share * record.range, record.feature);
    return record;
}

}  // namespace setae::loops
