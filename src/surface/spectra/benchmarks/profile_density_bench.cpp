// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <benchmark/benchmark.h>

#include "setae/spectra/spectral_density.hpp"

namespace {

using namespace setae;

/// Five decades of a self-affine spectrum.
void profile_density_of_power_laws(benchmark::State& state) {
    const auto C_iso = spectra::density(spectra::SelfAffine{1.0, 1.0, 0.8, 1e4});
    for (auto _ : state) benchmark::DoNotOptimize(spectra::profile_density(C_iso, {0.1, 1e4}));
}
BENCHMARK(profile_density_of_power_laws)->Unit(benchmark::kMillisecond);

/// Five decades of a spectrum without power laws.
void profile_density_of_a_smooth_curve(benchmark::State& state) {
    const spectra::SpectralDensity C_iso = [](double q) {
        return std::pow(1.0 + q * q, -1.8) * (1.1 + std::sin(std::log(q)));
    };
    for (auto _ : state) benchmark::DoNotOptimize(spectra::profile_density(C_iso, {0.1, 1e4}));
}
BENCHMARK(profile_density_of_a_smooth_curve)->Unit(benchmark::kMillisecond);

}  // namespace
