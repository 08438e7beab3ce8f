// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/summary.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::validation {
namespace {

using Members = std::vector<const Comparison*>;

/// Standard error of the mean deviation; shared inputs of one run (an elastomer, a fitted W) correlate its members.
double error_of_mean(const Members& members, double mean) {
    std::map<int, double> sums;
    for (const auto* m : members) sums[m->run] += m->deviation() - mean;
    const auto runs = static_cast<double>(sums.size()), count = static_cast<double>(members.size());
    if (sums.size() < 2) return undefined;
    double squares = 0.0;
    for (const auto& [run, sum] : sums) squares += sum * sum;
    return std::sqrt(squares * runs / (runs - 1.0)) / count;
}

/// Number of independent comparisons with the same scatter of the share of hits; comparisons of one run share values.
/// It is the number of runs where all hit, or none, because the scatter is undefined then.
double independent_of(const Members& members, double share) {
    std::map<int, double> sums;
    for (const auto* m : members) sums[m->run] += (m->covered() ? 1.0 : 0.0) - share;
    const auto runs = static_cast<double>(sums.size()), count = static_cast<double>(members.size());
    const double alone = count * share * (1.0 - share);
    if (!(alone > 0.0) || sums.size() < 2) return runs;
    double squares = 0.0;
    for (const auto& [run, sum] : sums) squares += sum * sum;
    return count / std::max(1.0, squares * runs / (runs - 1.0) / alone);
}

SummaryRow row_of(const Members& members) {
    const auto& first = *members.front();
    SummaryRow row{first.quantity, first.method, first.unit, first.measure, static_cast<int>(members.size())};
    const auto count = static_cast<double>(members.size());
    double squares = 0.0, stated = 0.0;
    int hits = 0, with_interval = 0;
    for (const auto* m : members) {
        const double deviation = m->deviation();
        row.bias += deviation / count;
        squares += deviation * deviation;
        if (std::abs(deviation) > std::abs(row.worst)) row.worst = deviation;
        hits += m->covered() ? 1 : 0;
        if (const double s = m->stated_deviation(); std::isfinite(s)) {
            stated += s;
            ++with_interval;
        }
    }
    row.scatter = members.size() > 1 ? std::sqrt(std::max(0.0, squares - count * row.bias * row.bias) / (count - 1.0))
                                     : undefined;
    row.bias_error = error_of_mean(members, row.bias);
    row.stated = with_interval > 0 ? stated / with_interval : undefined;
    row.coverage = hits / count;
    row.coverage_interval = share_interval(row.coverage, independent_of(members, row.coverage));
    return row;
}

}  // namespace

std::vector<SummaryRow> summary(const std::vector<Comparison>& comparisons) {
    std::vector<Members> groups;
    for (const auto& c : comparisons) {
        const auto place = std::find_if(groups.begin(), groups.end(), [&](const Members& g) {
            return g.front()->quantity == c.quantity && g.front()->method == c.method;
        });
        if (place == groups.end()) groups.push_back({&c});
        else place->push_back(&c);
    }
    std::vector<SummaryRow> rows;
    for (const auto& group : groups) rows.push_back(row_of(group));
    return rows;
}

Interval share_interval(int hits, int count, double level) {
    if (count < 1 || hits < 0 || hits > count)
        throw InvalidArgument(fmt::format("{} of {}; expected a share of at least one", hits, count));
    return share_interval(static_cast<double>(hits) / count, static_cast<double>(count), level);
}

Interval share_interval(double share, double n, double level) {
    const double z = normal_quantile(0.5 * (1.0 + level)), width = z * z / n;
    const double centre = (share + 0.5 * width) / (1.0 + width);
    const double half = z * std::sqrt(share * (1.0 - share) / n + 0.25 * width / n) / (1.0 + width);
    return {std::max(0.0, centre - half), std::min(1.0, centre + half), level};
}

}  // namespace setae::validation
