// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "setae/core/constants.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "surfaces/surface_patches.hpp"

namespace {

using namespace setae;
using namespace setae::simulation;

/// Self-affine, roll-off at 1 µm, cutoff at 4 Å, rms slope 0.8.
KnownSurface rough() {
    spectra::SelfAffine model{1.0, 2.0 * pi / 1e-6, 0.8, 2.0 * pi / 4e-10};
    model.plateau = 0.64 / std::pow(spectra::rms_slope(model), 2);
    return {.C_iso = spectra::density(model), .rolloff_wavelength = 1e-6, .short_wavelength = 4e-10};
}

void truth(benchmark::State& state) {
    KnownSurface surface = rough();
    surface.skewness = 0.1 * static_cast<double>(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(true_surface_values(surface));
}
BENCHMARK(truth)->Arg(0)->Arg(6)->Unit(benchmark::kMillisecond);

void stylus_strip(benchmark::State& state) {
    const KnownSurface surface = rough();
    const LineSpectrum C1D(surface);
    const StylusProtocol protocol{.lengths = std::vector<double>(5, 500e-6),
                                  .steps = {0.1e-6, 0.2e-6, 0.5e-6, 1e-6, 0.1e-6}};
    for (auto _ : state) benchmark::DoNotOptimize(stylus_scans(surface, C1D, protocol, {1, 2}));
}
BENCHMARK(stylus_strip)->Unit(benchmark::kMillisecond);

/// The surface alone of a strip as large as that one.
void bare_surface_of_a_strip(benchmark::State& state) {
    const KnownSurface surface = rough();
    for (auto _ : state)
        benchmark::DoNotOptimize(
            synthesis::random_surface(surface.C_iso, {20480, 800, 512e-6, 20e-6}, {.key = {1, 2}, .threads = {1}}));
}
BENCHMARK(bare_surface_of_a_strip)->Unit(benchmark::kMillisecond);

void afm(benchmark::State& state) {
    const KnownSurface surface = rough();
    const AfmProtocol protocol{.sizes = {1e-9 * static_cast<double>(state.range(0))}, .pixels = {state.range(1)}};
    for (auto _ : state) benchmark::DoNotOptimize(afm_scan(surface, protocol, 0, {1, 2}));
}
BENCHMARK(afm)->Args({5000, 512})->Args({1000, 512})->Args({200, 256})->Unit(benchmark::kMillisecond);

/// The surface alone of the largest of these maps.
void bare_surface_of_a_map(benchmark::State& state) {
    const KnownSurface surface = rough();
    for (auto _ : state)
        benchmark::DoNotOptimize(
            synthesis::random_surface(surface.C_iso, {2560, 2560, 6.25e-6, 6.25e-6}, {.key = {1, 2}, .threads = {1}}));
}
BENCHMARK(bare_surface_of_a_map)->Unit(benchmark::kMillisecond);

void contour(benchmark::State& state) {
    const KnownSurface surface = rough();
    const LineSpectrum C1D(surface);
    const TemProtocol protocol{.lengths = {100e-9}, .steps = ContourSteps::uniform};
    for (auto _ : state) benchmark::DoNotOptimize(tem_contour(surface, C1D, protocol, 0, {1, 2}));
}
BENCHMARK(contour)->Unit(benchmark::kMillisecond);

}  // namespace
