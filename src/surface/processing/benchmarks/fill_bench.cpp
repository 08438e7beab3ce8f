// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <benchmark/benchmark.h>

#include "setae/processing/fill.hpp"

namespace setae::processing {
namespace {

constexpr double undefined_height = std::numeric_limits<double>::quiet_NaN();

topography::HeightMap with_round_hole(Index n, double radius) {
    topography::HeightMap map{Array2D::Random(n, n), {1.0, 1.0}, false, {}};
    const double middle = 0.5 * static_cast<double>(n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            if (std::hypot(static_cast<double>(i) - middle, static_cast<double>(j) - middle) < radius)
                map.heights(i, j) = undefined_height;
    return map;
}

topography::HeightMap with_small_holes(Index n) {
    topography::HeightMap map{Array2D::Random(n, n), {1.0, 1.0}, false, {}};
    std::mt19937 generator(1);
    const Index side = n / 22;
    for (Index k = 0; k < side; ++k)
        for (Index m = 0; m < side && k * side + m < 2000 * n * n / (1024 * 1024); ++m)
            map.heights
                .block(22 * k + static_cast<Index>(generator() % 17), 22 * m + static_cast<Index>(generator() % 17), 4,
                       4)
                .setConstant(undefined_height);
    return map;
}

/// Copies, because every filling is timed with one.
void copy_1024(benchmark::State& state) {
    const auto map = with_small_holes(1024);
    Array2D other(1024, 1024);
    for (auto _ : state) {
        std::memcpy(other.data(), map.heights.data(), sizeof(double) * 1024 * 1024);
        benchmark::DoNotOptimize(other.data());
    }
}

void one_hole(benchmark::State& state) {
    const auto n = static_cast<Index>(state.range(0));
    const auto map = with_round_hole(n, 0.1742 * static_cast<double>(n));
    for (auto _ : state) benchmark::DoNotOptimize(filled(map, {1}).heights.data());
    state.SetComplexityN(n * n);
}

void small_holes(benchmark::State& state) {
    const auto map = with_small_holes(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(filled(map, {static_cast<int>(state.range(1))}).heights.data());
}

BENCHMARK(copy_1024)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(one_hole)
    ->Arg(512)
    ->Arg(1024)
    ->Arg(2048)
    ->Arg(4096)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity(benchmark::oN);
BENCHMARK(small_holes)->Args({1024, 1})->Args({1024, 2})->Args({4096, 1})->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace setae::processing
