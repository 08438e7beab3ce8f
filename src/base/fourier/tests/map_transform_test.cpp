// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/map_transform.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/buffer.hpp"

namespace map_transform_test {

using namespace setae;
using fourier::Complex;

Array2D random_map(Index nx, Index ny) {
    std::mt19937_64 engine(17);
    std::normal_distribution<double> number;
    return Array2D::NullaryExpr(nx, ny, [&] { return number(engine); });
}

using ComplexMap = Eigen::Array<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

ComplexMap collect(Index lines, Index modes, const std::function<void(const fourier::BlockConsumer&)>& run) {
    ComplexMap all(lines, modes);
    run([&](const fourier::SpectrumBlock& block) {
        for (Index m = 0; m < block.lines; ++m)
            for (Index k = 0; k < block.modes; ++k) all(block.first + m, k) = block.line(m)[k];
    });
    return all;
}

ComplexMap transformed_map(const Array2D& map, int threads = 1) {
    return collect(map.cols() / 2 + 1, map.rows(), [&](const auto& consume) {
        fourier::transform_map(map.rows(), map.cols(),
                               [&](Index i, double* line) { std::copy_n(map.row(i).data(), map.cols(), line); },
                               consume, {threads});
    });
}

TEST(PaddedMapTransform, EqualsTheTransformOfTheZeroPaddedMap) {
    Array2D map = Array2D::Zero(30, 21);
    map.topRows(11) = random_map(11, 21);
    const auto padded = collect(11, 30, [&](const auto& consume) {
        fourier::transform_padded_map(
            30, 21, 11, [&](Index i, double* line) { std::copy_n(map.row(i).data(), 21, line); }, consume, {2});
    });
    EXPECT_TRUE((padded == transformed_map(map)).all());
}

ComplexMap transformed_lines(const Array2D& map, int threads = 1) {
    return collect(map.cols(), map.rows() / 2 + 1, [&](const auto& consume) {
        fourier::transform_lines(map, [](Index, double*) {}, consume, {threads});
    });
}

Complex wave(Index product, Index n) {
    return std::polar(1.0, -2.0 * pi * static_cast<double>(product % n) / static_cast<double>(n));
}

class Shapes : public testing::TestWithParam<std::tuple<Index, Index>> {};

TEST_P(Shapes, MapTransformIsTheDoubleSum) {
    const auto [nx, ny] = GetParam();
    const auto map = random_map(nx, ny);
    const auto spectrum = transformed_map(map);
    for (Index m = 0; m < spectrum.rows(); ++m)
        for (Index k = 0; k < nx; ++k) {
            Complex sum{};
            for (Index i = 0; i < nx; ++i)
                for (Index j = 0; j < ny; ++j) sum += map(i, j) * wave(i * k, nx) * wave(j * m, ny);
            ASSERT_LT(std::abs(spectrum(m, k) - sum), 1e-12 * static_cast<double>(nx * ny)) << k << ", " << m;
        }
}

TEST_P(Shapes, LineTransformIsTheSumAlongX) {
    const auto [nx, ny] = GetParam();
    const auto map = random_map(nx, ny);
    const auto spectra = transformed_lines(map);
    for (Index j = 0; j < ny; ++j)
        for (Index k = 0; k < spectra.cols(); ++k) {
            Complex sum{};
            for (Index i = 0; i < nx; ++i) sum += map(i, j) * wave(i * k, nx);
            ASSERT_LT(std::abs(spectra(j, k) - sum), 1e-13 * static_cast<double>(nx)) << k << ", line " << j;
        }
}

INSTANTIATE_TEST_SUITE_P(EvenAndOdd, Shapes,
                         testing::Values(std::tuple{1, 1}, std::tuple{2, 1}, std::tuple{1, 5}, std::tuple{8, 6},
                                         std::tuple{7, 9}, std::tuple{16, 35}, std::tuple{33, 40}));

TEST(MapTransform, GivesTheSameBytesForAnyNumberOfThreads) {
    const auto map = random_map(100, 75);
    EXPECT_TRUE((transformed_map(map, 1) == transformed_map(map, 3)).all());
    EXPECT_TRUE((transformed_lines(map, 1) == transformed_lines(map, 3)).all());
}

TEST(MapTransform, TransformsPreparedLines) {
    const auto map = random_map(12, 5);
    fourier::transform_lines(
        map, [](Index j, double* line) { std::fill_n(line, 12, static_cast<double>(j)); },
        [](const fourier::SpectrumBlock& block) {
            for (Index m = 0; m < block.lines; ++m)
                EXPECT_EQ(block.line(m)[0], Complex(12.0 * static_cast<double>(block.first + m), 0.0));
        },
        {1});
}

TEST(MapTransform, ReadsViewsOfLargerMaps) {
    const auto map = random_map(20, 30);
    const Array2D part = map.block(3, 4, 10, 8);
    ComplexMap of_view = collect(8, 6, [&](const auto& consume) {
        fourier::transform_lines(map.block(3, 4, 10, 8), [](Index, double*) {}, consume, {1});
    });
    EXPECT_TRUE((of_view == transformed_lines(part)).all());
}

TEST(MapTransform, RefusesEmptyMaps) {
    EXPECT_THROW(fourier::transform_map(
                     0, 4, [](Index, double*) {}, [](const fourier::SpectrumBlock&) {}, {1}),
                 InvalidArgument);
}

TEST(RealTransform, KeepsParseval) {
    for (const Index n : {1, 2, 15, 16, 1000, 1001}) {
        fourier::Buffer<double> in(static_cast<std::size_t>(n));
        fourier::Buffer<Complex> out(static_cast<std::size_t>(n / 2 + 1));
        std::mt19937_64 engine(3);
        std::normal_distribution<double> number;
        double power = 0.0;
        for (double& value : in) {
            value = number(engine);
            power += value * value;
        }
        const fourier::RealTransform transform(n);
        transform.forward(in.data(), out.data());
        double sum = 0.0;
        for (Index k = 0; k <= n / 2; ++k)
            sum += (k == 0 || 2 * k == n ? 1.0 : 2.0) * std::norm(out[static_cast<std::size_t>(k)]);
        EXPECT_NEAR(sum / static_cast<double>(n), power, 1e-13 * power) << n;
    }
}

TEST(ComplexTransform, ForwardThenBackwardIsNTimesTheInput) {
    constexpr Index n = 60;
    fourier::Buffer<Complex> values(n);
    for (Index k = 0; k < n; ++k)
        values[static_cast<std::size_t>(k)] = {std::sin(static_cast<double>(k)), static_cast<double>(k)};
    const auto original = values;
    fourier::ComplexTransform(n).apply(values.data());
    fourier::ComplexTransform(n, fourier::ComplexTransform::Sign::plus).apply(values.data());
    for (std::size_t k = 0; k < n; ++k) EXPECT_LT(std::abs(values[k] / 60.0 - original[k]), 1e-13);
}

TEST(RealTransform, RefusesZeroPoints) { EXPECT_THROW(fourier::RealTransform(0), InvalidArgument); }

}  // namespace map_transform_test
