// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "setae/core/constants.hpp"
#include "setae/synthesis/multiscale.hpp"

namespace {

using namespace setae;
using namespace setae::synthesis;

constexpr int octaves = 24;
const spectra::SelfAffine model{1e-28, 2.0 * pi / 2e-6, 0.8, 2.0 * pi / 4e-10};

MultiscaleSurface surface(int threads) {
    return {spectra::density(model), {.longest_wavelength = 4e-3, .shortest_wavelength = 4e-10, .threads = {threads}}};
}

/// Seven decades of wavelengths.
void multiscale_surface(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(surface(static_cast<int>(state.range(0))));
}
BENCHMARK(multiscale_surface)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// 512² points at a spacing in picometres; "points" counts each octave.
void multiscale_window(benchmark::State& state) {
    const auto made = surface(static_cast<int>(state.range(1)));
    const double pixel_size = 1e-12 * static_cast<double>(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(made.window({1e-3, 2e-3, 512, 512, pixel_size}));
    state.SetItemsProcessed(state.iterations() * 512 * 512 * octaves);
}
BENCHMARK(multiscale_window)
    ->Args({400, 1})
    ->Args({10000, 1})
    ->Args({1000000, 1})
    ->Args({1000000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
