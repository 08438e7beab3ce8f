// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/despike.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "local_medians.hpp"
#include "order_statistic.hpp"
#include "outliers.hpp"
#include "pipeline/step_record.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Mask;

/// Rows and columns of heights without a copy; a line is one row.
struct Field {
    const double* heights;
    Index rows, columns;

    [[nodiscard]] double at(Index i, Index j) const { return heights[i * columns + j]; }
};

/// Points on each side, reduced equally on both sides at the ends of the field.
Index narrowed(Index reach, Index place, Index count) { return std::min({reach, place, count - 1 - place}); }

/// Median of h − h(i, j) over the defined points around (i, j), minus the tilt; NaN if there is none. Points marked in
/// `left_out` are excluded, and with `symmetric` also the points opposite to them.
double local_median(const Field& field, const Tilt& tilt, Index i, Index j, Index reach_i, Index reach_j,
                    const Mask* left_out, bool symmetric) {
    std::array<double, (2 * largest_reach + 1) * (2 * largest_reach + 1)> values;
    Index n = 0;
    const double here = field.at(i, j);
    const auto out = [&](Index a, Index b) { return left_out && left_out->data()[a * field.columns + b]; };
    for (Index a = i - reach_i; a <= i + reach_i; ++a)
        for (Index b = j - reach_j; b <= j + reach_j; ++b) {
            const double rise = field.at(a, b) - here;
            if (std::isnan(rise) || (a == i && b == j) || out(a, b) || (symmetric && out(2 * i - a, 2 * j - b)))
                continue;
            values[static_cast<std::size_t>(n++)] =
                rise - static_cast<double>(a - i) * tilt.down - static_cast<double>(b - j) * tilt.along;
        }
    return n > 0 ? median({values.data(), static_cast<std::size_t>(n)}) : undefined;
}

/// Median of the differences of each height to the one at this distance; 0 if there is none.
double median_rise(const Field& field, Index down, Index along, parallel::Threads threads) {
    const auto rise = [=](Index i, Index j) { return field.at(i + down, j + along) - field.at(i, j); };
    const ComputedRows rises{field.rows - down, field.columns - along,
                             [=](Index i, double* values) {
                                 for (Index j = 0; j + along < field.columns; ++j) values[j] = rise(i, j);
                             },
                             rise};
    return quantile(rises, 0.5, threads).value_or(0.0);
}

Tilt median_tilt(const Field& field, parallel::Threads threads) {
    return {median_rise(field, 1, 0, threads), median_rise(field, 0, 1, threads)};
}

/// Whether all heights of a range of rows around row i are defined.
bool defined_around(const Field& field, Index i, Index reach_i, Index first, Index count) {
    double sum = 0.0;
    for (Index a = i - reach_i; a <= i + reach_i; ++a)
        sum += Eigen::Map<const Array1D>(field.heights + a * field.columns + first, count).sum();
    return std::isfinite(sum);
}

/// r: heights minus the median of their surroundings; NaN if either is undefined.
struct Differences {
    const Field& field;
    Tilt tilt;
    Index reach;

    [[nodiscard]] double at(Index i, Index j) const {
        return -local_median(field, tilt, i, j, narrowed(reach, i, field.rows), narrowed(reach, j, field.columns),
                             nullptr, false);
    }

    /// Differences of row i.
    void load(Index i, double* r) const {
        constexpr Index together = medians_together, stretch = 16 * together;
        const Index reach_i = narrowed(reach, i, field.rows);
        Index j = 0;
        for (; j < std::min(reach, field.columns); ++j) r[j] = at(i, j);
        while (j + together + reach <= field.columns) {
            const Index groups = std::min(stretch, field.columns - reach - j) / together;
            if (load_several(i, reach_i, j, groups * together, r)) {
                j += groups * together;
                continue;
            }
            for (const Index end = j + groups * together; j < end; j += together)
                if (!load_several(i, reach_i, j, together, r))
                    for (Index k = j; k < j + together; ++k) r[k] = at(i, k);
        }
        for (; j < field.columns; ++j) r[j] = at(i, j);
    }

private:
    /// Computes several medians if all heights around are defined; otherwise false.
    bool load_several(Index i, Index reach_i, Index j, Index count, double* r) const {
        if (!defined_around(field, i, reach_i, j - reach, count + 2 * reach)) return false;
        find_local_medians(field.heights + i * field.columns + j, field.columns, tilt, {reach_i, reach},
                           count / medians_together, r + j);
        for (Index k = j; k < j + count; ++k) r[k] = -r[k];
        return true;
    }
};

/// Whether a third of the points around (i, j) have its height, to within `width`: the edge of a step, the corner of an
/// island.
bool has_company(const Field& field, const Tilt& tilt, Index i, Index j, Index reach, double width) {
    const Index reach_i = narrowed(reach, i, field.rows), reach_j = narrowed(reach, j, field.columns);
    Index around = 0, level = 0;
    for (Index a = i - reach_i; a <= i + reach_i; ++a)
        for (Index b = j - reach_j; b <= j + reach_j; ++b) {
            const double rise = field.at(a, b) - field.at(i, j);
            if (std::isnan(rise) || (a == i && b == j)) continue;
            ++around;
            level += std::fabs(rise - static_cast<double>(a - i) * tilt.down -
                               static_cast<double>(b - j) * tilt.along) <= width;
        }
    return 3 * level >= around;
}

/// Marks the candidates with |r| > threshold, the largest first: a point is a spike only if it differs from the points
/// around it that are no spikes (also without their opposite points, which keeps the median on a slope).
void mark_spikes(const Differences& differences, std::vector<Outlier> candidates, Spikes& spikes) {
    const auto& [field, tilt, reach] = differences;
    // if surroundings are equal to the last bit, a difference by rounding is no spike
    constexpr double rounding = 1e-14;
    const auto exceeds = [&, heights = field.heights](double difference, Index point) {
        return std::fabs(difference) > std::max(spikes.threshold, rounding * std::fabs(heights[point]));
    };
    std::erase_if(candidates, [&](const Outlier& c) { return !exceeds(c.difference, c.point); });
    std::stable_sort(candidates.begin(), candidates.end(), [](const Outlier& a, const Outlier& b) {
        return std::fabs(a.difference) > std::fabs(b.difference);
    });
    for (const auto& [point, difference] : candidates) {
        const Index i = point / field.columns, j = point % field.columns;
        if (has_company(field, tilt, i, j, reach, 0.5 * std::fabs(difference))) continue;
        const double median = local_median(field, tilt, i, j, narrowed(reach, i, field.rows),
                                           narrowed(reach, j, field.columns), &spikes.mask, true);
        if (!std::isnan(median) && !exceeds(median, point)) continue;
        spikes.mask.data()[point] = 1;
        ++spikes.count;
    }
}

void require_domain(double threshold, Index reach) {
    if (!(threshold > 0.0) || !std::isfinite(threshold))
        throw InvalidArgument(fmt::format("threshold of spikes {}; expected a number > 0, such as 6", threshold));
    if (reach < 1 || reach > largest_reach)
        throw InvalidArgument(
            fmt::format("reach of the local median {}; expected 1 … {} points", reach, largest_reach));
}

Spikes spikes_of(const Field& field, const SpikeOptions& options, const topography::Metadata& metadata,
                 parallel::Threads threads) {
    require_domain(options.threshold, options.reach);
    const Index points = field.rows * field.columns;
    if (!std::any_of(field.heights, field.heights + points, [](double h) { return !std::isnan(h); }))
        throw UndefinedDataError(
            fmt::format("{}: no height is defined, so that no spikes can be found", topography::label(metadata)));
    const Differences differences{field, median_tilt(field, threads), options.reach};
    auto outliers = find_outliers({field.rows, field.columns, [&](Index i, double* r) { differences.load(i, r); },
                                   [&](Index i, Index j) { return differences.at(i, j); }},
                                  options.threshold, threads);
    Spikes spikes;
    spikes.deviation = outliers.deviation;
    spikes.threshold = options.threshold * spikes.deviation;
    spikes.mask = Mask::Zero(field.rows, field.columns);
    mark_spikes(differences, std::move(outliers.points), spikes);
    return spikes;
}

Field field_of(const HeightMap& map) { return {map.heights.data(), map.heights.rows(), map.heights.cols()}; }
Field field_of(const LineScan& scan) { return {scan.heights.data(), 1, scan.heights.size()}; }

/// Median of the points around a spike that are none, from the smallest sufficient distance.
double replacement(const Field& field, Index i, Index j, Index reach, const Mask& spikes) {
    for (; reach <= largest_reach; ++reach) {
        const double rise = local_median(field, {}, i, j, narrowed(reach, i, field.rows),
                                         narrowed(reach, j, field.columns), &spikes, false);
        if (!std::isnan(rise)) return field.at(i, j) + rise;
    }
    return undefined;
}

std::vector<NewHeight> heights_without(const Spikes& spikes, const Despike& step, const Field& field) {
    std::vector<NewHeight> changes;
    for (Index k = 0; k < spikes.mask.size(); ++k)
        if (spikes.mask.data()[k])
            changes.push_back(
                {k, step.replace_by == SpikeReplacement::undefined
                        ? undefined
                        : replacement(field, k / field.columns, k % field.columns, step.reach, spikes.mask)});
    return changes;
}

/// The mask of a line in the form of Mask: (n, 1).
Spikes as_line(Spikes spikes) {
    spikes.mask.resize(spikes.mask.size(), 1);
    return spikes;
}

}  // namespace

Spikes find_spikes(const HeightMap& map, const SpikeOptions& options, parallel::Threads threads) {
    return spikes_of(field_of(map), options, map.metadata, threads);
}

Spikes find_spikes(const LineScan& scan, const SpikeOptions& options, parallel::Threads threads) {
    return as_line(spikes_of(field_of(scan), options, scan.metadata, threads));
}

std::vector<NewHeight> heights_without(const Spikes& spikes, const Despike& step, const HeightMap& map) {
    return heights_without(spikes, step, field_of(map));
}

std::vector<NewHeight> heights_without(const Spikes& spikes, const Despike& step, const LineScan& scan) {
    return heights_without(spikes, step, field_of(scan));
}

Processed apply(const Despike& step, topography::Measurement measurement, parallel::Threads threads) {
    if (std::holds_alternative<topography::Profile>(measurement))
        throw InvalidArgument(
            fmt::format("despike: {} is a polyline, whose points are not equally spaced; resample the polyline first",
                        topography::label(topography::metadata(measurement))));
    StepRecord record{std::string(step_name(step)), {}, {}};
    const auto before = rms_height(measurement, threads);
    const auto treat = [&](auto& uniform) {
        const auto spikes = find_spikes(uniform, {step.threshold, step.reach}, threads);
        for (const auto& [point, height] : heights_without(spikes, step, uniform))
            uniform.heights.data()[point] = height;
        record.numbers = {recorded_count("spikes", spikes.count),
                          recorded("spike_threshold", "t", spikes.threshold, "m"),
                          recorded("robust_deviation", "s", spikes.deviation, "m")};
    };
    if (auto* map = std::get_if<HeightMap>(&measurement)) treat(*map);
    else treat(std::get<LineScan>(measurement));
    for (const auto& [when, rms] :
         {std::pair{"_before", before}, std::pair{"_after", rms_height(measurement, threads)}})
        if (rms) record.numbers.push_back(recorded(rms->quantity + when, rms->symbol, rms->estimate.value, "m"));
    return {std::move(measurement), std::move(record)};
}

}  // namespace setae::processing
