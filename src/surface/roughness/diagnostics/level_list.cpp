// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::diagnostics {
namespace {

/// Distinct heights in increasing order as levels. range: from the lowest to the highest of all heights.
std::vector<Level> joined(const std::vector<Level>& sorted, double range) {
    const double same = 1e-9 * range;
    std::vector<Level> levels;
    for (const auto& [height, count] : sorted) {
        if (levels.empty() || height - levels.back().height > same) levels.push_back({height, 0});
        levels.back().count += count;
    }
    return levels;
}

/// Joins equal neighbours.
std::vector<Level> counted(std::vector<double> heights) {
    std::sort(heights.begin(), heights.end());
    std::vector<Level> levels;
    for (const double height : heights) {
        if (levels.empty() || height != levels.back().height) levels.push_back({height, 0});
        ++levels.back().count;
    }
    return levels;
}

/// Number of points of each value, without sorting all; empty if there are too many values.
std::optional<std::vector<Level>> few_values(const Array2D& heights) {
    const auto most = static_cast<std::size_t>(heights.size() / 16);
    std::unordered_map<double, Index> counts;
    double last = undefined;
    Index* of_last = nullptr;
    for (Index k = 0; k < heights.size(); ++k) {
        const double height = heights.data()[k];
        if (std::isnan(height)) continue;
        if (height != last) {
            of_last = &counts[height];
            last = height;
            if (counts.size() > most) return {};
        }
        ++*of_last;
    }
    std::vector<Level> values;
    values.reserve(counts.size());
    for (const auto& [height, count] : counts) values.push_back({height, count});
    std::sort(values.begin(), values.end(), [](const Level& a, const Level& b) { return a.height < b.height; });
    return values;
}

std::vector<double> defined_heights(const Array2D& heights, Index defined) {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(defined));
    for (Index k = 0; k < heights.size(); ++k)
        if (heights.data()[k] == heights.data()[k]) values.push_back(heights.data()[k]);
    return values;
}

/// The heights below and above which about a share of those between the two extremes is found, from a sample.
std::optional<std::array<double, 2>> outer_bounds(const Evidence& evidence, double share) {
    constexpr Index min_step = 61, enough = Index{1} << 17;
    const auto& heights = evidence.map->heights;
    std::vector<double> sample;
    for (Index k = 0; k < heights.size(); k += std::max(min_step, heights.size() / enough))
        if (const double h = heights.data()[k]; h > evidence.lowest && h < evidence.highest) sample.push_back(h);
    if (sample.empty()) return {};
    const auto outer = static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
    const auto low = sample.begin() + outer, high = sample.end() - 1 - outer;
    std::nth_element(sample.begin(), low, sample.end());
    const double bound = *low;
    std::nth_element(sample.begin(), high, sample.end());
    return std::array{bound, *high};
}

/// Heights at and near both extremes.
struct Outer {
    Index at_lowest = 0, at_highest = 0;
    std::vector<double> low, high;
};

Outer outer_heights(const Evidence& evidence, const std::array<double, 2>& bounds, parallel::Threads threads) {
    const auto& heights = evidence.map->heights;
    const double lowest = evidence.lowest, highest = evidence.highest;
    Outer all;
    for (const auto& part : numerics::by_row_blocks(numerics::RowBlocks(heights.size(), 1), threads, Outer{},
                                                    [&](Index first, Index last, Outer& found) {
                                                        for (Index k = first; k < last; ++k) {
                                                            const double h = heights.data()[k];
                                                            if (h > bounds[0] && h < bounds[1]) continue;
                                                            if (h == lowest) ++found.at_lowest;
                                                            else if (h == highest) ++found.at_highest;
                                                            else if (h <= bounds[0]) found.low.push_back(h);
                                                            if (h >= bounds[1] && h < highest) found.high.push_back(h);
                                                        }
                                                    })) {
        all.at_lowest += part.at_lowest;
        all.at_highest += part.at_highest;
        all.low.insert(all.low.end(), part.low.begin(), part.low.end());
        all.high.insert(all.high.end(), part.high.begin(), part.high.end());
    }
    return all;
}

}  // namespace

std::vector<Level> all_levels(const Evidence& evidence) {
    const auto& heights = evidence.map->heights;
    const double range = evidence.highest - evidence.lowest;
    if (const auto values = few_values(heights)) return joined(*values, range);
    return joined(counted(defined_heights(heights, evidence.defined)), range);
}

EndLevels end_levels(const Evidence& evidence, std::size_t needed, parallel::Threads threads) {
    constexpr Index many = Index{1} << 16;
    constexpr double outer_share = 0.005;
    const auto bounds = evidence.map->heights.size() < many ? std::nullopt : outer_bounds(evidence, outer_share);
    if (bounds) {
        auto outer = outer_heights(evidence, *bounds, threads);
        auto low = counted(std::move(outer.low)), high = counted(std::move(outer.high));
        low.insert(low.begin(), {evidence.lowest, outer.at_lowest});
        high.push_back({evidence.highest, outer.at_highest});
        const double range = evidence.highest - evidence.lowest;
        EndLevels ends{joined(low, range), joined(high, range)};
        // the innermost one may extend beyond the bound
        if (std::min(ends.lowest.size(), ends.highest.size()) > needed) return ends;
    }
    const auto all = all_levels(evidence);
    return {all, all};
}

}  // namespace setae::diagnostics
