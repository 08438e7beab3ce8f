// SPDX-License-Identifier: GPL-3.0-or-later
// Every model fitted to a loading branch of 2000 samples with noise of 1 % of each channel, beside bare calls of the
// model's own inverse (one displacement of every sample) in the same program.
#include <benchmark/benchmark.h>

#include <random>

#include "setae/contact/jkr.hpp"
#include "setae/contact/layer.hpp"
#include "setae/contact/maugis_dugdale.hpp"
#include "setae/loops/global_fit.hpp"
#include "setae/loops/model_fits.hpp"

namespace {

using namespace setae;
using namespace setae::loops;

constexpr contact::AdhesiveContact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.04};
constexpr Index samples = 2000;

LensAndCounterBody bodies() {
    LensAndCounterBody result{.radius = lens.radius, .counter_youngs_modulus = 1.1e12, .counter_poisson_ratio = 0.07};
    result.layer_thickness = 100e-6;
    return result;
}

contact::maugis_dugdale::Contact zone() {
    return {lens.radius, lens.contact_modulus, lens.work_of_adhesion,
            contact::maugis_dugdale::cohesive_stress(0.7, lens)};
}

BranchData branch() {
    std::mt19937_64 generator(1);
    std::normal_distribution<double> normal;
    const auto contact = zone();
    BranchData data;
    data.contact_radius =
        Array1D::LinSpaced(samples, 1.1 * contact::maugis_dugdale::pull_off_at_fixed_load(contact).contact_radius,
                           contact::maugis_dugdale::contact_radius_at_force(1e-3, contact));
    data.force = contact::maugis_dugdale::force(data.contact_radius, contact);
    data.displacement = contact::maugis_dugdale::displacement(data.contact_radius, contact);
    for (Array1D* series : {&data.force, &data.displacement, &data.contact_radius}) {
        const double noise = 0.01 * (series->maxCoeff() - series->minCoeff());
        for (double& value : *series) value += noise * normal(generator);
    }
    return data;
}

void fit(benchmark::State& state, ContactModel model, Channels channels, FitErrors errors) {
    const BranchData data = branch();
    for (auto _ : state)
        benchmark::DoNotOptimize(fit_model(data, bodies(), {.model = model, .channels = channels, .errors = errors}));
}

#define SETAE_MODEL(model)                                                                                           \
    BENCHMARK_CAPTURE(fit, model##_force_radius, ContactModel::model, Channels::force_radius,                        \
                      FitErrors::orthogonal_distance)                                                                \
        ->Unit(benchmark::kMillisecond);                                                                             \
    BENCHMARK_CAPTURE(fit, model##_force_displacement, ContactModel::model, Channels::force_displacement,            \
                      FitErrors::orthogonal_distance)                                                                \
        ->Unit(benchmark::kMillisecond);                                                                             \
    BENCHMARK_CAPTURE(fit, model##_all, ContactModel::model, Channels::force_displacement_radius,                    \
                      FitErrors::orthogonal_distance)                                                                \
        ->Unit(benchmark::kMillisecond);                                                                             \
    BENCHMARK_CAPTURE(fit, model##_all_effective_variance, ContactModel::model, Channels::force_displacement_radius, \
                      FitErrors::effective_variance)                                                                 \
        ->Unit(benchmark::kMillisecond)

SETAE_MODEL(hertz);
SETAE_MODEL(dmt);
SETAE_MODEL(jkr);
SETAE_MODEL(maugis_dugdale);
SETAE_MODEL(layer);
SETAE_MODEL(large_strain);
BENCHMARK_CAPTURE(fit, transition_force_radius, ContactModel::transition, Channels::force_radius,
                  FitErrors::orthogonal_distance)
    ->Unit(benchmark::kMillisecond);

void jkr_inverse(benchmark::State& state) {
    const BranchData data = branch();
    for (auto _ : state) benchmark::DoNotOptimize(contact::jkr::contact_radius_at_force(data.force, lens));
}
BENCHMARK(jkr_inverse)->Unit(benchmark::kMillisecond);

void maugis_dugdale_inverse(benchmark::State& state) {
    const BranchData data = branch();
    for (auto _ : state) benchmark::DoNotOptimize(contact::maugis_dugdale::contact_radius_at_force(data.force, zone()));
}
BENCHMARK(maugis_dugdale_inverse)->Unit(benchmark::kMillisecond);

void layer_inverse(benchmark::State& state) {
    const BranchData data = branch();
    const contact::layer::Layer layer(100e-6, 0.5);
    for (auto _ : state) benchmark::DoNotOptimize(contact::layer::contact_radius_at_force(data.force, lens, layer));
}
BENCHMARK(layer_inverse)->Unit(benchmark::kMillisecond);

void ten_branches_globally(benchmark::State& state) {
    std::vector<GlobalBranch> branches(10, {.name = "loop", .data = branch(), .bodies = bodies()});
    for (auto _ : state) benchmark::DoNotOptimize(fit_globally(branches, {.share_work_of_adhesion = true}));
}
BENCHMARK(ten_branches_globally)->Unit(benchmark::kMillisecond);

}  // namespace
