// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_record.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::processing {
namespace {

using numerics::by_row_blocks;
using numerics::RowBlocks;

/// Points, their mean and the sum of squares about it.
struct Spread {
    double points = 0.0, mean = 0.0, squares = 0.0;

    /// Source: Chan, Golub and LeVeque, Am. Stat. 37 (1983) 242.
    void add(const Spread& other) {
        if (other.points == 0.0) return;
        const double all = points + other.points, step = other.mean - mean;
        squares += other.squares + step * step * points * other.points / all;
        mean += step * other.points / all;
        points = all;
    }
};

/// Σ term(h) over defined heights, in lanes for vectorisation.
template <class Term>
double sum_of(const double* heights, Index n, Term term) {
    constexpr Index lanes = 4;
    double sums[lanes] = {};
    Index i = 0;
    for (; i + lanes <= n; i += lanes)
        for (Index lane = 0; lane < lanes; ++lane) {
            const double h = heights[i + lane];
            sums[lane] += std::isnan(h) ? 0.0 : term(h);
        }
    for (; i < n; ++i) sums[0] += std::isnan(heights[i]) ? 0.0 : term(heights[i]);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

Spread spread_of(const double* heights, Index n) {
    Spread spread;
    spread.points = sum_of(heights, n, [](double) { return 1.0; });
    if (spread.points == 0.0) return {};
    double origin = 0.0;
    for (Index i = 0; i < n; ++i)
        if (!std::isnan(heights[i])) {
            origin = heights[i];
            break;
        }
    const double mean = sum_of(heights, n, [origin](double h) { return h - origin; }) / spread.points;
    spread.squares = sum_of(heights, n, [origin, mean](double h) { return (h - origin - mean) * (h - origin - mean); });
    spread.mean = origin + mean;
    return spread;
}

Spread spread_of(const topography::HeightMap& map, parallel::Threads threads) {
    const auto columns = map.heights.cols();
    Spread all;
    for (const auto& part : by_row_blocks(
             RowBlocks(map.heights.rows(), columns), threads, Spread{}, [&](Index first, Index last, Spread& spread) {
                 spread = spread_of(map.heights.data() + first * columns, (last - first) * columns);
             }))
        all.add(part);
    return all;
}

Spread spread_of(const topography::LineScan& scan, parallel::Threads) {
    return spread_of(scan.heights.data(), scan.heights.size());
}

/// Integrals over segments with both ends defined, about their mean.
Spread spread_of(const topography::Profile& profile, parallel::Threads) {
    Spread all;
    for (Index i = 0; i + 1 < profile.heights.size(); ++i) {
        const double length = profile.positions[i + 1] - profile.positions[i],
                     rise = profile.heights[i + 1] - profile.heights[i];
        if (!std::isnan(rise) && length > 0.0)
            all.add({length, profile.heights[i] + 0.5 * rise, rise * rise * length / 12.0});
    }
    return all;
}

}  // namespace

Quantity recorded(std::string quantity, std::string symbol, double value, std::string unit) {
    Quantity number;
    number.quantity = std::move(quantity);
    number.symbol = std::move(symbol);
    number.estimate.value = value;
    number.unit = std::move(unit);
    return number;
}

Quantity recorded_count(std::string quantity, Index count) {
    return recorded(std::move(quantity), "n", static_cast<double>(count), "1");
}

std::optional<Quantity> rms_height(const topography::Measurement& measurement, parallel::Threads threads) {
    const auto spread = std::visit([threads](const auto& m) { return spread_of(m, threads); }, measurement);
    if (!(spread.points > 0.0)) return std::nullopt;
    const bool map = std::holds_alternative<topography::HeightMap>(measurement);
    return recorded(map ? "areal_rms_height" : "profile_rms_height", map ? "Sq" : "Rq",
                    std::sqrt(spread.squares / spread.points), "m");
}

void refuse_line(std::string_view step, const topography::Measurement& measurement, std::string_view remedy) {
    throw InvalidArgument(fmt::format("{}: {} is a line; expected a map; {}", step,
                                      topography::label(topography::metadata(measurement)), remedy));
}

}  // namespace setae::processing
