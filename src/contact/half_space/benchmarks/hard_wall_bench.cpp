// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <benchmark/benchmark.h>
#include <fftw3.h>

#include "setae/core/constants.hpp"
#include "setae/half_space/hard_wall.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace {

using namespace setae;

/// H = 0.8 between 16 pixels and a quarter of the map, rms slope 0.1, mean pressure 0.05 h'E*.
half_space::HardWall rough(Index points) {
    const auto size = static_cast<double>(points);
    const auto spectrum = spectra::density(spectra::SelfAffine{1.0, 2.0 * pi / (0.25 * size), 0.8, 2.0 * pi / 16.0});
    const synthesis::SurfaceGrid grid{points, points, size, size};
    const double scale = 0.1 / synthesis::expected_roughness(spectrum, grid).rms_slope;
    return {.grid = {points, points, size, size},
            .body = {.contact_modulus = 1.0, .layer = {}},
            .heights = scale * synthesis::random_surface(spectrum, grid, {.key = {1}}).heights,
            .control = half_space::MeanPressure{0.005},
            .hardness = {}};
}

/// One transform there and one back by FFTW alone, one thread, planned as setae plans.
void fftw_pair(benchmark::State& state) {
    const auto n = static_cast<int>(state.range(0));
    double* map = fftw_alloc_real(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    fftw_complex* modes = fftw_alloc_complex(static_cast<std::size_t>(n) * static_cast<std::size_t>(n / 2 + 1));
    std::fill_n(map, static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 0.0);
    const fftw_plan there = fftw_plan_dft_r2c_2d(n, n, map, modes, FFTW_ESTIMATE),
                    back = fftw_plan_dft_c2r_2d(n, n, modes, map, FFTW_ESTIMATE);
    for (auto _ : state) {
        fftw_execute(there);
        fftw_execute(back);
    }
    fftw_destroy_plan(there);
    fftw_destroy_plan(back);
    fftw_free(map);
    fftw_free(modes);
}
BENCHMARK(fftw_pair)->RangeMultiplier(2)->Range(512, 4096)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Displacements of pressures: a pair, with the multiplication between.
void displacements(benchmark::State& state) {
    const Index n = state.range(0);
    half_space::ElasticOperator response({n, n, 1.0, 1.0}, {.contact_modulus = 1.0, .layer = {}},
                                         half_space::Edges::periodic, {static_cast<int>(state.range(1))});
    Array2D map = Array2D::Random(n, n);
    response.displacements(map, map);
    for (auto _ : state) response.displacements(map, map);
}
BENCHMARK(displacements)->ArgsProduct({{512, 1024, 2048, 4096}, {1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();

void hard_wall(benchmark::State& state) {
    const auto problem = rough(state.range(0));
    half_space::HardWallContact contact;
    for (auto _ : state) contact = half_space::solve(problem, {.threads = {static_cast<int>(state.range(1))}});
    state.counters["iterations"] = static_cast<double>(contact.iterations);
    state.counters["pairs"] = static_cast<double>(contact.transform_pairs);
    state.counters["duality_gap"] = contact.certificate.duality_gap;
}
BENCHMARK(hard_wall)->ArgsProduct({{512, 1024, 2048, 4096}, {1, 2}})->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
