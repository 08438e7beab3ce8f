// SPDX-License-Identifier: GPL-3.0-or-later
// The fit of one surface of examples/closure/standard.toml (five scans, seven maps, six contours), kernels already
// made, beside what cannot be avoided: making one simulated patch and reading it with its tip.
#include <filesystem>

#include <benchmark/benchmark.h>

#include "setae/core/constants.hpp"
#include "setae/simulation/data_set.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/spectral_fit/tip_response.hpp"
#include "setae/study/surface_analysis.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/topography/dilation.hpp"

namespace {

using namespace setae;

const simulation::Recipe& recipe() {
    static const auto read = [] {
        auto all = simulation::read_recipe("examples/closure/standard.toml");
        all.loops.reset();
        all.surfaces.resize(1);
        return all;
    }();
    return read;
}

const std::vector<spectral_fit::ObservedSurface>& observed() {
    static const auto made = [] {
        const auto folder = (std::filesystem::temp_directory_path() / "setae_likelihood_bench").string();
        simulation::make(recipe(), folder);
        const auto study = study::read_study(folder + "/study.toml");
        std::vector<spectral_fit::ObservedSurface> all;
        for (const auto& input : study.surfaces[0].measurements)
            for (const auto& source : study::measurement_sources(input)) {
                auto prepared = source.prepare();
                all.push_back({std::move(prepared.measurement), prepared.trend});
            }
        std::filesystem::remove_all(folder);
        return all;
    }();
    return made;
}

void likelihood_of_one_surface(benchmark::State& state) {
    const spectral_fit::LikelihoodOptions options{.threads = {static_cast<int>(state.range(0))}};
    (void)spectral_fit::likelihood_spectrum(observed(), options);  // kernels
    for (auto _ : state) benchmark::DoNotOptimize(spectral_fit::likelihood_spectrum(observed(), options));
}
BENCHMARK(likelihood_of_one_surface)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void one_patch_and_its_tip(benchmark::State& state) {
    const parallel::Threads threads{static_cast<int>(state.range(0))};
    const auto& surface = recipe().surfaces[0].surface;
    const spectral_fit::TipSimulation simulation{.tip_radius = 5e-6,
                                                 .step = 20e-9,
                                                 .repetitions = 1,
                                                 .radius_response = false,
                                                 .correlation_length = 0.5e-6,
                                                 .threads = threads};
    const auto before = spectral_fit::tip_response(surface.C_iso, simulation);
    for (auto _ : state) benchmark::DoNotOptimize(spectral_fit::tip_response(surface.C_iso, simulation, before));
}
BENCHMARK(one_patch_and_its_tip)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
