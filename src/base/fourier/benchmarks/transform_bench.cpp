// SPDX-License-Identifier: GPL-3.0-or-later
#include <complex>

#include <benchmark/benchmark.h>

#include "plain_sum.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"

namespace {

using namespace setae;

/// A direct sum of 1000 points at 100 wavevectors: the cost per term.
void plain_sum(benchmark::State& state) {
    const Array1D x = Array1D::Random(1000), c = Array1D::Random(1000), q = 1e4 * Array1D::Random(100);
    for (auto _ : state) benchmark::DoNotOptimize(fourier::nonuniform_transform_by_sum(x, c, q, {1}));
    state.SetItemsProcessed(state.iterations() * 100000);
}
BENCHMARK(plain_sum)->Unit(benchmark::kMillisecond);

/// n points at n wavevectors over a range that needs a grid of 4n points.
void nonuniform(benchmark::State& state) {
    const Index n = state.range(0);
    const Array1D x = Array1D::Random(n), c = Array1D::Random(n), q = 1.5 * static_cast<double>(n) * Array1D::Random(n);
    for (auto _ : state)
        benchmark::DoNotOptimize(fourier::nonuniform_transform(x, c, q, {static_cast<int>(state.range(1))}));
    state.SetItemsProcessed(state.iterations() * n);
}
BENCHMARK(nonuniform)
    ->Args({10000, 1})
    ->Args({100000, 1})
    ->Args({100000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
