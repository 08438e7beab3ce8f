// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/simulation/recipe.hpp"
#include "setae/study/study.hpp"

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

/// Called for a data set with its number from 0, its recipe and its folder.
using DataSetVisit = std::function<void(int run, const simulation::Recipe& recipe, const std::string& folder)>;

/// Makes each data set and calls `visit` for it, in parallel. Returns the reason of failure of each run, in order;
/// empty without a failure.
/// @throws what reading the recipe throws; InvalidArgument for fewer than one run; FileError where the folder cannot be
/// made.
[[nodiscard]] std::vector<std::string> for_each_data_set(const DataSets& sets, const DataSetVisit& visit);

/// Makes a recipe's data set in a folder for as long as it is visited.
void with_data_set(const simulation::Recipe& recipe, const std::string& folder, bool keep,
                   const std::function<void()>& visit);

/// The study that a data set brings with it.
[[nodiscard]] study::Study study_of_data_set(const std::string& folder);

}  // namespace setae::validation
