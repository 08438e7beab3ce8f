// SPDX-License-Identifier: GPL-3.0-or-later
// bare_calls HEIGHTS.npy CALLS: wall and processor seconds of the library for the spectrum of a map of 10 um or a line
// of 1 um in memory, on one thread: minimum of five runs of CALLS calls, over CALLS.
// python/benchmarks/calls.py measures the same calls of the package.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>

#include "setae/answers/power_spectrum.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/formats/channel.hpp"

namespace {

setae::topography::Measurement heights_in(const std::string& file) {
    const auto channel = setae::formats::open(file, {.unit = "m"}).front();
    const bool line = channel.info.shape.size() == 1;
    return setae::formats::read(file, 0, {.size = std::vector<double>(line ? 1 : 2, line ? 1e-6 : 1e-5), .unit = "m"});
}

}  // namespace

int main(int, char** argv) {
    using namespace setae;
    const auto heights = heights_in(argv[1]);
    const int calls = std::atoi(argv[2]);
    auto input = answers::MeasurementRequest{}.input("array");
    input.in_memory.read = [&heights] { return heights; };
    const answers::PowerSpectrumRequest request{.surface = {.name = "surface", .measurements = {input}},
                                                .analysis = answers::AnalysisRequest{}.analysis()};
    parallel::limit_threads({1});
    double wall = std::numeric_limits<double>::infinity(), processor = wall;
    for (int run = 0; run < 5; ++run) {
        const auto began = std::chrono::steady_clock::now();
        const auto clock = std::clock();
        for (int call = 0; call < calls; ++call)
            if (answers::power_spectrum(request).table.rows() == 0) return 1;
        wall = std::min(wall, std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() / calls);
        processor = std::min(processor, static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC / calls);
    }
    std::printf("%.9f %.9f\n", wall, processor);
}
