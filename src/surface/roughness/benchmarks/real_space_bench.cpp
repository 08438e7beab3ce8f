// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "setae/roughness/real_space.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::roughness {
namespace {

const topography::HeightMap& map_4096() {
    static const topography::HeightMap map{Array2D::Random(4096, 4096), {1e-6, 1e-6}};
    return map;
}

/// Reference time: every height read once.
void read_once(benchmark::State& state) {
    const auto& heights = map_4096().heights;
    for (auto _ : state) benchmark::DoNotOptimize(heights.sum());
}

void rms_height_gradient_curvature(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(real_space_parameters(map_4096(), {static_cast<int>(state.range(0))}));
}

void rms_with_a_hole_in_every_block(benchmark::State& state) {
    auto map = map_4096();
    for (Index i = 0; i < 4096; i += 64) map.heights(i, i) = std::numeric_limits<double>::quiet_NaN();
    for (auto _ : state) benchmark::DoNotOptimize(real_space_parameters(map, {1}));
}

void triangulated(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(triangulated_area(map_4096(), {static_cast<int>(state.range(0))}));
}

BENCHMARK(read_once)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(rms_height_gradient_curvature)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(rms_with_a_hole_in_every_block)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(triangulated)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace setae::roughness
