// SPDX-License-Identifier: GPL-3.0-or-later
#include "order_statistic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "setae/core/constants.hpp"

namespace setae::processing::order_statistic_test {
namespace {

/// Enough numbers that a sample of them is taken.
constexpr Index many = 150'000;

/// Compares ranks near the ends and in between with those of the sorted numbers.
void expect_sorted_ranks(const Array1D& values, bool absolute) {
    std::vector<double> sorted;
    for (const double value : values)
        if (value == value) sorted.push_back(absolute ? std::fabs(value) : value);
    std::sort(sorted.begin(), sorted.end());
    const auto n = std::ssize(sorted);
    for (const int threads : {1, 3}) {
        const OrderStatistics statistics(values.data(), values.size(), absolute, {threads});
        ASSERT_EQ(statistics.defined(), n);
        for (const Index rank : {Index{0}, Index{1}, n / 100, n / 2, n / 2 + 1, 9 * n / 10, n - 2, n - 1})
            EXPECT_EQ(statistics.at(rank), sorted[static_cast<std::size_t>(rank)]) << "rank " << rank;
        const double order = 0.37 * static_cast<double>(n - 1);
        const auto below = static_cast<std::size_t>(order);
        EXPECT_EQ(statistics.quantile(0.37),
                  sorted[below] + (order - std::floor(order)) * (sorted[below + 1] - sorted[below]));
    }
}

TEST(OrderStatistics, OfManyNumbersAreThoseOfTheSortedOnes) {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal(0.0, 1e-9);
    Array1D values = Array1D::NullaryExpr(many, [&] { return normal(engine); });
    for (Index k = 0; k < many; k += 7) values[k] = undefined;
    expect_sorted_ranks(values, false);
    expect_sorted_ranks(values, true);
}

TEST(OrderStatistics, OfFewLevelsAreThoseOfTheSortedOnes) {
    std::mt19937_64 engine(2);
    std::normal_distribution<double> normal(0.0, 3.0);
    expect_sorted_ranks(Array1D::NullaryExpr(many, [&] { return std::round(normal(engine)); }), false);
    expect_sorted_ranks(Array1D::Constant(many, 4.0), false);
}

TEST(OrderStatistics, OfAFieldThatRepeatsAreThoseOfTheSortedOnes) {
    expect_sorted_ranks(
        Array1D::NullaryExpr(many, [](Index k) { return std::sin(0.001 * static_cast<double>(k % 512)); }), false);
    expect_sorted_ranks(Array1D::LinSpaced(many, -1.0, 2.0), true);
}

}  // namespace
}  // namespace setae::processing::order_statistic_test
