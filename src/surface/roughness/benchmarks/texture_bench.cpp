// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <benchmark/benchmark.h>

#include "setae/texture/areal_parameters.hpp"
#include "setae/texture/height_parameters.hpp"
#include "texture/hybrid_parameters.hpp"
#include "texture/spatial_parameters.hpp"

namespace setae::texture {
namespace {

/// Waves of many lengths, so neighbours are similar as on measured surfaces.
const topography::HeightMap& rough_map() {
    static const topography::HeightMap map = [] {
        topography::HeightMap made{Array2D::Zero(2048, 2048), {1e-4, 1e-4}};
        for (Index wave = 1; wave <= 256; wave *= 2) {
            const double q = 2.0 * 3.14159265 * static_cast<double>(wave) / 2048.0,
                         phase = 1.7 * static_cast<double>(wave);
            for (Index i = 0; i < 2048; ++i)
                for (Index j = 0; j < 2048; ++j)
                    made.heights(i, j) += std::pow(static_cast<double>(wave), -0.8) *
                                          std::sin(q * (0.8 * static_cast<double>(i) + phase)) *
                                          std::cos(q * (0.6 * static_cast<double>(j) - phase));
        }
        return made;
    }();
    return map;
}

/// Independent neighbours: every triangle spans many heights.
const topography::HeightMap& white_map() {
    static const topography::HeightMap map{Array2D::Random(2048, 2048), {1e-4, 1e-4}};
    return map;
}

Array1D heights_of(const topography::HeightMap& map) {
    return Array1D::LinSpaced(101, map.heights.minCoeff(), map.heights.maxCoeff());
}

parallel::Threads threads_of(const benchmark::State& state) { return {static_cast<int>(state.range(0))}; }

/// Reference time: every height read once.
void read_once(benchmark::State& state) {
    const auto& heights = rough_map().heights;
    for (auto _ : state) benchmark::DoNotOptimize(heights.sum());
}

void bearing_area_of_a_rough_map(benchmark::State& state) {
    const auto heights = heights_of(rough_map());
    for (auto _ : state)
        benchmark::DoNotOptimize(bearing_area(rough_map(), heights, Between::linear, threads_of(state)));
}

void bearing_area_of_white_noise(benchmark::State& state) {
    const auto heights = heights_of(white_map());
    for (auto _ : state)
        benchmark::DoNotOptimize(bearing_area(white_map(), heights, Between::linear, threads_of(state)));
}

void median_and_deviation(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(mad_height(rough_map(), share_within_one_sigma, Between::linear, threads_of(state)));
}

void heights(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(height_parameters(rough_map(), threads_of(state)));
}

void slopes_and_area(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(hybrid_parameters(rough_map(), threads_of(state)));
}

void core_and_volumes(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(functional_parameters(rough_map(), {}, Between::linear, threads_of(state)));
}

void autocorrelation_and_direction(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(spatial_parameters(rough_map(), {}, threads_of(state)));
}

void all_areal_parameters(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(areal_parameters(rough_map(), {}, threads_of(state)));
}

BENCHMARK(read_once)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(bearing_area_of_a_rough_map)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(bearing_area_of_white_noise)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(median_and_deviation)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(heights)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(slopes_and_area)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(core_and_volumes)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(autocorrelation_and_direction)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(all_areal_parameters)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace setae::texture
