// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/level.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "line_polynomial.hpp"
#include "pipeline/step_record.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Mask;
using topography::PolynomialDegrees;
using topography::PolynomialSurface;
using topography::Profile;

void end_periodicity(HeightMap& map) { map.periodic = false; }
void end_periodicity(LineScan& scan) { scan.periodic = false; }
void end_periodicity(Profile&) {}

/// Subtracted polynomial in terms of heights, slopes and radii.
std::vector<Quantity> removed(const PolynomialSurface& polynomial, bool map) {
    std::vector<Quantity> numbers{recorded("removed_height", "z0", polynomial.mean_height(), "m")};
    const auto slope = polynomial.mean_slope(), curvature = polynomial.mean_curvature();
    const std::array<Index, 2> degree{polynomial.coefficients.rows() - 1, polynomial.coefficients.cols() - 1};
    for (std::size_t k = 0; k < (map ? 2u : 1u); ++k) {
        const std::string direction = k == 0 ? "x" : "y";
        if (degree[k] >= 1) numbers.push_back(recorded("removed_slope_" + direction, "s_" + direction, slope[k], "1"));
        if (degree[k] >= 2 && curvature[k] != 0.0)
            numbers.push_back(recorded("removed_radius_" + direction, "R_" + direction, 1.0 / curvature[k], "m"));
    }
    return numbers;
}

Processed level(std::string_view name, const PolynomialDegrees& degrees, const Region& region,
                topography::Measurement measurement, parallel::Threads threads) {
    StepRecord record{std::string(name), {}, {}};
    std::visit(
        [&](auto& m) {
            const auto chosen = region.everything() ? Mask() : mask_of(region, m, threads);
            const auto polynomial = fitted_polynomial(m, degrees, chosen, threads);
            subtract(polynomial, m, threads);
            if (polynomial.coefficients.size() > 1) end_periodicity(m);
            record.numbers = removed(polynomial, std::is_same_v<std::decay_t<decltype(m)>, HeightMap>);
        },
        measurement);
    return {std::move(measurement), std::move(record)};
}

/// Subtracts the polynomial of every line; returns the number of lines with too few points.
Index level_lines(const LevelLines& step, HeightMap& map, parallel::Threads threads) {
    const LinePolynomial polynomial(step.degree, points_on_line(map.heights, step.direction));
    const auto chosen = step.region.everything() ? Mask() : mask_of(step.region, map, threads);
    std::vector<std::uint8_t> lost(static_cast<std::size_t>(line_count(map.heights, step.direction)), 0);
    for_each_band(map.heights, chosen, step.direction, 0, true, threads, [&](LineBand& band, Index first, Index last) {
        for (Index line = first; line < last; ++line) {
            if (const auto coefficients = polynomial.fitted(band, line)) {
                polynomial.subtract(*coefficients, band.line(line));
                continue;
            }
            std::fill_n(band.line(line), band.points, undefined);
            lost[static_cast<std::size_t>(line)] = 1;
        }
    });
    return static_cast<Index>(std::count(lost.begin(), lost.end(), 1));
}

}  // namespace

Processed apply(const LevelMean& step, topography::Measurement measurement, parallel::Threads threads) {
    return level(step_name(step), {.total = 0}, step.region, std::move(measurement), threads);
}

Processed apply(const LevelPlane& step, topography::Measurement measurement, parallel::Threads threads) {
    return level(step_name(step), {.total = 1}, step.region, std::move(measurement), threads);
}

Processed apply(const LevelPolynomial& step, topography::Measurement measurement, parallel::Threads threads) {
    return level(step_name(step), {step.degree, step.degree_x, step.degree_y}, step.region, std::move(measurement),
                 threads);
}

Processed apply(const LevelLines& step, topography::Measurement measurement, parallel::Threads threads) {
    auto* map = std::get_if<HeightMap>(&measurement);
    if (!map) return level(step_name(step), {.total = step.degree}, step.region, std::move(measurement), threads);
    StepRecord record{std::string(step_name(step)), {}, {}};
    const Index lines = line_count(map->heights, step.direction), lost = level_lines(step, *map, threads);
    if (lost == lines)
        throw UndefinedDataError(
            fmt::format("{}: no scan line has {} points inside the region; reduce the degree or enlarge the region",
                        topography::label(map->metadata), step.degree + 1));
    if (step.degree > 0) end_periodicity(*map);
    record.numbers.push_back(recorded_count("levelled_lines", lines - lost));
    if (lost > 0)
        record.alerts.push_back(
            {"UNDEFINED", topography::label(map->metadata),
             fmt::format("{} of {} scan lines have too few points inside the region; their heights are now undefined",
                         lost, lines),
             "reduce the degree or enlarge the region"});
    return {std::move(measurement), std::move(record)};
}

}  // namespace setae::processing
