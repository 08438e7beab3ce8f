// SPDX-License-Identifier: GPL-3.0-or-later
// Power spectra compared with the plain transforms and copies they depend on, all in one run.
#include <cmath>
#include <complex>
#include <cstring>
#include <fstream>
#include <random>
#include <string>

#include <benchmark/benchmark.h>
#include <fftw3.h>

#include "setae/core/constants.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/spectra/isotropic.hpp"
#include "setae/spectra/polyline.hpp"
#include "setae/spectra/power_spectrum.hpp"

namespace {

using namespace setae;
using namespace setae::spectra;

constexpr Index side = 4096;

const topography::HeightMap& map() {
    static const topography::HeightMap map = [] {
        topography::HeightMap made{Array2D(side, side), {1e-6, 1e-6}, false, {}};
        std::mt19937_64 engine(1);
        for (Index i = 0; i < made.heights.size(); ++i)
            made.heights.data()[i] = 1e-9 * (static_cast<double>(engine() >> 11) * 0x1p-53 - 0.5);
        return made;
    }();
    return map;
}

/// Peak resident memory of this process so far [arrays of the size of the map]; Linux only, otherwise 0.
double peak_arrays() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:"))
            return std::stod(line.substr(6)) * 1024.0 / (static_cast<double>(side) * side * 8.0);
    return 0.0;
}

/// Resets the peak memory.
void reset_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

void copy_map(benchmark::State& state) {
    Array2D copy = map().heights;
    for (auto _ : state) {
        std::memcpy(copy.data(), map().heights.data(), sizeof(double) * static_cast<std::size_t>(copy.size()));
        benchmark::ClobberMemory();
    }
}
BENCHMARK(copy_map)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One thread, FFTW_ESTIMATE, out of place, on the map in memory: reference time of the spectrum of a map.
void bare_map_transform(benchmark::State& state) {
    fourier::Buffer<double> in(map().heights.data(), map().heights.data() + map().heights.size());
    fourier::Buffer<std::complex<double>> out(static_cast<std::size_t>(side * (side / 2 + 1)));
    const auto plan = fftw_plan_dft_r2c_2d(static_cast<int>(side), static_cast<int>(side), in.data(),
                                           reinterpret_cast<fftw_complex*>(out.data()), FFTW_ESTIMATE);
    for (auto _ : state) {
        fftw_execute(plan);
        benchmark::ClobberMemory();
    }
    fftw_destroy_plan(plan);
}
BENCHMARK(bare_map_transform)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Transforms of every line along the first index: reference time of the spectrum of line scans of a map.
void bare_line_transforms(benchmark::State& state) {
    fourier::Buffer<double> in(map().heights.data(), map().heights.data() + map().heights.size());
    fourier::Buffer<std::complex<double>> out(static_cast<std::size_t>(side * (side / 2 + 1)));
    const int n = static_cast<int>(side);
    const auto plan = fftw_plan_many_dft_r2c(1, &n, n, in.data(), nullptr, n, 1,
                                             reinterpret_cast<fftw_complex*>(out.data()), nullptr, n, 1, FFTW_ESTIMATE);
    for (auto _ : state) {
        fftw_execute(plan);
        benchmark::ClobberMemory();
    }
    fftw_destroy_plan(plan);
}
BENCHMARK(bare_line_transforms)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Transforms of contiguous lines, which a map along its fast axis does not have: minimum time of its transforms.
void bare_contiguous_line_transforms(benchmark::State& state) {
    fourier::Buffer<double> in(map().heights.data(), map().heights.data() + map().heights.size());
    fourier::Buffer<std::complex<double>> out(static_cast<std::size_t>(side / 2 + 1));
    const auto plan = fftw_plan_dft_r2c_1d(static_cast<int>(side), in.data(),
                                           reinterpret_cast<fftw_complex*>(out.data()), FFTW_ESTIMATE);
    for (auto _ : state)
        for (Index j = 0; j < side; ++j) {
            fftw_execute_dft_r2c(plan, in.data() + j * side, reinterpret_cast<fftw_complex*>(out.data()));
            benchmark::ClobberMemory();
        }
    fftw_destroy_plan(plan);
}
BENCHMARK(bare_contiguous_line_transforms)->Unit(benchmark::kMillisecond)->UseRealTime();

void isotropic_spectrum(benchmark::State& state) {
    const SpectrumOptions options{.threads = {static_cast<int>(state.range(0))}};
    (void)map();
    reset_peak();
    for (auto _ : state) benchmark::DoNotOptimize(isotropic_power_spectrum(map(), options));
    state.counters["arrays"] = peak_arrays();
}
BENCHMARK(isotropic_spectrum)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void line_spectrum_of_map(benchmark::State& state) {
    const SpectrumOptions options{.threads = {static_cast<int>(state.range(0))}};
    reset_peak();
    for (auto _ : state) benchmark::DoNotOptimize(power_spectrum(map(), options));
    state.counters["arrays"] = peak_arrays();
}
BENCHMARK(line_spectrum_of_map)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void tip_cutoff_of_map(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(tip_cutoff(map(), 1e-9, {}, {}, {static_cast<int>(state.range(0))}));
}
BENCHMARK(tip_cutoff_of_map)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// n random points at m wavevectors over five decades.
void polyline(benchmark::State& state) {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> step(0.2, 1.8), height(-1.0, 1.0);
    const Index n = state.range(0), m = state.range(1);
    topography::Profile profile{Array1D(n), Array1D(n), {}};
    double x = 0.0;
    for (Index k = 0; k < n; ++k) {
        profile.positions[k] = x += step(engine);
        profile.heights[k] = height(engine);
    }
    const double lowest = 2.0 * pi / profile.size();
    const Array1D q = Array1D::LinSpaced(m, std::log(lowest), std::log(1e5 * lowest)).exp();
    for (auto _ : state)
        benchmark::DoNotOptimize(polyline_power_spectrum(profile, q, Window::hann, {static_cast<int>(state.range(2))}));
}
BENCHMARK(polyline)
    ->Args({3000, 2000, 1})
    ->Args({3000, 2000, 2})
    ->Args({10000, 10000, 1})
    ->Args({10000, 10000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
