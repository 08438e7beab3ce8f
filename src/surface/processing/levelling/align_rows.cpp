// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/align_rows.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "line_polynomial.hpp"
#include "pipeline/step_record.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::processing {
namespace {

using numerics::for_each_row;

using topography::HeightMap;
using topography::Mask;

/// Mean or median of the used points of a line, or of their differences to the previous line; NaN if there are none.
double level_of(LineBand& band, Index line, RowAlignment method, std::vector<double>& values) {
    values.clear();
    const double* const heights = band.line(line);
    const bool differences = method == RowAlignment::median_of_differences;
    const double* const before = differences ? band.line(line - 1) : nullptr;
    for (Index i = 0; i < band.points; ++i) {
        if (!band.counts(line, i) || (differences && !band.counts(line - 1, i))) continue;
        values.push_back(differences ? heights[i] - before[i] : heights[i]);
    }
    if (values.empty()) return undefined;
    if (method != RowAlignment::mean) return median(values);
    const double origin = values.front();
    for (auto& value : values) value -= origin;
    return origin + Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size())).mean();
}

/// Shift of every line before the mean is restored; lines without used points move with a neighbour.
Array1D shifts_of(const AlignRows& step, HeightMap& map, const Mask& chosen, parallel::Threads threads) {
    const Index lines = line_count(map.heights, step.direction);
    const bool differences = step.method == RowAlignment::median_of_differences;
    Array1D levels = Array1D::Constant(lines, undefined);
    for_each_band(map.heights, chosen, step.direction, differences ? 1 : 0, false, threads,
                  [&](LineBand& band, Index first, Index last) {
                      std::vector<double> values;
                      values.reserve(static_cast<std::size_t>(band.points));
                      for (Index line = differences ? std::max<Index>(first, 1) : first; line < last; ++line)
                          levels[line] = level_of(band, line, step.method, values);
                  });
    if (levels.isNaN().all())
        throw UndefinedDataError(fmt::format("{}: no scan line has a point inside the region; enlarge the region",
                                             topography::label(map.metadata)));
    if (differences) {
        levels[0] = 0.0;
        for (Index line = 1; line < lines; ++line)
            levels[line] = levels[line - 1] + (std::isnan(levels[line]) ? 0.0 : levels[line]);
        return levels;
    }
    for (Index line = 1; line < lines; ++line)
        if (std::isnan(levels[line])) levels[line] = levels[line - 1];
    for (Index line = lines - 2; line >= 0; --line)
        if (std::isnan(levels[line])) levels[line] = levels[line + 1];
    return levels;
}

/// Shifts every line.
void move_lines(const Array1D& shifts, Direction direction, HeightMap& map, parallel::Threads threads) {
    for_each_row(map.heights.rows(), map.heights.cols(), threads, [&](Index i) {
        if (direction == Direction::x) map.heights.row(i) -= shifts.transpose();
        else map.heights.row(i) -= shifts[i];
    });
}

/// Subtracts the polynomial of every line except for the mean height of all; returns those means. Lines with too few
/// points become undefined.
Array1D remove_polynomials(const AlignRows& step, HeightMap& map, const Mask& chosen, parallel::Threads threads) {
    const LinePolynomial polynomial(step.degree, points_on_line(map.heights, step.direction));
    Array1D means = Array1D::Constant(line_count(map.heights, step.direction), undefined);
    for_each_band(map.heights, chosen, step.direction, 0, true, threads, [&](LineBand& band, Index first, Index last) {
        for (Index line = first; line < last; ++line) {
            if (const auto coefficients = polynomial.fitted(band, line)) {
                polynomial.subtract(*coefficients, band.line(line));
                means[line] = (*coefficients)[0];
            } else {
                std::fill_n(band.line(line), band.points, undefined);
            }
        }
    });
    if (means.isNaN().all())
        throw UndefinedDataError(
            fmt::format("{}: no scan line has {} points inside the region; reduce the degree or enlarge the region",
                        topography::label(map.metadata), step.degree + 1));
    return means;
}

/// Mean and rms deviation of the defined shifts.
std::array<double, 2> mean_and_spread(const Array1D& shifts) {
    const auto defined = !shifts.isNaN();
    const auto count = static_cast<double>(defined.count());
    const double origin = defined.select(shifts, 0.0).sum() / count;
    const Array1D centred = defined.select(shifts - origin, 0.0);
    const double rest = centred.sum() / count;
    return {origin + rest, std::sqrt((centred * centred).sum() / count)};
}

}  // namespace

Processed apply(const AlignRows& step, topography::Measurement measurement, parallel::Threads threads) {
    auto* map = std::get_if<HeightMap>(&measurement);
    if (!map)
        refuse_line(step_name(step), measurement, "a single line has no rows to align; level it with level_polynomial");
    const auto chosen = step.region.everything() ? Mask() : mask_of(step.region, *map, threads);
    StepRecord record{std::string(step_name(step)), {}, {}};
    const bool polynomial = step.method == RowAlignment::polynomial;
    const Array1D shifts =
        polynomial ? remove_polynomials(step, *map, chosen, threads) : shifts_of(step, *map, chosen, threads);
    const auto [mean, spread] = mean_and_spread(shifts);
    const Array1D moves = polynomial ? Array1D::Constant(shifts.size(), -mean) : Array1D(shifts - mean);
    move_lines(moves, step.direction, *map, threads);
    if (polynomial && step.degree > 0) map->periodic = false;
    const auto lost = shifts.isNaN().count();
    record.numbers.push_back(recorded_count("aligned_lines", shifts.size() - lost));
    record.numbers.push_back(recorded("rms_shift", "", spread, "m"));
    if (lost > 0)
        record.alerts.push_back(
            {"UNDEFINED", topography::label(map->metadata),
             fmt::format("{} of {} scan lines have too few points inside the region; their heights are now undefined",
                         lost, shifts.size()),
             "reduce the degree or enlarge the region"});
    return {std::move(measurement), std::move(record)};
}

}  // namespace setae::processing
