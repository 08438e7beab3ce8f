// SPDX-License-Identifier: GPL-3.0-or-later
#include "order_statistic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <vector>

#include "setae/core/constants.hpp"

namespace setae::processing::order_statistic_test {
namespace {

/// Enough numbers for a sample.
constexpr Index columns = 300, rows = 500, many = rows * columns;

ComputedRows rows_of(const Array1D& values) {
    const Index n = values.size() / columns;
    return {n, columns, [&](Index i, double* row) { std::copy_n(values.data() + i * columns, columns, row); },
            [&](Index i, Index j) { return values[i * columns + j]; }};
}

/// Type 7 of Hyndman and Fan, by sorting.
double sorted_quantile(const Array1D& values, double probability) {
    std::vector<double> sorted;
    for (const double value : values)
        if (!std::isnan(value)) sorted.push_back(value);
    std::sort(sorted.begin(), sorted.end());
    const double order = probability * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(order);
    const double share = order - std::floor(order);
    return share > 0.0 ? sorted[below] + share * (sorted[below + 1] - sorted[below]) : sorted[below];
}

void expect_sorted_quantiles(const Array1D& values) {
    for (const int threads : {1, 3})
        for (const double probability : {0.0, 1e-5, 0.01, 0.37, 0.5, 0.9, 0.99, 1.0})
            EXPECT_EQ(quantile(rows_of(values), probability, {threads}), sorted_quantile(values, probability))
                << probability;
}

TEST(Quantile, OfManyNumbersMatchesSorting) {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal(0.0, 1e-9);
    Array1D values = Array1D::NullaryExpr(many, [&] { return normal(engine); });
    for (Index k = 0; k < many; k += 7) values[k] = undefined;
    expect_sorted_quantiles(values);
    expect_sorted_quantiles(values.abs());
    expect_sorted_quantiles(values.head(4 * columns));
}

TEST(Quantile, OfFewLevelsMatchesSorting) {
    std::mt19937_64 engine(2);
    std::normal_distribution<double> normal(0.0, 3.0);
    expect_sorted_quantiles(Array1D::NullaryExpr(many, [&] { return std::round(normal(engine)); }));
    expect_sorted_quantiles(Array1D::Constant(many, 4.0));
}

TEST(Quantile, OfAPeriodicFieldMatchesSorting) {
    expect_sorted_quantiles(
        Array1D::NullaryExpr(many, [](Index k) { return std::sin(0.001 * static_cast<double>(k % 512)); }));
    expect_sorted_quantiles(Array1D::LinSpaced(many, -1.0, 2.0));
}

/// A sample without the quantile: all numbers outside the sample are larger.
TEST(Quantile, OutsideItsSampleMatchesSorting) {
    Array1D values = Array1D::LinSpaced(many, 1.0, 2.0);
    std::vector<Index> places;
    auto seen = rows_of(values);
    seen.at = [&](Index i, Index j) { return places.push_back(i * columns + j), values[i * columns + j]; };
    const Sample sample(seen);
    for (const Index place : places) values[place] = -1.0;
    expect_sorted_quantiles(values);
}

TEST(Quantile, OfNoDefinedNumberIsUndefined) {
    EXPECT_FALSE(quantile(rows_of(Array1D::Constant(many, undefined)), 0.5));
    EXPECT_FALSE(quantile(rows_of(Array1D(0)), 0.5));
}

TEST(Quantile, LoadsEveryRowOnce) {
    std::mt19937_64 engine(3);
    std::normal_distribution<double> normal;
    for (const Index n : {Index{50}, Index{500}, Index{5000}}) {
        const Array1D values = Array1D::NullaryExpr(n * columns, [&] { return normal(engine); });
        std::atomic<Index> loads = 0;
        auto counted = rows_of(values);
        counted.load = [&, load = counted.load](Index i, double* row) {
            ++loads;
            load(i, row);
        };
        ASSERT_TRUE(quantile(counted, 0.5, {2}));
        EXPECT_EQ(loads, n);
    }
}

}  // namespace
}  // namespace setae::processing::order_statistic_test
