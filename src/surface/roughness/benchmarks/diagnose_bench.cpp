// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <benchmark/benchmark.h>

#include "setae/diagnostics/diagnose.hpp"
#include "setae/spectra/power_spectrum.hpp"

namespace setae::diagnostics {
namespace {

topography::Measurement map_of(Index n) {
    // waves longer than a pixel with some noise, similar to a surface
    topography::HeightMap map{1e-10 * Array2D::Random(n, n), {1e-5, 1e-5}};
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            map.heights(i, j) +=
                1e-8 * std::sin(0.01 * static_cast<double>(i + 2 * j)) * std::cos(0.013 * static_cast<double>(j));
    return map;
}

/// Reference time: only C1D.
void spectrum_alone(benchmark::State& state) {
    const auto map = map_of(state.range(0));
    spectra::SpectrumOptions options;
    options.threads = {static_cast<int>(state.range(1))};
    for (auto _ : state) benchmark::DoNotOptimize(spectra::power_spectrum(map, options).density.data());
}

void all_faults(benchmark::State& state) {
    const auto map = map_of(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(diagnose(map, {.threads = {static_cast<int>(state.range(1))}}).size());
}

BENCHMARK(spectrum_alone)->ArgsProduct({{1024, 2048, 4096}, {1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(all_faults)->ArgsProduct({{1024, 2048, 4096}, {1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace setae::diagnostics
