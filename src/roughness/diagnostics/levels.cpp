// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "evidence.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::diagnostics {
namespace {

std::vector<double> sorted_heights(const Array2D& heights) {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(heights.size()));
    for (Index k = 0; k < heights.size(); ++k)
        if (!std::isnan(heights.data()[k])) values.push_back(heights.data()[k]);
    std::sort(values.begin(), values.end());
    return values;
}

/// A height and how many points have it.
struct Level {
    double height;
    Index count;
};

/// range: from the lowest to the highest of all heights.
std::vector<Level> levels_of(const std::vector<double>& sorted, double range) {
    const double same = 1e-9 * range;
    std::vector<Level> levels;
    for (const double h : sorted) {
        if (levels.empty() || h - levels.back().height > same) levels.push_back({h, 0});
        ++levels.back().count;
    }
    return levels;
}

/// Share of neighbours along x that have the same height.
double plateau_share(const Array2D& heights, parallel::Threads threads) {
    struct Counts {
        Index same = 0, pairs = 0;
    };
    const Index ny = heights.cols();
    Index same = 0, pairs = 0;
    for (const auto& part : numerics::by_row_blocks(numerics::RowBlocks(heights.rows() - 1, ny), threads, Counts{},
                                                    [&](Index first, Index last, Counts& counts) {
                                                        const double *here = heights.data(), *next = here + ny;
                                                        for (Index k = first * ny; k < last * ny; ++k) {
                                                            const double rise = next[k] - here[k];
                                                            counts.pairs += rise == rise;
                                                            counts.same += rise == 0.0;
                                                        }
                                                    })) {
        same += part.same;
        pairs += part.pairs;
    }
    return pairs > 0 ? static_cast<double>(same) / static_cast<double>(pairs) : 0.0;
}

/// The step all differences of levels are multiples of, or nothing: the median of the smallest quarter of gaps, refined
/// by all.
std::optional<double> common_step(const std::vector<Level>& levels) {
    std::vector<double> gaps;
    for (std::size_t k = 1; k < levels.size(); ++k) gaps.push_back(levels[k].height - levels[k - 1].height);
    std::sort(gaps.begin(), gaps.end());
    const double guess = gaps[gaps.size() / 8];
    double steps = 0.0;
    std::size_t whole = 0;
    for (const double gap : gaps) {
        const double multiple = std::round(gap / guess);
        if (multiple < 1.0) continue;
        steps += multiple;
        if (std::abs(gap / guess - multiple) < 0.1) ++whole;
    }
    if (steps < 1.0 || static_cast<double>(whole) < 0.9 * static_cast<double>(gaps.size())) return {};
    return (levels.back().height - levels.front().height) / steps;
}

/// Levels that a last one is compared with.
constexpr std::size_t levels_compared = 5;

std::vector<Level> all_levels(const Array2D& heights) {
    const auto sorted = sorted_heights(heights);
    return levels_of(sorted, sorted.back() - sorted.front());
}

/// The height that about a share of all heights lies below, from a sample of them.
double sampled_quantile(const Array2D& heights, double share) {
    constexpr Index every = 61;
    std::vector<double> sample;
    for (Index k = 0; k < heights.size(); k += every)
        if (!std::isnan(heights.data()[k])) sample.push_back(heights.data()[k]);
    return sample.empty() ? undefined : lower_quantile(std::move(sample), share);
}

/// The outermost levels at an end of the range, in increasing order, more than twice those compared where there are so
/// many: of many heights only those near the end are sorted.
std::vector<Level> levels_at_end(const Array2D& heights, bool top, parallel::Threads threads) {
    constexpr Index many = Index{1} << 16;
    constexpr double outer_share = 0.005;
    if (heights.size() < many) return all_levels(heights);
    const double bound = sampled_quantile(heights, top ? 1.0 - outer_share : outer_share);
    struct Part {
        double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
        std::vector<double> outer;
    };
    Part all;
    for (const auto& part : numerics::by_row_blocks(numerics::RowBlocks(heights.size(), 1), threads, Part{},
                                                    [&](Index first, Index last, Part& found) {
                                                        double lowest = found.lowest, highest = found.highest;
                                                        for (Index k = first; k < last; ++k) {
                                                            const double h = heights.data()[k];
                                                            lowest = h < lowest ? h : lowest;
                                                            highest = h > highest ? h : highest;
                                                            if (top ? h >= bound : h <= bound) found.outer.push_back(h);
                                                        }
                                                        found.lowest = lowest, found.highest = highest;
                                                    })) {
        all.lowest = std::min(all.lowest, part.lowest);
        all.highest = std::max(all.highest, part.highest);
        all.outer.insert(all.outer.end(), part.outer.begin(), part.outer.end());
    }
    if (all.outer.empty()) return all_levels(heights);
    std::sort(all.outer.begin(), all.outer.end());
    auto levels = levels_of(all.outer, all.highest - all.lowest);
    return levels.size() > 2 * levels_compared + 1 ? levels : all_levels(heights);
}

Found clipped_at(const Evidence& evidence, bool top, parallel::Threads threads) {
    const auto levels = levels_at_end(evidence.map->heights, top, threads);
    const auto at = [&](std::size_t k) { return top ? levels[levels.size() - 1 - k] : levels[k]; };
    if (levels.size() <= 2 * levels_compared) return {};
    double beside = 0.0;
    for (std::size_t k = 1; k <= levels_compared; ++k)
        beside += static_cast<double>(at(k).count) / static_cast<double>(levels_compared);
    const auto [height, count] = at(0);
    // tails thin out towards their ends: a last level that holds more than those before it is a limit
    if (count < 5 || static_cast<double>(count) < 3.0 * beside) return {};
    const double share = static_cast<double>(count) / static_cast<double>(evidence.defined);
    const char* end = top ? "highest" : "lowest";
    return Finding{
        {"CLIPPED", evidence.subject,
         fmt::format(
             "{} of {} points ({:.2g} %) have exactly the {} height: the range of the instrument or file ended there",
             count, evidence.defined, 100.0 * share, end),
         "measure again with a larger range, or mark these points undefined: heights, skewness and curvature are cut"},
        {effect("clipped_share", "", share, "1"), effect("clipped_height", "", height, "m"),
         effect_count("clipped_points", count)}};
}

}  // namespace

Found quantised(const Evidence& evidence, parallel::Threads threads) {
    if (evidence.flat)
        return Finding{
            {"QUANTISED", evidence.subject,
             fmt::format("all {} defined heights are equal: nothing of a surface is in them", evidence.defined),
             "look whether the right channel was read and the instrument was in contact"},
            {effect("rms_height", "h_rms", 0.0, "m")}};
    const double share = plateau_share(evidence.map->heights, threads);
    constexpr double many_plateaus = 0.05;
    constexpr Index fewest_heights = 64;
    if (evidence.defined < fewest_heights || !(share > many_plateaus)) return {};
    const auto levels = all_levels(evidence.map->heights);
    if (levels.size() < 3 || 2 * std::ssize(levels) > evidence.defined) return {};
    const auto step = common_step(levels);
    if (!step) return {};
    const double rms = evidence.rms_level, error = *step / std::sqrt(12.0);
    const double slope = rms_slope_along_x(evidence.level->heights, evidence.map->pixel_size()[0]);
    // rounding errors of neighbours are independent where heights differ by more than a step, and equal on plateaus
    return Finding{
        {"QUANTISED", evidence.subject,
         fmt::format(
             "heights come in steps of {} ({:.2g} of the rms height); {:.2g} % of neighbours have the same one, and rounding adds {} to rms height",
             length_text(*step), *step / rms, 100.0 * share, length_text(error)),
         "read the file's finer channel or measure with a smaller range; slope and curvature at the scale of pixels are those of steps"},
        {effect("height_step", "", *step, "m"), effect("height_step_over_rms_height", "", *step / rms, "1"),
         effect("plateau_share", "", share, "1"), effect("rounding_rms_height", "", error, "m"),
         effect("rms_slope_x_as_measured", "h'_rms", slope, "1")}};
}

std::vector<Finding> clipped(const Evidence& evidence, parallel::Threads threads) {
    std::vector<Finding> found;
    for (const bool top : {true, false})
        if (auto finding = clipped_at(evidence, top, threads)) found.push_back(std::move(*finding));
    return found;
}

}  // namespace setae::diagnostics
