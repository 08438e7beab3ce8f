// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::benchmarks {

/// What a task works on.
struct TaskInput {
    topography::Measurement measurement;
    parallel::Threads threads;

    [[nodiscard]] const topography::HeightMap& map() const { return std::get<topography::HeightMap>(measurement); }
};

/// Something to be timed. `run` returns numbers that another program's can be compared with; none where the definitions
/// differ.
struct Task {
    std::string name;
    std::string title;
    std::function<Array1D(const TaskInput&)> run;
};

/// What setae does.
[[nodiscard]] const std::vector<Task>& tasks();

/// Bare library calls and passes over memory on the same input.
[[nodiscard]] const std::vector<Task>& yardsticks();

}  // namespace setae::benchmarks
