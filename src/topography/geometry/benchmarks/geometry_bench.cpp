// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "setae/geometry/distance.hpp"
#include "setae/geometry/patches.hpp"
#include "setae/geometry/perimeter.hpp"

namespace {

using namespace setae;

/// Islands of a smooth random field above its 40th hundredth, n² points.
topography::Mask islands(Index n) {
    const Index m = n / 8 + 2;
    std::mt19937_64 source(1);
    const Array1D numbers = Array1D::NullaryExpr(m * m, [&](Index) { return static_cast<double>(source()) / 0x1p64; });
    topography::Mask mask(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
            const Index a = i / 8, b = j / 8;
            const double s = static_cast<double>(i % 8) / 8.0, t = static_cast<double>(j % 8) / 8.0;
            const double value = (1 - s) * ((1 - t) * numbers[a * m + b] + t * numbers[a * m + b + 1]) +
                                 s * ((1 - t) * numbers[(a + 1) * m + b] + t * numbers[(a + 1) * m + b + 1]);
            mask(i, j) = value > 0.6 ? 1 : 0;
        }
    return mask;
}

void memory_copy(benchmark::State& state) {
    const auto bytes = static_cast<std::size_t>(state.range(0) * state.range(0)) * sizeof(double);
    std::vector<char> from(bytes, 1), to(bytes);
    for (auto _ : state) {
        std::memcpy(to.data(), from.data(), bytes);
        benchmark::ClobberMemory();
    }
}
BENCHMARK(memory_copy)->Arg(1024)->Arg(4096)->Unit(benchmark::kMillisecond);

void find_patches(benchmark::State& state) {
    const auto mask = islands(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(geometry::patches(mask, geometry::Neighbours::edges_and_corners, true));
}
BENCHMARK(find_patches)->Arg(1024)->Arg(4096)->Unit(benchmark::kMillisecond);

void shapes_of_patches(benchmark::State& state) {
    const auto found = geometry::patches(islands(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(geometry::patch_shapes(found));
}
BENCHMARK(shapes_of_patches)->Arg(1024)->Arg(4096)->Unit(benchmark::kMillisecond);

void length_of_edges(benchmark::State& state) {
    const auto mask = islands(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(geometry::edge_length(mask, {}));
}
BENCHMARK(length_of_edges)->Arg(1024)->Arg(4096)->Unit(benchmark::kMillisecond);

void distances(benchmark::State& state) {
    const auto mask = islands(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(geometry::distance_map(mask, {{1.0, 1.0}, true}, {static_cast<int>(state.range(1))}));
}
BENCHMARK(distances)->Args({1024, 1})->Args({4096, 1})->Args({4096, 2})->Unit(benchmark::kMillisecond);

}  // namespace
