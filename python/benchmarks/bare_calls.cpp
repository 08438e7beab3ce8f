// SPDX-License-Identifier: GPL-3.0-or-later
// bare_calls MAP.npy: seconds of wall and of processor that the library alone takes for the spectrum of heights in
// memory, on one thread, the least of three runs; python/benchmarks/calls.py does the same through the package.
#include <chrono>
#include <cstdio>
#include <ctime>
#include <limits>

#include "setae/answers/power_spectrum.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/formats/channel.hpp"

int main(int, char** argv) {
    using namespace setae;
    const auto heights = formats::read(argv[1], 0, {.size = std::vector{1e-5, 1e-5}, .unit = "m"});
    auto input = answers::MeasurementRequest{}.input("array");
    input.in_memory.read = [&heights] { return heights; };
    answers::PowerSpectrumRequest request{.surface = {.name = "surface", .measurements = {input}},
                                          .analysis = answers::AnalysisRequest{}.analysis()};
    parallel::limit_threads({1});
    double wall = std::numeric_limits<double>::infinity(), processor = wall;
    for (int run = 0; run < 3; ++run) {
        const auto began = std::chrono::steady_clock::now();
        const auto clock = std::clock();
        const auto answer = answers::power_spectrum(request);
        if (answer.table.rows() == 0) return 1;
        wall = std::min(wall, std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
        processor = std::min(processor, static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC);
    }
    std::printf("%.6f %.6f\n", wall, processor);
}
