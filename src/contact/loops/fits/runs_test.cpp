// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/runs_test.hpp"

#include <algorithm>
#include <cmath>

#include "setae/core/log_gamma.hpp"
#include "setae/core/statistics.hpp"

namespace setae::loops {
namespace {

double log_binomial(Index n, Index k) {
    return log_gamma(static_cast<double>(n) + 1.0) - log_gamma(static_cast<double>(k) + 1.0) -
           log_gamma(static_cast<double>(n - k) + 1.0);
}

/// P(R = runs): m signs of one kind can be divided into k runs in C(m − 1, k − 1) ways.
double probability(Index runs, Index above, Index below) {
    const double all = log_binomial(above + below, above);
    const auto ways = [&](Index of_above, Index of_below) {
        if (of_above > above || of_below > below) return 0.0;
        return std::exp(log_binomial(above - 1, of_above - 1) + log_binomial(below - 1, of_below - 1) - all);
    };
    const Index half = runs / 2;
    return runs % 2 == 0 ? 2.0 * ways(half, half) : ways(half, half + 1) + ways(half + 1, half);
}

double as_few_or_fewer(const RunsTest& test) {
    constexpr Index max_exact = 50;
    if (test.above + test.below <= max_exact) {
        double sum = 0.0;
        for (Index runs = 2; runs <= test.runs; ++runs) sum += probability(runs, test.above, test.below);
        return std::min(sum, 1.0);
    }
    const double m = static_cast<double>(test.above), n = static_cast<double>(test.below), twice = 2.0 * m * n,
                 all = m + n;
    const double mean = twice / all + 1.0, variance = twice * (twice - all) / (all * all * (all - 1.0));
    return normal_probability((static_cast<double>(test.runs) + 0.5 - mean) / std::sqrt(variance));
}

}  // namespace

RunsTest runs_test(const ArrayView1D& residuals) {
    RunsTest test;
    double last = 0.0;
    for (Index i = 0; i < residuals.size(); ++i) {
        const double value = residuals[i];
        if (!(value != 0.0)) continue;
        if (!(value * last > 0.0)) ++test.runs;
        ++(value > 0.0 ? test.above : test.below);
        last = value > 0.0 ? 1.0 : -1.0;
    }
    if (test.above > 0 && test.below > 0) test.p_value = as_few_or_fewer(test);
    return test;
}

}  // namespace setae::loops
