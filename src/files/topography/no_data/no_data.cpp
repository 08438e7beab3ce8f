// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/no_data.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "height_sample.hpp"
#include "setae/core/constants.hpp"
#include "usual_mark.hpp"
#include "value_facts.hpp"

namespace setae::topography {
namespace {

constexpr std::size_t min_levels = 8;                                       ///< different values of real heights
constexpr double isolated_at = 8.0;                                         ///< spreads from the median
constexpr double far_at = 20.0, single_far_at = 100.0, absurd_at = 1000.0;  ///< largest distances of the others
constexpr double gap_share = 0.25;  ///< of the distance from the median, without other heights
constexpr double jump_steps = 8.0, min_adjacent_steps = 5.0;
constexpr double irregular_at = 0.5;  ///< scatter of lengths over their mean
constexpr double largest_share = 0.5;

/// A value in a sample, and its frequency.
struct SampleLevel {
    double value;
    std::size_t count;
};

std::vector<SampleLevel> levels_of(std::vector<double> sorted) {
    std::sort(sorted.begin(), sorted.end());
    std::vector<SampleLevel> levels;
    for (const double value : sorted) {
        if (levels.empty() || value != levels.back().value) levels.push_back({value, 0});
        ++levels.back().count;
    }
    return levels;
}

/// Values that are much more frequent in the sample than others.
std::vector<double> dominant_values(const std::vector<SampleLevel>& levels) {
    constexpr std::size_t max_marks = 4, fewest = 8, times = 10, min_among_unequal = 5;
    if (levels.size() < min_levels + max_marks) return {};
    std::vector<std::size_t> counts;
    for (const auto& level : levels) counts.push_back(level.count);
    std::nth_element(counts.begin(), counts.begin() + max_marks, counts.end(), std::greater<>());
    const auto usual = counts[max_marks];
    std::vector<double> values;
    const auto enough = usual == 1 ? min_among_unequal : std::max(fewest, times * usual);
    for (const auto& level : levels)
        if (level.count >= enough) values.push_back(level.value);
    return values;
}

/// Distribution of the heights without some values.
struct Others {
    double median = 0.0, spread = 0.0;
    double step = 0.0;  ///< usual one between neighbours along scan lines
};

double quantile(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

/// Empty if they have too few different values for a distribution.
std::optional<Others> others_in(const HeightSample& sample, const std::vector<double>& values) {
    const auto is_value = [&](double h) { return std::find(values.begin(), values.end(), h) != values.end(); };
    std::vector<double> heights, steps;
    for (const auto& [height, next] : sample.heights) {
        if (is_value(height)) continue;
        heights.push_back(height);
        if (!std::isnan(next) && !is_value(next)) steps.push_back(std::abs(next - height));
    }
    std::sort(heights.begin(), heights.end());
    std::size_t levels = heights.empty() ? 0 : 1;
    for (std::size_t i = 1; i < heights.size(); ++i) levels += heights[i] != heights[i - 1];
    if (levels < min_levels) return std::nullopt;
    Others others{quantile(heights, 0.5), 0.5 * (quantile(heights, 0.84) - quantile(heights, 0.16)), 0.0};
    if (!(others.spread > 0.0)) others.spread = 0.25 * (quantile(heights, 0.98) - quantile(heights, 0.02));
    if (!(others.spread > 0.0)) return std::nullopt;
    std::sort(steps.begin(), steps.end());
    if (!steps.empty()) others.step = quantile(steps, 0.5);
    if (!(others.step > 0.0))
        for (const double step : steps) others.step += step / static_cast<double>(steps.size());
    return others;
}

/// Whether lengths along scan lines are random, with enough of them to decide; or few single points.
bool irregular(const ValueFacts& facts, double share) {
    constexpr Index min_runs = 6;
    constexpr double single_points = 2.0, share_of_single_points = 0.05;
    if (facts.runs.count() >= min_runs && facts.runs.mean() <= single_points && share <= share_of_single_points)
        return true;
    const auto scatter = [](const Scatter& lengths) {
        return lengths.count() >= min_runs && lengths.standard_deviation() >= irregular_at * lengths.mean();
    };
    return scatter(facts.runs) || scatter(facts.gaps);
}

/// Data on a value for the decision.
struct Evidence {
    double value, distance, reach, share;
    bool isolated, dominant, usual_mark;
    bool within;  ///< others lie on both sides
    const ValueFacts& facts;
    const Others& others;
};

bool is_no_height(const Evidence& e) {
    const auto count = e.facts.count;
    if (e.distance >= absurd_at * e.reach) return true;
    if (e.isolated && e.usual_mark && (count >= 2 || e.distance >= far_at * e.reach)) return true;
    if (e.share > largest_share || !irregular(e.facts, e.share)) return false;
    if (e.isolated && count >= 5) return true;
    const bool jumps = 10 * e.facts.jumps >= 9 * e.facts.steps;
    const bool others_vary = e.facts.adjacent.standard_deviation() >= min_adjacent_steps * e.others.step;
    return e.dominant && (e.within || e.usual_mark) && count >= 10 && jumps && others_vary;
}

bool is_suspect(const Evidence& e) {
    if (e.isolated && e.facts.count >= 3) return true;
    if (e.distance >= (e.facts.count > 1 || e.usual_mark ? far_at : single_far_at) * e.reach) return true;
    // a plateau has heights near its own next to it
    const double adjacent = std::hypot(e.facts.adjacent.mean() - e.value, e.facts.adjacent.standard_deviation());
    return e.dominant && e.within && (e.facts.steps == 0 || adjacent >= 0.5 * e.others.spread);
}

/// The extremes of the remaining heights that are far enough out to be tested.
std::vector<double> far_extremes(double least, double greatest, const Others& others) {
    std::vector<double> found;
    for (const double end : {least, greatest})
        if (std::isfinite(end) && std::abs(end - others.median) >= isolated_at * others.spread) found.push_back(end);
    return found;
}

NoDataReport search(const HeightBands& bands, const NoDataHints& hints) {
    constexpr int max_rounds = 6;
    const auto sample = sampled(bands);
    NoDataReport report;
    report.least = sample.least;
    report.greatest = sample.greatest;
    std::vector<double> heights;
    for (const auto& point : sample.heights) heights.push_back(point.height);
    const auto dominant = dominant_values(levels_of(std::move(heights)));
    auto values = dominant;
    auto others = others_in(sample, values);
    if (!others) return report;
    AllFacts all{{}, 0, sample.least, sample.greatest};
    for (int round = 0; round < max_rounds; ++round) {
        auto further = far_extremes(all.least, all.greatest, *others);
        std::erase_if(further, [&](double v) { return std::find(values.begin(), values.end(), v) != values.end(); });
        if (further.empty() && (round > 0 || values.empty())) break;
        values.insert(values.end(), further.begin(), further.end());
        const auto without = others_in(sample, values);
        if (!without) return report;
        others = without;
        all = facts_of(bands, values, others->median, jump_steps * others->step);
        // a tail of single heights is no marker
        const bool single = std::all_of(further.begin(), further.end(), [&](double v) {
            const auto at = static_cast<std::size_t>(std::find(values.begin(), values.end(), v) - values.begin());
            return all.values[at].count < 2;
        });
        if (!further.empty() && single) break;
    }
    if (values.empty()) return report;
    const double reach = std::max(others->median - all.least, all.greatest - others->median);
    report.defined = all.defined;
    report.least = all.least;
    report.greatest = all.greatest;
    for (std::size_t v = 0; v < values.size(); ++v) {
        const auto& facts = all.values[v];
        const double distance = std::abs(values[v] - others->median);
        const bool in_codes = std::find(hints.codes.begin(), hints.codes.end(), values[v]) != hints.codes.end();
        const bool dominates = std::find(dominant.begin(), dominant.end(), values[v]) != dominant.end();
        const bool far_out = distance >= isolated_at * others->spread && 20 * facts.beyond <= facts.count;
        const Evidence evidence{.value = values[v],
                                .distance = distance,
                                .reach = reach,
                                .share = static_cast<double>(facts.count) / static_cast<double>(all.defined),
                                .isolated = (dominates || far_out) && facts.nearest >= gap_share * distance,
                                .dominant = dominates,
                                .usual_mark = in_codes || is_usual_mark(values[v] / hints.unit),
                                .within = values[v] > all.least && values[v] < all.greatest,
                                .facts = facts,
                                .others = *others};
        const bool no_height = is_no_height(evidence);
        if (no_height || is_suspect(evidence)) report.values.push_back({values[v], facts.count, no_height});
    }
    std::sort(report.values.begin(), report.values.end(),
              [](const NoDataValue& a, const NoDataValue& b) { return a.value < b.value; });
    return report;
}

void undefine(double* heights, Index n, const NoDataReport& report) {
    for (const auto& mark : report.values)
        if (mark.no_height)
            for (Index i = 0; i < n; ++i)
                if (heights[i] == mark.value) heights[i] = undefined;
}

}  // namespace

bool NoDataReport::any_undefined() const {
    return std::any_of(values.begin(), values.end(), [](const NoDataValue& mark) { return mark.no_height; });
}

NoDataReport find_no_data(const Measurement& measurement, const NoDataHints& hints, parallel::Threads threads) {
    return search(bands_of(measurement, threads), hints);
}

NoDataReport find_no_data(const TiledMap& map, const NoDataHints& hints) { return search(bands_of(map), hints); }

void undefine(Measurement& measurement, const NoDataReport& report) {
    std::visit([&](auto& m) { undefine(m.heights.data(), m.heights.size(), report); }, measurement);
}

void undefine(Array2D& heights, const NoDataReport& report) { undefine(heights.data(), heights.size(), report); }

}  // namespace setae::topography
