// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>

#include <benchmark/benchmark.h>

#include "setae/processing/steps.hpp"

namespace {

using namespace setae;
using namespace setae::processing;

/// A rough tilted map with jumps of its lines.
topography::HeightMap map_of(Index n) {
    std::mt19937 engine(1);
    std::normal_distribution<double> normal(0.0, 1e-9);
    topography::HeightMap map{Array2D(n, n), {1e-5, 1e-5}};
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            map.heights(i, j) = 1e-8 * std::sin(0.01 * static_cast<double>(i + 2 * j)) +
                                1e-10 * static_cast<double>(i) + normal(engine);
    return map;
}

/// Minimum time of a step: the array read twice and written once.
void array_read_twice(benchmark::State& state) {
    auto map = map_of(state.range(0));
    for (auto _ : state) {
        const double mean = map.heights.mean();
        map.heights -= mean;
        benchmark::DoNotOptimize(map.heights.data());
    }
    state.SetBytesProcessed(state.iterations() * 2 * map.heights.size() * 8);
}
BENCHMARK(array_read_twice)->Arg(2048)->Arg(4096)->Unit(benchmark::kMillisecond);

template <class S>
void step(benchmark::State& state, const S& parameters, int threads) {
    topography::Measurement measurement = map_of(state.range(0));
    for (auto _ : state) {
        auto processed = processing::apply(Step(parameters), std::move(measurement), {}, {threads});
        measurement = std::move(processed.measurement);
        benchmark::DoNotOptimize(processed.record.numbers.data());
    }
}

template <class S>
void with_defaults(benchmark::State& state) {
    step(state, S{}, 1);
}
BENCHMARK(with_defaults<LevelPlane>)->Name("level_plane")->Arg(2048)->Arg(4096)->Unit(benchmark::kMillisecond);
BENCHMARK(with_defaults<LevelPolynomial>)->Name("level_polynomial_2")->Arg(2048)->Unit(benchmark::kMillisecond);
BENCHMARK(with_defaults<LevelLines>)->Name("level_lines")->Arg(2048)->Unit(benchmark::kMillisecond);
BENCHMARK(with_defaults<AlignRows>)->Name("align_rows_median")->Arg(2048)->Unit(benchmark::kMillisecond);
BENCHMARK(with_defaults<RemoveScars>)->Name("remove_scars")->Arg(2048)->Unit(benchmark::kMillisecond);
BENCHMARK(with_defaults<LevelFacet>)->Name("level_facet")->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(with_defaults<Despike>)->Name("despike")->Arg(2048)->Unit(benchmark::kMillisecond);

}  // namespace
