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
    std::uint64_t first_seed = 1;  ///< run r uses the recipe with seed first_seed + r
    std::string folder;            ///< folder of the data sets; each is removed after its analysis
    bool keep = false;             ///< whether the data sets are kept
    study::SpectrumMethod spectrum = study::SpectrumMethod::likelihood;  ///< spectrum of fits and predictions
    bool tip_factor = true;                                              ///< for likelihoods: simulate tips
    bool tip_band = true;  ///< for likelihoods: use tip-based data within their reliable band only
    parallel::Threads threads;
    std::function<void(int done)> progress;  ///< called after each run, from any thread, one call at a time
};

/// A run that could not be compared, with the reason.
struct FailedRun {
    std::uint64_t seed = 0;
    std::string reason;
};

struct Validation {
    std::vector<Comparison> comparisons;  ///< in the order of runs
    std::vector<FailedRun> failed;
};

/// Makes the recipe's data set once per run, with a seed of its own, analyses the study from its files, and compares
/// the results with the true values. Equal result for any number of threads. Failed runs are listed in the result.
/// @throws what reading the recipe throws; InvalidArgument for fewer than one run; FileError where the folder cannot be
/// made.
[[nodiscard]] Validation run_validation(const std::string& recipe, const ValidationOptions& options);

}  // namespace setae::validation
