// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/simulation/recipe.hpp"
#include "setae/validation/comparison.hpp"

namespace setae::validation {

/// Data sets of one recipe: run r with seed first_seed + r, in a folder of its own that is removed afterwards unless
/// kept.
struct DataSets {
    std::string recipe, folder;
    int runs = 1;
    std::uint64_t first_seed = 1;
    bool keep = false;
    parallel::Threads threads;
    std::function<void(int done)> progress;  ///< one call at a time
};

/// What one data set gave, or why nothing.
struct RunResult {
    std::vector<Comparison> comparisons;
    std::string failure;
};

/// Makes each data set and hands it to `compare`, in parallel; results in the order of runs. A data set that fails
/// keeps its reason.
/// @throws what reading the recipe throws; InvalidArgument for fewer than one run; FileError where the folder cannot be
/// made.
[[nodiscard]] std::vector<RunResult> for_each_data_set(
    const DataSets& sets,
    const std::function<std::vector<Comparison>(int run, const simulation::Recipe& recipe, const std::string& folder)>&
        compare);

}  // namespace setae::validation
