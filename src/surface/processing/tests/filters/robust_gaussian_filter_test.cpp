// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "setae/core/errors.hpp"
#include "setae/processing/iso_filter.hpp"

namespace setae::processing::robust_gaussian_filter_test {
namespace {

using topography::HeightMap;
using topography::LineScan;

Array2D noise(Index nx, Index ny) {
    std::mt19937 generator(3);
    std::normal_distribution<double> normal;
    return Array2D::NullaryExpr(nx, ny, [&] { return normal(generator); });
}

/// Gaussian regression of a line with weights δ by the definition: a dense fit at every point.
Array1D regression(const Array1D& heights, const Array1D& factors, double deviation, Index order) {
    const Index n = heights.size();
    Array1D smooth(n);
    for (Index at = 0; at < n; ++at) {
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(order + 1, order + 1);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(order + 1), basis(order + 1);
        for (Index i = 0; i < n; ++i) {
            const double x = static_cast<double>(i - at) / deviation;
            for (Index k = 0; k <= order; ++k) basis[k] = std::pow(x, static_cast<double>(k));
            const double s = factors[i] * std::exp(-0.5 * x * x);
            normal += s * basis * basis.transpose();
            right += s * heights[i] * basis;
        }
        smooth[at] = normal.ldlt().solve(right)[0];
    }
    return smooth;
}

/// The whole iteration by the definition.
Array1D by_definition(const Array1D& heights, double deviation, Index order) {
    Array1D factors = Array1D::Ones(heights.size());
    double scale = 0.0;
    for (;;) {
        const Array1D smooth = regression(heights, factors, deviation, order), residual = (heights - smooth).abs();
        Array1D sorted = residual;
        std::sort(sorted.begin(), sorted.end());
        const Index n = sorted.size();
        const double found = 4.4478 * (n % 2 == 1 ? sorted[n / 2] : 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]));
        if (std::abs(found - scale) < 1e-4 * found) return smooth;
        scale = found;
        factors = (residual < scale).select((1.0 - (residual / scale).square()).square(), 0.0);
    }
}

TEST(RobustGaussianFilter, OfLinesFollowsTheIterationOfTheStandard) {
    LineScan scan{Array1D(noise(1, 80).row(0).transpose()), 80.0, false, {}};
    scan.heights += Array1D::LinSpaced(80, -3.0, 5.0).square();
    scan.heights.segment(30, 4) -= 20.0;
    const double pi = std::numbers::pi;
    for (const double cutoff : {9.0, 30.0}) {
        const Array1D zero = filtered(scan, RobustGaussianFilter{.cutoff = cutoff, .order = 0}).heights;
        EXPECT_LT(
            (zero - by_definition(scan.heights, cutoff * std::sqrt(std::numbers::ln2 / pi) / std::sqrt(2.0 * pi), 0))
                .abs()
                .maxCoeff(),
            1e-5)
            << cutoff;
        const Array1D second = filtered(scan, RobustGaussianFilter{.cutoff = cutoff, .order = 2}).heights;
        EXPECT_LT((second - by_definition(scan.heights, cutoff * 0.730911 / std::sqrt(2.0 * pi), 2)).abs().maxCoeff(),
                  1e-4)
            << cutoff;  // α to 6 digits
    }
}

TEST(RobustGaussianFilter, IsUnaffectedByDeepGrooves) {
    const Index n = 2000;
    LineScan scan{Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)), static_cast<double>(n), false, {}};
    const Array1D waviness = (scan.heights * (2.0 * std::numbers::pi / 800.0)).sin();
    scan.heights = waviness + 0.02 * Array1D(noise(1, n).row(0).transpose());
    for (Index groove = 100; groove < n; groove += 200) scan.heights.segment(groove, 12) -= 5.0;
    const Array1D robust = filtered(scan, RobustGaussianFilter{.cutoff = 200.0}).heights,
                  plain = filtered(scan, GaussianFilter{.cutoff = 200.0}).heights;
    EXPECT_LT((robust - waviness).segment(50, n - 100).abs().maxCoeff(), 0.03);
    EXPECT_GT((plain - waviness).abs().maxCoeff(), 0.3);
}

TEST(RobustGaussianFilter, OfMapsIgnoresHoles) {
    const Index n = 64;
    HeightMap map{Array2D::NullaryExpr(n, n,
                                       [](Index i, Index j) {
                                           return 0.001 * static_cast<double>(i * i) -
                                                  0.002 * static_cast<double>(i * j) + 0.1 * static_cast<double>(j);
                                       }),
                  {64.0, 64.0},
                  false,
                  {}};
    const Array2D form = map.heights;
    map.heights += 1e-3 * noise(n, n);
    map.heights.block(20, 30, 5, 5) -= 50.0;
    map.heights(40, 40) = std::numeric_limits<double>::quiet_NaN();
    const Array2D smooth = filtered(map, RobustGaussianFilter{.cutoff = 30.0}).heights;
    EXPECT_EQ(smooth.isNaN().count(), 1);
    EXPECT_LT((smooth.isNaN().select(form, smooth) - form).abs().maxCoeff(), 2e-3);
}

TEST(RobustGaussianFilter, TransmitsAsTheLinearFilterForEqualWeights) {
    // alternating heights of ±1 have equal weights δ(1); a small sine s on them changes h δ by δ' (s − w) on average,
    // so w is at first G s and then, weighted once because the scale does not change, G (δ s + δ' (s − G s))/δ, with
    // the linear transmission G = 1/2 at the cutoff for every order
    const Index n = 1200;
    const double c = 4.4478, delta = std::pow(1.0 - 1.0 / (c * c), 2.0), slope = -4.0 / (c * c) * (1.0 - 1.0 / (c * c));
    const double expected = 0.5 * (delta + 0.5 * slope) / delta;
    LineScan scan{Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)), static_cast<double>(n), true, {}};
    const Array1D sine = 1e-6 * (scan.heights * (2.0 * std::numbers::pi / 100.0)).sin();
    scan.heights = sine;
    for (Index i = 0; i < n; ++i) scan.heights[i] += i % 2 == 0 ? 1.0 : -1.0;
    for (const Index order : {0, 1, 2}) {
        const Array1D smooth = filtered(scan, RobustGaussianFilter{.cutoff = 100.0, .order = order}).heights;
        EXPECT_NEAR((smooth * sine).sum() / sine.square().sum(), expected, 1e-6) << order;
    }
}

TEST(RobustGaussianFilter, KeepsPolynomialsAndConstants) {
    const Index n = 40;
    const HeightMap parabola{
        Array2D::NullaryExpr(
            n, n, [](Index i, Index j) { return static_cast<double>(i * i + 2 * i * j) - static_cast<double>(j * j); }),
        {40.0, 40.0},
        false,
        {}};
    EXPECT_LT((filtered(parabola, RobustGaussianFilter{.cutoff = 12.0}).heights - parabola.heights).abs().maxCoeff(),
              1e-7);
    const LineScan flat{Array1D::Constant(30, 4.0), 30.0, false, {}};
    EXPECT_TRUE((filtered(flat, RobustGaussianFilter{.cutoff = 12.0}).heights == 4.0).all());
}

TEST(RobustGaussianFilter, GivesTheSameBytesForAnyNumberOfThreads) {
    const HeightMap map{noise(40, 260), {40.0, 260.0}, false, {}};
    const Array2D one = filtered(map, RobustGaussianFilter{.cutoff = 20.0}, {1}).heights,
                  three = filtered(map, RobustGaussianFilter{.cutoff = 20.0}, {3}).heights;
    EXPECT_EQ(std::memcmp(one.data(), three.data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0);
}

TEST(RobustGaussianFilter, RefusesInvalidParameters) {
    const LineScan scan{Array1D::Zero(10), 10.0, false, {}};
    EXPECT_THROW((void)filtered(scan, RobustGaussianFilter{}), InvalidArgument);
    EXPECT_THROW((void)filtered(scan, RobustGaussianFilter{.cutoff = 3.0, .order = 3}), InvalidArgument);
    const topography::Profile profile{Array1D{{0.0, 1.0, 3.0}}, Array1D{{0.0, 1.0, 0.0}}, {}};
    EXPECT_THROW((void)apply(RobustGaussianFilter{.cutoff = 1.0}, profile), InvalidArgument);
    EXPECT_GE(apply(RobustGaussianFilter{.cutoff = 3.0}, HeightMap{noise(20, 20), {20.0, 20.0}, false, {}})
                  .record.numbers.at(1)
                  .estimate.value,
              2.0);
}

}  // namespace
}  // namespace setae::processing::robust_gaussian_filter_test
