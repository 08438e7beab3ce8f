// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <benchmark/benchmark.h>

#include "adhesive/axisymmetric_sphere.hpp"
#include "adhesive/sphere_loop.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace {

using namespace setae;

/// A sphere to contact and back: points, side, range in 1e-4, law.
void sphere_loop(benchmark::State& state) {
    const half_space::SphereCell sphere{
        .points = state.range(0),
        .side = static_cast<double>(state.range(1)),
        .range = 1e-4 * static_cast<double>(state.range(2)),
        .law = state.range(3) == 0 ? half_space::AttractionLaw::exponential : half_space::AttractionLaw::dugdale};
    half_space::SphereLoop loop;
    for (auto _ : state) loop = half_space::approach_and_part(sphere);
    state.counters["pull_off"] = loop.greatest_pull;
    state.counters["loss"] = loop.loss;
    state.counters["loss_in"] = loop.approach_dissipation;
    state.counters["loss_out"] = loop.separation_dissipation;
    state.counters["steps"] = loop.steps;
}
BENCHMARK(sphere_loop)
    ->ArgNames({"points", "side", "range_1e-4", "dugdale"})
    ->Args({50, 8, 4000, 0})
    ->Args({100, 8, 2828, 0})
    ->Args({200, 8, 2000, 0})
    ->Args({400, 8, 1414, 0})
    ->Args({192, 16, 63662, 1})
    ->Args({192, 12, 12732, 1})
    ->Args({64, 8, 6366, 1})
    ->Args({128, 8, 6366, 1})
    ->Args({256, 8, 6366, 1})
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

/// The same sphere by the axisymmetric equations: range in 1e-4, μ² in hundredths. excess: of the loss into contact
/// over what a JKR sphere has less where it jumps.
void axisymmetric_loop(benchmark::State& state) {
    const half_space::AxisymmetricSphere sphere(1e-4 * static_cast<double>(state.range(0)),
                                                1e-2 * static_cast<double>(state.range(1)));
    half_space::SphereJumps jumps;
    for (auto _ : state) jumps = sphere.jumps();
    state.counters["pull_off"] = jumps.pull_off;
    state.counters["jump_in"] = jumps.jump_in;
    state.counters["loss_in"] = jumps.loss_in;
    state.counters["excess"] = jumps.loss_in + half_space::jkr_energy(jumps.jump_in);
    state.counters["jump_out"] = jumps.jump_out;
    state.counters["loss_out"] = jumps.loss_out;
}
BENCHMARK(axisymmetric_loop)
    ->ArgNames({"range_1e-4", "mu2_1e-2"})
    ->ArgsProduct({{4000, 2828, 2000, 1414}, {42, 20, 10}})
    ->ArgsProduct({{1000, 707, 500}, {42}})
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

/// A rough map, H = 0.8 between 16 pixels and a quarter of the map, from far to full contact and back; e and μ² in
/// thousandths of w and of 1.
void rough_loop(benchmark::State& state) {
    const Index n = state.range(0);
    const auto size = static_cast<double>(n);
    const auto spectrum = spectra::density(spectra::SelfAffine{1.0, 2.0 * pi / (0.25 * size), 0.8, 2.0 * pi / 16.0});
    Array2D heights = synthesis::random_surface(spectrum, {n, n, size, size}, {.key = {1}}).heights;
    const half_space::Grid grid{n, n, size, size};
    const half_space::Body body{.contact_modulus = 1.0, .layer = {}};
    const half_space::Interaction law{1.0, 1.0 / std::sqrt(1e-3 * static_cast<double>(state.range(2)))};
    const double stored = half_space::AdhesiveCell(heights, grid, body, law).conformal_energy();
    heights *= std::sqrt(1e-3 * static_cast<double>(state.range(1)) / stored);
    half_space::AdhesiveLoop loop;
    for (auto _ : state) {
        half_space::AdhesiveCell cell(heights, grid, body, law, {}, {static_cast<int>(state.range(3))});
        loop = half_space::adhesive_loop(cell);
    }
    state.counters["approach_work"] = loop.approach_work;
    state.counters["separation_work"] = loop.separation_work;
    state.counters["steps"] = static_cast<double>(loop.steps.size());
}
BENCHMARK(rough_loop)
    ->ArgNames({"points", "e", "mu2", "threads"})
    ->Args({128, 400, 500, 2})
    ->Args({256, 400, 250, 1})
    ->Args({256, 400, 250, 2})
    ->Args({256, 2, 500, 2})
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->MeasureProcessCPUTime();

}  // namespace
