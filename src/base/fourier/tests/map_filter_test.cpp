// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/map_filter.hpp"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::fourier::map_filter_test {
namespace {

/// Kernel at a distance, even, on a grid of these periods.
double kernel(Index dx, Index dy) {
    return std::exp(-0.3 * std::abs(static_cast<double>(dx)) - 0.2 * std::abs(static_cast<double>(dy)));
}

Index folded(Index d, Index period) { return d > period / 2 ? d - period : d; }

/// The transform of the kernel, by direct sums.
double transform(Index k, Index m, Index px, Index py) {
    double sum = 0.0;
    for (Index i = 0; i < px; ++i)
        for (Index j = 0; j < py; ++j)
            sum += kernel(folded(i, px), folded(j, py)) *
                   std::cos(2.0 * pi * static_cast<double>(k * i) / static_cast<double>(px)) *
                   std::cos(2.0 * pi * static_cast<double>(m * j) / static_cast<double>(py));
    return sum;
}

struct Case {
    Index nx, ny, px, py;
};

class Filtered : public ::testing::TestWithParam<Case> {};

/// y and Σ x y of a map, by transforms of Real.
template <class Real>
std::pair<Array2D, double> filtered(const Case& sides, const Array2D& x) {
    using Line = Eigen::Map<Eigen::Array<Real, Eigen::Dynamic, 1>>;
    using ConstLine = Eigen::Map<const Eigen::Array<Real, Eigen::Dynamic, 1>>;
    const auto [nx, ny, px, py] = sides;
    MapFilterOf<Real> filter(nx, ny, px, py);
    const auto T = filter.multiplier([&](Index k, Index m) { return transform(k, m, px, py); });
    Array2D y(nx, ny);
    const LoadRowOf<Real> load = [&](Index i, Real* line) {
        Line(line, ny) = x.row(i).transpose().template cast<Real>();
    };
    filter.apply(T, load, [&](Index i, const Real* line) {
        y.row(i) = ConstLine(line, ny).transpose().template cast<double>();
    });
    return {y, filter.quadratic_form(T, load)};
}

TEST_P(Filtered, MapIsTheConvolution) {
    const auto [nx, ny, px, py] = GetParam();
    const Array2D x = Array2D::Random(nx, ny);
    const auto [y, form_found] = filtered<double>(GetParam(), x);
    double largest = 0.0, form = 0.0;
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) {
            double sum = 0.0;
            for (Index a = 0; a < nx; ++a)
                for (Index b = 0; b < ny; ++b)
                    sum += x(a, b) * kernel(folded((i - a + px) % px, px), folded((j - b + py) % py, py));
            largest = std::max(largest, std::abs(sum - y(i, j)));
            form += x(i, j) * sum;
        }
    EXPECT_LT(largest, 1e-13 * static_cast<double>(nx + ny));
    EXPECT_NEAR(form_found, form, 1e-12 * std::abs(form));
}

TEST_P(Filtered, MapInSinglePrecisionDiffersByRoundingOnly) {
    const Array2D x = Array2D::Random(GetParam().nx, GetParam().ny);
    const auto [y, form] = filtered<double>(GetParam(), x);
    const auto [rounded, rounded_form] = filtered<float>(GetParam(), x);
    EXPECT_LT((rounded - y).abs().maxCoeff(), 1e-6 * y.abs().maxCoeff());
    EXPECT_NEAR(rounded_form, form, 1e-5 * std::abs(form));
}

INSTANTIATE_TEST_SUITE_P(EvenAndOddSides, Filtered,
                         ::testing::Values(Case{8, 8, 8, 8}, Case{7, 5, 7, 5}, Case{6, 9, 12, 18}, Case{5, 8, 10, 8},
                                           Case{1, 12, 1, 12}, Case{9, 1, 18, 1}, Case{1, 1, 1, 1},
                                           Case{20, 30, 39, 30}));

TEST(MapFilter, KernelMultiplierEqualsTheTransformedKernel) {
    const Index px = 12, py = 10;
    const MapFilter filter(5, 4, px, py);
    const Multiplier by_sums = filter.multiplier([&](Index k, Index m) { return transform(k, m, px, py); });
    const Multiplier by_kernel = filter.kernel_multiplier(kernel);
    ASSERT_EQ(by_sums.values.size(), by_kernel.values.size());
    for (std::size_t i = 0; i < by_sums.values.size(); ++i) EXPECT_NEAR(by_sums.values[i], by_kernel.values[i], 1e-15);
    EXPECT_THROW((void)MapFilter(5, 4, 11, 10).kernel_multiplier(kernel), InvalidArgument);
}

TEST(MapFilter, RefusesPeriodsShorterThanTheMap) {
    EXPECT_THROW(MapFilter(8, 8, 7, 8), InvalidArgument);
    EXPECT_THROW(MapFilter(0, 8, 8, 8), InvalidArgument);
}

}  // namespace
}  // namespace setae::fourier::map_filter_test
