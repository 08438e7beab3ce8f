// SPDX-License-Identifier: GPL-3.0-or-later
// Fits of JKR branches of 2000 points on two threads, beside one pass over the same data and one of the bare model.
// Time is that of the clock, CPU that of all threads: on a busy machine CPU over points is the one to read.
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "setae/contact/jkr.hpp"
#include "setae/loops/jkr_fits.hpp"
#include "setae/loops/loop_energy.hpp"
#include "setae/loops/segments.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/parallel/memory.hpp"
#include "synthetic_loop.hpp"

namespace {

using namespace setae;
using namespace setae::loops;

constexpr Index samples = 2000;
constexpr std::size_t loops = 200;
constexpr contact::jkr::Contact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};
constexpr LensAndCounterBody bodies{.radius = 1.25e-3, .counter_youngs_modulus = 1100e9, .counter_poisson_ratio = 0.06};

/// A loading branch each, noise of a hundredth of each channel's range.
const std::vector<BranchData>& branches() {
    static const std::vector<BranchData> made = [] {
        parallel::keep_freed_memory();  // as the program does
        BranchData clean;
        clean.force = Array1D::LinSpaced(samples, 0.8 * contact::jkr::pull_off_at_fixed_load(lens).force, 1e-3);
        clean.contact_radius = contact::jkr::contact_radius_at_force(clean.force, lens);
        clean.displacement = contact::jkr::displacement_at_force(clean.force, lens);
        std::vector<BranchData> all(loops, clean);
        std::uint64_t seed = 0;
        for (BranchData& data : all) {
            std::mt19937_64 generator(++seed);
            const auto noisy = [&](Array1D& series, double& noise) {
                noise = 0.01 * (series.maxCoeff() - series.minCoeff());
                std::normal_distribution<double> normal(0.0, noise);
                for (double& value : series) value += normal(generator);
            };
            noisy(data.force, data.force_noise);
            noisy(data.displacement, data.displacement_noise);
            noisy(data.contact_radius, data.contact_radius_noise);
        }
        return all;
    }();
    return made;
}

void over_all(benchmark::State& state, const std::function<double(const BranchData&)>& work) {
    std::vector<double> results(loops);
    for (auto _ : state) {
        parallel::for_each_index(loops, {2}, [&](std::size_t i) { results[i] = work(branches()[i]); });
        benchmark::DoNotOptimize(results.data());
    }
    // seconds of two cores over points, read as ns where the counter says n
    constexpr double points_per_core = static_cast<double>(loops) * static_cast<double>(samples) / 2.0;
    state.counters["time_per_point_and_core"] = benchmark::Counter(
        points_per_core, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

double least_squares(const BranchData& data) { return fit_radius_force(data, bodies).work_of_adhesion.value; }
double effective_variance(const BranchData& data) {
    return fit_radius_force(data, bodies, RadiusErrors::effective_variance).work_of_adhesion.value;
}
double linear_form(const BranchData& data) { return fit_linear_form(data, bodies).work_of_adhesion.value; }
double depth(const BranchData& data) { return fit_force_displacement(data, bodies).work_of_adhesion.value; }
double joint(const BranchData& data) { return fit_joint(data, bodies).work_of_adhesion.value; }
double rates(const BranchData& data) {
    const EnergyReleaseRate found =
        energy_release_rates(data, bodies.radius, {.value = 0.92e6, .standard_error = 1e3}, {.value = 0.0});
    return found.energy_release_rate.sum() + found.standard_error.sum();
}

/// A closed loop of 2000 samples with its segments.
struct LoopWithSegments {
    Loop loop = tests::SyntheticLoop{.retraction_work = 0.07, .samples = samples / 5}.make();
    Segments segments = find_segments(loop);
};

double closed_loop_energy(const BranchData&) {
    static const LoopWithSegments made;
    return loop_energy(made.loop, made.segments).energy;
}

void memory_pass(benchmark::State& state) {
    over_all(state, [](const BranchData& data) {
        return data.force.sum() + data.displacement.sum() + data.contact_radius.sum();
    });
}
void model_pass(benchmark::State& state) {
    over_all(state,
             [](const BranchData& data) { return contact::jkr::contact_radius_at_force(data.force, lens).sum(); });
}
void route(benchmark::State& state, double (*fit)(const BranchData&)) { over_all(state, fit); }
void all_routes(benchmark::State& state) {
    over_all(state, [](const BranchData& data) {
        return least_squares(data) + effective_variance(data) + linear_form(data) + depth(data) + joint(data) +
               rates(data) + closed_loop_energy(data);
    });
}

BENCHMARK(memory_pass)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(model_pass)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(route, least_squares, least_squares)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(route, effective_variance, effective_variance)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(route, linear_form, linear_form)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(route, force_displacement, depth)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(route, joint, joint)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK_CAPTURE(route, energy_release_rates, rates)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(route, loop_energy, closed_loop_energy)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(all_routes)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
