// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>

#include <benchmark/benchmark.h>
#include <fftw3.h>

#include "setae/processing/fourier_cut.hpp"
#include "setae/processing/iso_filter.hpp"

namespace setae::processing {
namespace {

topography::HeightMap map_of(Index n, bool periodic = false) {
    return {Array2D::Random(n, n), {static_cast<double>(n), static_cast<double>(n)}, periodic, {}};
}

parallel::Threads threads_of(const benchmark::State& state) { return {static_cast<int>(state.range(1))}; }

/// Reference times: heights copied once; a filter by forward and inverse transform.
void copy(benchmark::State& state) {
    const auto map = map_of(state.range(0));
    Array2D other(map.heights.rows(), map.heights.cols());
    for (auto _ : state) {
        std::memcpy(other.data(), map.heights.data(), sizeof(double) * static_cast<std::size_t>(other.size()));
        benchmark::DoNotOptimize(other.data());
    }
}

void bare_transforms(benchmark::State& state) {
    const auto n = static_cast<int>(state.range(0));
    double* heights = fftw_alloc_real(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    fftw_complex* modes = fftw_alloc_complex(static_cast<std::size_t>(n) * static_cast<std::size_t>(n / 2 + 1));
    fftw_plan there = fftw_plan_dft_r2c_2d(n, n, heights, modes, FFTW_ESTIMATE),
              back = fftw_plan_dft_c2r_2d(n, n, modes, heights, FFTW_ESTIMATE);
    std::memset(heights, 0, sizeof(double) * static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    for (auto _ : state) {
        fftw_execute(there);
        fftw_execute(back);
    }
    fftw_destroy_plan(there);
    fftw_destroy_plan(back);
    fftw_free(heights);
    fftw_free(modes);
}

template <class Filter>
void filter_in_place(benchmark::State& state, const Filter& filter, topography::HeightMap map) {
    for (auto _ : state) map = filtered(std::move(map), filter, threads_of(state));
    state.SetComplexityN(state.range(0) * state.range(0));
}

void gaussian(benchmark::State& state) {
    filter_in_place(state, GaussianFilter{.cutoff = static_cast<double>(state.range(2))}, map_of(state.range(0)));
}
void gaussian_with_planes(benchmark::State& state) {
    filter_in_place(state, GaussianFilter{.cutoff = 100.0, .order = 1}, map_of(state.range(0)));
}
void gaussian_with_a_hole(benchmark::State& state) {
    auto map = map_of(state.range(0));
    map.heights.block(100, 100, 50, 50).setConstant(std::numeric_limits<double>::quiet_NaN());
    filter_in_place(state, GaussianFilter{.cutoff = 100.0}, std::move(map));
}
void robust(benchmark::State& state) {
    const auto map = map_of(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(
            filtered(map, RobustGaussianFilter{.cutoff = 100.0, .order = 0}, threads_of(state)).heights.data());
}
void spline(benchmark::State& state) { filter_in_place(state, SplineFilter{.cutoff = 100.0}, map_of(state.range(0))); }
void fourier_cut(benchmark::State& state) {
    auto map = map_of(state.range(0), true);
    for (auto _ : state) map = cut(std::move(map), FourierCut{.shortest = 10.0}, threads_of(state));
}

BENCHMARK(copy)->Args({4096, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(bare_transforms)->Args({4096, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(gaussian)
    ->Args({4096, 1, 10})
    ->Args({4096, 1, 100})
    ->Args({4096, 1, 1000})
    ->Args({4096, 2, 100})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(gaussian)
    ->Name("gaussian_by_size")
    ->Args({1024, 1, 100})
    ->Args({2048, 1, 100})
    ->Args({4096, 1, 100})
    ->Args({8192, 1, 100})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity(benchmark::oN);
BENCHMARK(gaussian_with_planes)->Args({4096, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(gaussian_with_a_hole)->Args({4096, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(robust)->Args({1024, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(spline)->Args({4096, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(fourier_cut)->Args({4096, 1})->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace setae::processing
