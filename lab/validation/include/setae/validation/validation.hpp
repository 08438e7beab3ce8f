// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/validation/comparison.hpp"

namespace setae::validation {

struct ValidationOptions {
    int runs = 25;
    std::uint64_t first_seed = 1;  ///< run r makes the recipe with seed first_seed + r
    std::string folder;            ///< where data sets are made; each is removed when it is analysed
    bool keep = false;             ///< leave the data sets
    study::SpectrumMethod spectrum = study::SpectrumMethod::likelihood;  ///< what fits and predictions rest on
    bool tip_factor = true;                                              ///< of the likelihood: simulate tips
    bool tip_band = true;  ///< of the likelihood: use tip-based data within their reliable band alone
    parallel::Threads threads;
    std::function<void(int done)> progress;  ///< called after each run, from any thread, one call at a time
};

/// A run that could not be compared, and why.
struct FailedRun {
    std::uint64_t seed = 0;
    std::string reason;
};

struct Validation {
    std::vector<Comparison> comparisons;  ///< in the order of runs
    std::vector<FailedRun> failed;
};

/// Makes the recipe's data set once a run, with a seed of its own, studies it from its files, and compares with what is
/// planted. Same result for any number of threads. Runs that fail stand in the result.
/// @throws what reading the recipe throws; InvalidArgument for fewer than one run; FileError where the folder cannot be
/// made.
[[nodiscard]] Validation run_validation(const std::string& recipe, const ValidationOptions& options);

}  // namespace setae::validation
