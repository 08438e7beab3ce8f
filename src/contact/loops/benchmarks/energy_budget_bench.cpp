// SPDX-License-Identifier: GPL-3.0-or-later
// Energy budget and course of energies of a loop, per sample, against ∮F dδ alone as Eigen's dot product of the same
// run.
#include <benchmark/benchmark.h>

#include <limits>

#include "setae/core/constants.hpp"
#include "setae/loops/energy_budget.hpp"
#include "synthetic_loop.hpp"

namespace {

using namespace setae;
using namespace setae::loops;

const tests::SyntheticLoop shape{.retraction_work = 0.07, .samples = 400};

/// One loop of 2000 samples with its segments.
struct Prepared {
    Loop loop = shape.make();
    Segments segments = find_segments(loop);
};

void per_sample(benchmark::State& state, const Prepared& prepared) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(prepared.loop.force.size()));
}

void budget(benchmark::State& state) {
    const Prepared prepared;
    const EnergyBudgetInputs inputs{.smooth_sphere = shape.approach,
                                    .largest_contact_area = pi * shape.largest_radius * shape.largest_radius,
                                    .machine_stiffness = std::numeric_limits<double>::infinity()};
    for (auto _ : state) benchmark::DoNotOptimize(energy_budget(prepared.loop, prepared.segments, 0, inputs));
    per_sample(state, prepared);
}
BENCHMARK(budget);

void course(benchmark::State& state) {
    Prepared prepared;
    if (state.range(0) == 0) prepared.loop.contact_radius = Array1D();
    for (auto _ : state)
        benchmark::DoNotOptimize(
            energy_course(prepared.loop, prepared.segments.contacts[0], {.contact = shape.approach}));
    per_sample(state, prepared);
}
BENCHMARK(course)->ArgName("radius_measured")->Arg(1)->Arg(0);

void dot_product(benchmark::State& state) {
    const Prepared prepared;
    const Index n = prepared.loop.force.size();
    for (auto _ : state)
        benchmark::DoNotOptimize(
            (prepared.loop.force.head(n - 1) + prepared.loop.force.tail(n - 1))
                .matrix()
                .dot((prepared.loop.displacement.tail(n - 1) - prepared.loop.displacement.head(n - 1)).matrix()));
    per_sample(state, prepared);
}
BENCHMARK(dot_product);

}  // namespace
