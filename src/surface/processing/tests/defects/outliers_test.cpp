// SPDX-License-Identifier: GPL-3.0-or-later
#include "defects/outliers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"

namespace setae::processing::outliers_test {
namespace {

constexpr Index columns = 400;

ComputedRows rows_of(const Array1D& values, std::atomic<Index>& loads) {
    return {values.size() / columns, columns,
            [&](Index i, double* row) {
                ++loads;
                std::copy_n(values.data() + i * columns, columns, row);
            },
            [&](Index i, Index j) { return values[i * columns + j]; }};
}

/// The definition of outliers, by sorting.
double deviation_by_sorting(const Array1D& values) {
    std::vector<double> sorted;
    for (const double value : values)
        if (!std::isnan(value)) sorted.push_back(std::fabs(value));
    std::sort(sorted.begin(), sorted.end());
    for (const double p : {0.5, 0.9, 0.99}) {
        const double order = p * static_cast<double>(sorted.size() - 1), share = order - std::floor(order);
        const auto below = static_cast<std::size_t>(order);
        const double quantile =
            share > 0.0 ? sorted[below] + share * (sorted[below + 1] - sorted[below]) : sorted[below];
        if (quantile > 0.0) return quantile / normal_quantile(0.5 + 0.5 * p);
    }
    return 0.0;
}

/// Normal numbers of which a share is 0; every thousandth is 20 times as large.
Array1D numbers(Index n, double zeros) {
    std::mt19937_64 engine(4);
    std::normal_distribution<double> normal;
    Array1D values = Array1D::NullaryExpr(n, [&] {
        const double value = normal(engine);
        return static_cast<double>(engine() % 100'000) < 1e5 * zeros ? 0.0 : value;
    });
    for (Index k = 0; k < n; k += 1000) values[k] *= 20.0;
    return values;
}

void expect_by_definition(const Array1D& values) {
    std::atomic<Index> loads = 0;
    for (const int threads : {1, 3}) {
        const auto found = find_outliers(rows_of(values, loads), 6.0, {threads});
        const double deviation = deviation_by_sorting(values);
        EXPECT_EQ(found.deviation, deviation);
        std::size_t next = 0;
        for (Index k = 0; k < values.size(); ++k) {
            if (!(std::fabs(values[k]) > 6.0 * deviation)) continue;
            ASSERT_LT(next, found.points.size());
            EXPECT_EQ(found.points[next].point, k);
            EXPECT_EQ(found.points[next].difference, values[k]);
            ++next;
        }
        EXPECT_EQ(next, found.points.size());
    }
}

TEST(Outliers, MatchTheDefinition) {
    for (const Index n : {10 * columns, 500 * columns}) {
        expect_by_definition(numbers(n, 0.0));
        Array1D with_gaps = numbers(n, 0.1);
        for (Index k = 0; k < n; k += 3) with_gaps[k] = undefined;
        expect_by_definition(with_gaps);
    }
}

TEST(Outliers, MatchTheDefinitionIfTheMajorityIsZero) {
    for (const Index n : {10 * columns, 500 * columns})
        for (const double zeros : {0.49, 0.5, 0.51, 0.7, 0.899, 0.9, 0.901, 0.97, 0.99, 0.995, 1.0})
            expect_by_definition(numbers(n, zeros));
}

TEST(Outliers, AreEmptyWithoutDefinedNumbers) {
    std::atomic<Index> loads = 0;
    const Array1D values = Array1D::Constant(500 * columns, undefined);
    const auto found = find_outliers(rows_of(values, loads), 6.0, {});
    EXPECT_EQ(found.deviation, 0.0);
    EXPECT_TRUE(found.points.empty());
}

TEST(Outliers, LoadEveryRowOnce) {
    for (const Index rows : {Index{200}, Index{2000}}) {
        const Array1D values = numbers(rows * columns, 0.0);
        std::atomic<Index> loads = 0;
        EXPECT_GT(find_outliers(rows_of(values, loads), 6.0, {2}).deviation, 0.0);
        EXPECT_EQ(loads, rows);
    }
}

}  // namespace
}  // namespace setae::processing::outliers_test
