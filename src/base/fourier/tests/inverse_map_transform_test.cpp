// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/inverse_map_transform.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/map_transform.hpp"

namespace inverse_map_transform_test {

using namespace setae;
using fourier::Complex;

using ComplexMap = Eigen::Array<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Array2D some_map(Index nx, Index ny) {
    return Array2D::NullaryExpr(
        nx, ny, [](Index i, Index j) { return std::sin(static_cast<double>(3 * i * i + 7 * j * j * j + i * j)); });
}

ComplexMap half_spectrum(const Array2D& map) {
    ComplexMap all(map.cols() / 2 + 1, map.rows());
    fourier::transform_map(
        map.rows(), map.cols(), [&](Index i, double* line) { std::copy_n(map.row(i).data(), map.cols(), line); },
        [&](const fourier::SpectrumBlock& block) {
            for (Index m = 0; m < block.lines; ++m)
                std::copy_n(block.line(m), block.modes, all.row(block.first + m).data());
        },
        {1});
    return all;
}

void load_from(const ComplexMap& half, Index m, Complex* modes) { std::copy_n(half.row(m).data(), half.cols(), modes); }

Array2D inverse(const ComplexMap& half, Index ny, int threads) {
    Array2D map(half.cols(), ny);
    fourier::inverse_transform_map([&](Index m, Complex* modes) { load_from(half, m, modes); }, map, {threads});
    return map;
}

class InverseShapes : public testing::TestWithParam<std::tuple<Index, Index>> {};

TEST_P(InverseShapes, InverseTransformReturnsTheMapTimesItsPoints) {
    const auto [nx, ny] = GetParam();
    const auto map = some_map(nx, ny);
    const Array2D back = inverse(half_spectrum(map), ny, 2) / static_cast<double>(nx * ny);
    EXPECT_LT((back - map).abs().maxCoeff(), 1e-14 * std::log2(static_cast<double>(2 * nx * ny)));
}

INSTANTIATE_TEST_SUITE_P(EvenAndOdd, InverseShapes,
                         testing::Values(std::tuple{1, 1}, std::tuple{2, 1}, std::tuple{1, 5}, std::tuple{1, 2},
                                         std::tuple{8, 6}, std::tuple{7, 9}, std::tuple{16, 35}, std::tuple{33, 40},
                                         std::tuple{5, 130}));

TEST(InverseMapTransform, ComputesTheRequestedRows) {
    const auto half = half_spectrum(some_map(40, 27));
    const Array2D whole = inverse(half, 27, 1);
    Array2D map(40, 27);
    fourier::InverseMapTransform transform([&](Index m, Complex* modes) { load_from(half, m, modes); }, map, {2});
    transform.make_rows(30, 40, {2});
    transform.make_rows(0, 3, {1});
    transform.make_rows(3, 3, {1});
    EXPECT_TRUE((map.bottomRows(10) == whole.bottomRows(10)).all());
    EXPECT_TRUE((map.topRows(3) == whole.topRows(3)).all());
}

TEST(InverseMapTransform, OfOneModeIsAWave) {
    ComplexMap half = ComplexMap::Zero(5, 12);
    half(3, 2) = {0.5, -0.25};
    const auto map = inverse(half, 9, 1);
    for (Index i = 0; i < 12; ++i)
        for (Index j = 0; j < 9; ++j) {
            const double phase = 2.0 * pi * (2.0 * static_cast<double>(i) / 12.0 + 3.0 * static_cast<double>(j) / 9.0);
            EXPECT_NEAR(map(i, j), std::cos(phase) + 0.5 * std::sin(phase), 1e-14);
        }
}

TEST(InverseMapTransform, GivesTheSameBytesForAnyNumberOfThreads) {
    const auto half = half_spectrum(some_map(60, 75));
    EXPECT_TRUE((inverse(half, 75, 1) == inverse(half, 75, 3)).all());
}

TEST(InverseMapTransform, WritesIntoPartOfALargerMap) {
    const auto half = half_spectrum(some_map(10, 8));
    Array2D large = Array2D::Constant(14, 20, -1.0);
    fourier::inverse_transform_map([&](Index m, Complex* modes) { load_from(half, m, modes); },
                                   large.block(2, 5, 10, 8), {1});
    EXPECT_TRUE((large.block(2, 5, 10, 8) == inverse(half, 8, 1)).all());
    EXPECT_EQ((large == -1.0).count(), 14 * 20 - 80);
}

TEST(InverseMapTransform, RefusesMapsWithoutPoints) {
    Array2D none(0, 4);
    EXPECT_THROW(fourier::inverse_transform_map([](Index, Complex*) {}, none, {1}), InvalidArgument);
}

}  // namespace inverse_map_transform_test
