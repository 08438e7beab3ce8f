// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "setae/core/constants.hpp"
#include "setae/crack_front/front_loop.hpp"
#include "setae/crack_front/stress_intensity.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace {

using namespace setae;
using namespace setae::crack_front;

topography::HeightMap rough(Index points, double size, double shortest) {
    const auto spectrum =
        spectra::density(spectra::SelfAffine{1.0, 2.0 * pi / (8.0 * shortest), 0.8, 2.0 * pi / shortest});
    return synthesis::random_surface(spectrum, {points, points, size, size}, {.key = {1}});
}

/// K_R of 2048² points, waves down to 16 points, on all the rays of the largest circle.
void rays(benchmark::State& state) {
    const auto map = rough(2048, 2048.0, 16.0);
    const auto grid = ray_grid(1000.0, 16.0);
    for (auto _ : state)
        benchmark::DoNotOptimize(stress_intensity_on_rays(map, {1.0, 16.0, {1024.0, 1024.0}}, grid.angles, grid.radii,
                                                          {static_cast<int>(state.range(0))}));
}
BENCHMARK(rays)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A loop of 2000 steps with 1024 angles, U_el = 0.03 AW, λ_s = a/20.
void loop(benchmark::State& state) {
    const double work = 1.0 / pi, shortest = 0.1;
    const contact::SphereOnFlat sphere{1.0, 0.75};
    const auto map = rough(512, 128.0 * shortest, shortest);
    auto intensity = stress_intensity_on_rays(map, {0.75, shortest, {6.4, 6.4}}, 1024, {321, 0.0, shortest / 16.0});
    intensity.values *= std::sqrt(0.03 * work / intensity.stored_energy);
    CircularFront front(sphere, equivalent_work(intensity.values, intensity.points, work, 0.75));
    for (auto _ : state) {
        front.begin_at(0.0);
        for (int k = 0; k < 2000; ++k)
            benchmark::DoNotOptimize(front.solve(HeldDisplacement{k < 1000 ? 5e-4 * k : 0.5 - 8e-4 * (k - 1000)}));
    }
}
BENCHMARK(loop)->Unit(benchmark::kMillisecond);

}  // namespace
