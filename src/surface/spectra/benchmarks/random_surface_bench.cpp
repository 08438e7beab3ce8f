// SPDX-License-Identifier: GPL-3.0-or-later
#include <complex>
#include <cstring>

#include <benchmark/benchmark.h>
#include <fftw3.h>

#include "setae/fourier/buffer.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace {

using namespace setae;

/// n x n points, roll-off at a sixteenth of the size, cutoff at four pixels.
void random_surface(benchmark::State& state) {
    const Index n = state.range(0);
    const double extent = 1e-9 * static_cast<double>(n);
    const auto C_iso =
        spectra::density(spectra::SelfAffine{1e-27, 6.28e9 * 16.0 / static_cast<double>(n), 0.8, 1.57e9});
    for (auto _ : state) {
        const auto map =
            synthesis::random_surface(C_iso, {n, n, extent, extent}, {.threads = {static_cast<int>(state.range(1))}});
        benchmark::DoNotOptimize(map.heights.data());
    }
}
BENCHMARK(random_surface)
    ->Args({1024, 1})
    ->Args({4096, 1})
    ->Args({4096, 2})
    ->Args({16384, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// c2r transform of FFTW of the same size into existing memory, one thread.
void bare_inverse_transform(benchmark::State& state) {
    const int n = static_cast<int>(state.range(0));
    const auto points = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    fourier::Buffer<std::complex<double>> in(points / 2 + static_cast<std::size_t>(n));
    fourier::Buffer<double> out(points);
    auto* modes = reinterpret_cast<fftw_complex*>(in.data());
    const auto plan = fftw_plan_dft_c2r_2d(n, n, modes, out.data(), FFTW_ESTIMATE);
    std::memset(static_cast<void*>(in.data()), 0, in.size() * sizeof in[0]);
    for (auto _ : state) {
        fftw_execute(plan);
        benchmark::DoNotOptimize(out.data());
    }
    fftw_destroy_plan(plan);
}
BENCHMARK(bare_inverse_transform)->Arg(1024)->Arg(4096)->Arg(16384)->Unit(benchmark::kMillisecond);

void copying_the_map(benchmark::State& state) {
    const auto points = static_cast<std::size_t>(state.range(0) * state.range(0));
    fourier::Buffer<double> from(points), to(points);
    std::memset(from.data(), 0, points * sizeof(double));
    for (auto _ : state) {
        std::memcpy(to.data(), from.data(), points * sizeof(double));
        benchmark::DoNotOptimize(to.data());
    }
}
BENCHMARK(copying_the_map)->Arg(4096)->Arg(16384)->Unit(benchmark::kMillisecond);

void normal_numbers(benchmark::State& state) {
    Array1D numbers(1 << 16);
    for (auto _ : state) {
        numerics::fill_normal({1, 2}, 0, numbers);
        benchmark::DoNotOptimize(numbers.data());
    }
    state.SetItemsProcessed(state.iterations() * numbers.size());
}
BENCHMARK(normal_numbers);

}  // namespace
