// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/contact_line/line_motion.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact_line {
namespace {

/// ln of positive numbers, in increasing order.
std::vector<double> sorted_logarithms(const ArrayView1D& values) {
    std::vector<double> logarithms;
    for (const double x : values)
        if (x > 0.0 && std::isfinite(x)) logarithms.push_back(std::log(x));
    std::sort(logarithms.begin(), logarithms.end());
    return logarithms;
}

/// Largest difference of the two distributions of the numbers from `first` on; slope: τ − 1.
double distance_from_law(const std::vector<double>& logarithms, std::size_t first, double slope) {
    const auto n = static_cast<double>(logarithms.size() - first);
    double largest = 0.0;
    for (std::size_t i = first; i < logarithms.size(); ++i) {
        const double law = -std::expm1(-slope * (logarithms[i] - logarithms[first])),
                     rank = static_cast<double>(i - first);
        largest = std::max({largest, std::abs(law - rank / n), std::abs(law - (rank + 1.0) / n)});
    }
    return largest;
}

constexpr std::size_t max_starts = 400;

}  // namespace

PowerLawTail power_law_tail(const ArrayView1D& values, Index fewest) {
    if (fewest < 5) throw InvalidArgument(fmt::format("a tail of at least {} numbers; expected 5 or more", fewest));
    const auto logarithms = sorted_logarithms(values);
    const auto least = static_cast<std::size_t>(fewest);
    if (logarithms.size() < least)
        throw UndefinedDataError(fmt::format("{} numbers; a tail needs at least {}", logarithms.size(), least));
    std::vector<double> sum_above(logarithms.size() + 1, 0.0);
    for (std::size_t i = logarithms.size(); i-- > 0;) sum_above[i] = sum_above[i + 1] + logarithms[i];
    PowerLawTail best;
    best.distance = 2.0;
    const std::size_t starts = logarithms.size() - least + 1, stride = std::max<std::size_t>(1, starts / max_starts);
    for (std::size_t first = 0; first < starts; first += stride) {
        const auto count = static_cast<double>(logarithms.size() - first);
        const double excess = sum_above[first] - count * logarithms[first];
        if (!(excess > 0.0)) continue;
        const double slope = (count - 2.0) / excess, distance = distance_from_law(logarithms, first, slope);
        if (distance >= best.distance) continue;
        best = {.exponent = {1.0 + slope, slope / std::sqrt(count - 3.0), "likelihood"},
                .smallest = std::exp(logarithms[first]),
                .count = static_cast<Index>(count),
                .distance = distance};
    }
    if (best.count == 0)
        throw UndefinedDataError(fmt::format("{} numbers are all equal to {:.6g}, so that they have no tail",
                                             logarithms.size(), std::exp(logarithms.front())));
    return best;
}

}  // namespace setae::contact_line
