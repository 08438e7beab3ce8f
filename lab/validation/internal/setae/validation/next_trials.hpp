// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "setae/adhesion/next_measurement.hpp"
#include "setae/fields/describe.hpp"
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

/// Output of `setae lab next`.
struct NextOutput {
    std::string recipe;
    int runs = 0;
    std::uint64_t first_seed = 0;
    std::string target;
    std::vector<NextSummary> rows;
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

template <>
struct setae::fields::Described<setae::validation::NextSummary> {
    using T = validation::NextSummary;
    static constexpr std::array rows{
        field<&T::measured>("measured", "recommended measurement"),
        field<&T::n>("runs", "number of data sets"),
        field<&T::stated>("standard_error", "standard error before, root mean square"),
        field<&T::promised>("standard_error_promised", "standard error that `setae study --next` predicted"),
        field<&T::stated_later>("standard_error_found", "standard error with the additional measurement"),
        field<&T::off>("deviation", "rms deviation from the true value, before"),
        field<&T::off_later>("deviation_later", "rms deviation from the true value, with the additional measurement"),
        field<&T::ratio>("ratio", "deviation_later divided by deviation"),
        field<&T::ratio_error>("ratio_standard_error", "standard error of the ratio; null for fewer than two runs"),
    };
    static constexpr Description description{"", "effect of one recommended measurement", rows};
};
static_assert(setae::fields::complete<setae::validation::NextSummary>);

template <>
struct setae::fields::Described<setae::validation::NextOutput> {
    using T = validation::NextOutput;
    static constexpr std::array rows{
        field<&T::recipe>("recipe", "name of the recipe's file, as given"),
        field<&T::runs>("runs", "number of data sets"),
        field<&T::first_seed>("first_seed", "seed of the first data set"),
        field<&T::target>("target", "number whose standard error is to be reduced"),
        made<T>("unit", "unit of standard errors and deviations", [](const T&) { return std::string_view("J/m2"); }),
        field<&T::rows>("rows", "one entry per recommended measurement"),
    };
    static constexpr Description description{"", "effect of measurements that `setae study --next` recommends", rows};
};
static_assert(setae::fields::complete<setae::validation::NextOutput>);
