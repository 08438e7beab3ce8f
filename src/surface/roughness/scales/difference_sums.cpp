// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace setae::scales {
namespace {

constexpr Index lanes = 4;

struct Lanes {
    double count[lanes] = {}, p1[lanes] = {}, p2[lanes] = {}, p3[lanes] = {}, p4[lanes] = {}, low[lanes], high[lanes];
    Lanes() {
        std::fill(low, low + lanes, std::numeric_limits<double>::infinity());
        std::fill(high, high + lanes, -std::numeric_limits<double>::infinity());
    }
};

template <bool checked>
void add_value(double value, double origin, Index lane, Lanes& sums) {
    const bool use = !checked || !std::isnan(value);
    const double d = use ? value - origin : 0.0, square = d * d;
    if constexpr (checked) sums.count[lane] += use ? 1.0 : 0.0;
    sums.p1[lane] += d;
    sums.p2[lane] += square;
    sums.p3[lane] += square * d;
    sums.p4[lane] += square * square;
    const double low = use ? value : sums.low[lane], high = use ? value : sums.high[lane];
    sums.low[lane] = low < sums.low[lane] ? low : sums.low[lane];
    sums.high[lane] = high > sums.high[lane] ? high : sums.high[lane];
}

template <bool checked>
Lanes sums_of(const double* values, Index n, double origin) {
    Lanes sums;
    Index j = 0;
    for (; j + lanes <= n; j += lanes)
        for (Index lane = 0; lane < lanes; ++lane) add_value<checked>(values[j + lane], origin, lane, sums);
    for (; j < n; ++j) add_value<checked>(values[j], origin, j % lanes, sums);
    return sums;
}

double total(const double* v) { return (v[0] + v[1]) + (v[2] + v[3]); }

}  // namespace

DifferenceSums::DifferenceSums()
    : minimum(std::numeric_limits<double>::infinity()), maximum(-std::numeric_limits<double>::infinity()) {}

void DifferenceSums::add(const DifferenceSums& other) {
    count += other.count;
    for (int k = 0; k < 4; ++k) powers[k] += other.powers[k];
    minimum = std::min(minimum, other.minimum);
    maximum = std::max(maximum, other.maximum);
}

void DifferenceSums::add(const double* values, Index n, double origin) {
    auto sums = sums_of<false>(values, n, origin);
    double added = static_cast<double>(n);
    const double quick = total(sums.p1);
    if (std::isnan(quick)) {
        sums = sums_of<true>(values, n, origin);
        added = total(sums.count);
    }
    count += added;
    powers[0] += total(sums.p1);
    powers[1] += total(sums.p2);
    powers[2] += total(sums.p3);
    powers[3] += total(sums.p4);
    minimum = std::min({minimum, sums.low[0], sums.low[1], sums.low[2], sums.low[3]});
    maximum = std::max({maximum, sums.high[0], sums.high[1], sums.high[2], sums.high[3]});
}

}  // namespace setae::scales
