// SPDX-License-Identifier: GPL-3.0-or-later
// Times one task: peer_tasks TASK (--input MAP.npy | --polyline XH.npy | --points N) [--threads N] [--repeat N]
// and prints seconds (the best run), memory beside the input [bytes] and numbers to compare as JSON.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "process_memory.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "tasks.hpp"

namespace {

using namespace setae;

struct Arguments {
    std::string task, input, polyline;
    Index points = 0;
    int threads = 1, repeat = 5;
};

const benchmarks::Task& task_named(const std::string& name) {
    for (const auto* list : {&benchmarks::tasks(), &benchmarks::yardsticks()})
        for (const auto& task : *list)
            if (task.name == name) return task;
    throw InvalidArgument(fmt::format("no task '{}'; --list names them", name));
}

/// A self-affine map of n x n points on a square of 1 m, rms slope 0.1; not periodic, as if measured.
topography::HeightMap made(Index n) {
    spectra::SelfAffine model{1.0, 2.0 * pi * 4.0, 0.8, pi * static_cast<double>(n)};
    constexpr double slope = 0.1;
    model.plateau = std::pow(slope / spectra::rms_slope(model), 2);
    auto map = synthesis::random_surface(spectra::density(model), {n, n, 1.0, 1.0}, {.key = {1}});
    map.periodic = false;
    return map;
}

topography::Measurement input_of(const Arguments& arguments) {
    if (arguments.points > 0) return made(arguments.points);
    if (!arguments.input.empty())
        return formats::read(arguments.input, 0, {.size = std::vector{1.0, 1.0}, .unit = "m"});
    const auto columns = std::get<topography::HeightMap>(
                             formats::read(arguments.polyline, 0, {.size = std::vector{1.0, 1.0}, .unit = "m"}))
                             .heights;
    return topography::Profile{columns.row(0).transpose(), columns.row(1).transpose(), {}};
}

nlohmann::json timed(const benchmarks::Task& task, const benchmarks::TaskInput& input, int repeat) {
    using clock = std::chrono::steady_clock;
    double best = 0.0, memory = 0.0;
    Array1D values;
    for (int run = 0; run < repeat; ++run) {
        benchmarks::forget_peak_memory();
        const auto before = benchmarks::process_memory();
        const auto begin = clock::now();
        values = task.run(input);
        const double seconds = std::chrono::duration<double>(clock::now() - begin).count();
        if (run == 0) memory = benchmarks::process_memory().peak - before.held;
        best = run == 0 ? seconds : std::min(best, seconds);
    }
    return {{"task", task.name},
            {"title", task.title},
            {"seconds", best},
            {"memory", memory},
            {"values", std::vector<double>(values.begin(), values.end())}};
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    bool list = false;
    CLI::App program("times a task beside the field's package");
    program.add_option("task", arguments.task);
    program.add_flag("--list", list, "names of tasks and yardsticks");
    program.add_option("--input", arguments.input, "heights in m of a map of 1 m x 1 m, .npy");
    program.add_option("--polyline", arguments.polyline, "x and h in m, two rows, .npy");
    program.add_option("--points", arguments.points, "a map of so many points a side is made");
    program.add_option("--threads", arguments.threads);
    program.add_option("--repeat", arguments.repeat)->check(CLI::PositiveNumber);
    CLI11_PARSE(program, argc, argv);
    try {
        if (list) {
            for (const auto* tasks : {&benchmarks::tasks(), &benchmarks::yardsticks()})
                for (const auto& task : *tasks) fmt::print("{}\n", task.name);
            return 0;
        }
        const auto& task = task_named(arguments.task);
        const benchmarks::TaskInput input{input_of(arguments), {arguments.threads}};
        fmt::print("{}\n", timed(task, input, arguments.repeat).dump());
    } catch (const Error& error) {
        fmt::print(stderr, "peer_tasks: {}\n", error.what());
        return 1;
    }
    return 0;
}
