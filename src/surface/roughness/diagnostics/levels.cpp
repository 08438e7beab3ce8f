// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "evidence.hpp"
#include "level_list.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::diagnostics {
namespace {

/// Share of neighbours along x with equal height.
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
                                                            counts.pairs += !std::isnan(rise);
                                                            counts.same += rise == 0.0;
                                                        }
                                                    })) {
        same += part.same;
        pairs += part.pairs;
    }
    return pairs > 0 ? static_cast<double>(same) / static_cast<double>(pairs) : 0.0;
}

/// The common divisor of all differences of levels, or empty: the median of the smallest quarter of gaps, refined by
/// all.
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

/// Number of levels compared with the last one.
constexpr std::size_t levels_compared = 5;

Found clipped_at(const Evidence& evidence, const std::vector<Level>& levels, bool top) {
    const auto at = [&](std::size_t k) { return top ? levels[levels.size() - 1 - k] : levels[k]; };
    if (levels.size() <= 2 * levels_compared) return {};
    double mean_count = 0.0;
    for (std::size_t k = 1; k <= levels_compared; ++k)
        mean_count += static_cast<double>(at(k).count) / static_cast<double>(levels_compared);
    const auto [height, count] = at(0);
    // tails become thinner towards their ends: a last level with more points than those before it is a limit
    if (count < 5 || static_cast<double>(count) < 3.0 * mean_count) return {};
    const double share = static_cast<double>(count) / static_cast<double>(evidence.defined);
    const char* end = top ? "highest" : "lowest";
    return Finding{
        {"CLIPPED", evidence.subject,
         fmt::format("{} of {} points ({:.2g} %) have exactly the {} height, as at the end of the range of an "
                     "instrument or a file",
                     count, evidence.defined, 100.0 * share, end),
         "measure again with a larger range, or mark these points as undefined: heights, skewness and "
         "curvature are truncated"},
        {effect("clipped_share", "", share, "1"), effect("clipped_height", "", height, "m"),
         effect_count("clipped_points", count)}};
}

std::vector<Finding> clipped(const Evidence& evidence, parallel::Threads threads) {
    const auto ends = end_levels(evidence, 2 * levels_compared + 1, threads);
    std::vector<Finding> found;
    if (auto finding = clipped_at(evidence, ends.highest, true)) found.push_back(std::move(*finding));
    if (auto finding = clipped_at(evidence, ends.lowest, false)) found.push_back(std::move(*finding));
    return found;
}

std::optional<Digitised> digitised(const Evidence& evidence, parallel::Threads threads) {
    const double share = plateau_share(evidence.map->heights, threads);
    constexpr double many_plateaus = 0.05;
    constexpr Index min_heights = 64;
    if (evidence.defined < min_heights || !(share > many_plateaus)) return {};
    const auto levels = all_levels(evidence);
    if (levels.size() < 3 || 2 * std::ssize(levels) > evidence.defined) return {};
    const auto step = common_step(levels);
    if (!step) return {};
    return Digitised{*step, share};
}

}  // namespace

Found constant_heights(const Evidence& evidence) {
    return Finding{{"QUANTISED", evidence.subject,
                    fmt::format("all {} defined heights are equal and contain no surface", evidence.defined),
                    "check that the right channel was read and that the instrument was in contact"},
                   {effect("rms_height", "h_rms", 0.0, "m")}};
}

Levels levels_of(const Evidence& evidence, parallel::Threads threads) {
    return {clipped(evidence, threads), digitised(evidence, threads)};
}

Found quantised(const Evidence& evidence, const Digitised& digitised) {
    const auto& [step, share] = digitised;
    const double rms = evidence.form.rms_level, error = step / std::sqrt(12.0);
    const double slope = rms_slope_along_x(evidence.heights.heights, evidence.map->pixel_size()[0]);
    // rounding errors of neighbours are independent if heights differ by more than a step, and equal on plateaus
    return Finding{
        {"QUANTISED", evidence.subject,
         fmt::format("heights are multiples of {} ({:.2g} of the rms height); {:.2g} % of neighbouring points have "
                     "equal heights, and rounding adds {} to the rms height",
                     length_text(step), step / rms, 100.0 * share, length_text(error)),
         "read a finer channel of the file, or measure with a smaller range; slope and curvature at the "
         "scale of pixels are those of the steps"},
        {effect("height_step", "", step, "m"), effect("height_step_over_rms_height", "", step / rms, "1"),
         effect("plateau_share", "", share, "1"), effect("rounding_rms_height", "", error, "m"),
         effect("rms_slope_x_as_measured", "h'_rms", slope, "1")}};
}

}  // namespace setae::diagnostics
