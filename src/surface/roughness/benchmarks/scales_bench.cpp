// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes 8192 and 16384 (2 GiB per map, 7 GiB in all) with SETAE_LARGE_BENCHMARKS set.
#include <cstdlib>

#include <benchmark/benchmark.h>

#include "setae/scales/autocorrelation.hpp"
#include "setae/scales/scale_dependent.hpp"
#include "setae/scales/variable_bandwidth.hpp"

namespace setae::scales {
namespace {

const topography::HeightMap& map_of(Index n) {
    static topography::HeightMap map;  // one at a time
    if (map.heights.rows() != n)
        map = {Array2D::Random(n, n), {1e-6 * static_cast<double>(n), 1e-6 * static_cast<double>(n)}};
    return map;
}

AutocorrelationOptions threads(const benchmark::State& state) {
    return {.threads = {static_cast<int>(state.range(1))}};
}

/// Reference time: every height read once.
void read_once(benchmark::State& state) {
    const auto& map = map_of(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(map.heights.sum());
}
void autocorrelation_area(benchmark::State& state) {
    const auto& map = map_of(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(autocorrelation_of_area(map, {}, threads(state)));
}
void autocorrelation_lines(benchmark::State& state) {
    const auto& map = map_of(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(autocorrelation_of_lines(map, threads(state)));
}
void slope_of_lines(benchmark::State& state) {
    const auto& map = map_of(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(slope_from_autocorrelation(autocorrelation_of_lines(map, threads(state))));
}
void bandwidth_area(benchmark::State& state) {
    const auto& map = map_of(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(variable_bandwidth_of_area(map, {.threads = {static_cast<int>(state.range(1))}}));
}
void bandwidth_lines(benchmark::State& state) {
    const auto& map = map_of(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(variable_bandwidth_along_lines(map, {.threads = {static_cast<int>(state.range(1))}}));
}
void slopes(benchmark::State& state, Along along) {
    const auto& map = map_of(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(
            difference_statistics(map, {.order = 1, .along = along, .threads = {static_cast<int>(state.range(1))}}));
}
void slopes_along_x(benchmark::State& state) { slopes(state, Along::x); }
void gradients(benchmark::State& state) { slopes(state, Along::both); }
void curvatures(benchmark::State& state) {
    const auto& map = map_of(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(difference_statistics(
            map, {.order = 2, .along = Along::both, .threads = {static_cast<int>(state.range(1))}}));
}
void polyline(benchmark::State& state) {
    const Index n = state.range(0);
    topography::Profile profile{Array1D::LinSpaced(n, 0.0, 1e-6 * static_cast<double>(n)) + 0.4e-6 * Array1D::Random(n),
                                Array1D::Random(n),
                                {}};
    for (auto _ : state) benchmark::DoNotOptimize(autocorrelation(profile));
}

void sizes(benchmark::internal::Benchmark* bench) {
    bench->Args({1024, 2})
        ->Args({2048, 2})
        ->Args({4096, 1})
        ->Args({4096, 2})
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
    if (std::getenv("SETAE_LARGE_BENCHMARKS")) bench->Args({8192, 2})->Args({16384, 2});
}
BENCHMARK(read_once)->Arg(2048)->Arg(4096)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(autocorrelation_area)->Apply(sizes);
BENCHMARK(autocorrelation_lines)->Apply(sizes);
BENCHMARK(slope_of_lines)->Apply(sizes);
BENCHMARK(bandwidth_area)->Apply(sizes);
BENCHMARK(bandwidth_lines)->Apply(sizes);
BENCHMARK(slopes_along_x)->Apply(sizes);
BENCHMARK(gradients)->Apply(sizes);
BENCHMARK(curvatures)->Apply(sizes);
BENCHMARK(polyline)->Arg(3000)->Arg(30000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace setae::scales
