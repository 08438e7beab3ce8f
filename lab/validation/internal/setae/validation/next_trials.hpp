// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "setae/adhesion/next_measurement.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/simulation/recipe.hpp"
#include "setae/tables/tidy_table.hpp"
#include "setae/validation/validation.hpp"

namespace setae::validation {

struct NextTrialOptions {
    int runs = 100;
    std::uint64_t first_seed = 1;  ///< as ValidationOptions
    std::string target = "W_int";  ///< as study::target_of()
    std::vector<std::string>
        measured;        ///< names of the candidates to be measured; empty: the three with the largest gain in run 0
    std::string folder;  ///< where data sets are made; each is removed when it is analysed
    parallel::Threads threads;
    std::function<void(int done)> progress;  ///< called after each run, from any thread, one call at a time
};

/// A number before and after one further measurement.
struct NextTrial {
    int run = 0;
    std::string measured;               ///< "lens_1", "E02 on A", "C"
    double off = 0.0, off_later = 0.0;  ///< found − true value without and with the measurement [J/m²]
    double stated = 0.0;                ///< standard error without it [J/m²]
    double promised = 0.0;              ///< standard error that was predicted for it [J/m²]
    double stated_later = 0.0;          ///< standard error with it [J/m²]
};

/// All runs of one measurement: roots of mean squares [J/m²].
struct NextSummary {
    std::string measured;
    int n = 0;
    double stated = 0.0, promised = 0.0, stated_later = 0.0;  ///< standard errors
    double off = 0.0, off_later = 0.0;                        ///< found − true value
    double ratio = 0.0;                                       ///< off_later/off
    double ratio_error = 0.0;                                 ///< its standard error, by leaving runs out one at a time
};

struct NextTrials {
    std::vector<NextTrial> trials;
    std::vector<FailedRun> failed;
};

/// The name of a candidate: of the input, of the pair "E02 on A" that gets another loop, of the surface "C" that is
/// measured again.
[[nodiscard]] std::string name_of(const adhesion::Candidate& candidate);

/// The recipe with a measured candidate: an input with half its standard error, and half the deviation of its true
/// value; another loop on the pair; all scans, maps and contours of the surface once more, at other positions. All else
/// is drawn as before.
/// @throws InvalidArgument for an input without a standard error in the recipe.
[[nodiscard]] simulation::Recipe recipe_with(simulation::Recipe recipe, const adhesion::Candidate& candidate);

/// Test of the predictions of `setae study --next`: each run makes and analyses the recipe's data set, then adds each
/// of the measurements, analyses again, and compares with the true values. Equal result for any number of threads.
/// @throws as run_validation; InvalidArgument for a measurement that is none of the study's candidates, and as
/// study::target_of(), both of run 0.
[[nodiscard]] NextTrials next_trials(const std::string& recipe, const NextTrialOptions& options);

/// One row per measurement, in the order of trials. A row of fewer than two runs has no ratio_error.
[[nodiscard]] std::vector<NextSummary> summary(const std::vector<NextTrial>& trials);

/// Predicted and found values for readers [mJ/m²], and every trial [J/m²].
[[nodiscard]] tables::TidyTable next_summary_table(const std::string& target, const std::vector<NextSummary>& rows);
[[nodiscard]] tables::TidyTable next_trials_table(const std::vector<NextTrial>& trials);

}  // namespace setae::validation
