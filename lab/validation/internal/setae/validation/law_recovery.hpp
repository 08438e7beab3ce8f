// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "setae/hysteresis/retraction_model.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/simulation/recipe.hpp"
#include "setae/tables/tidy_table.hpp"
#include "setae/validation/validation.hpp"

namespace setae::validation {

struct LawRecoveryOptions {
    int runs = 1;
    std::uint64_t first_seed = 1;  ///< run r makes the recipe with seed first_seed + r
    std::string folder;            ///< where data sets are made; each is removed when it is analysed
    parallel::Threads threads;
    std::function<void(int done)> progress;  ///< called after each data set, one call at a time
};

/// One data set with one law in it, and what its study makes of it.
struct LawRecovery {
    std::string planted, found;  ///< names of laws; `found` is what the ranking takes
    std::uint64_t seed = 0;
    bool possible = false;  ///< another was found, and the planted one is not excluded
    double parameter_planted = std::numeric_limits<double>::quiet_NaN();  ///< W_x [J/m²], of laws that have it
    double parameter = std::numeric_limits<double>::quiet_NaN();          ///< of the planted law, as it was fitted
    double parameter_standard_error = std::numeric_limits<double>::quiet_NaN();
    double surface_left_out = 0.0;  ///< rms deviation of what was found on surfaces that it has not seen [J/m²]

    [[nodiscard]] bool is_found() const { return found == planted; }
};

struct LawRecoveries {
    std::vector<LawRecovery> recoveries;  ///< in the order of laws, then of runs
    std::vector<FailedRun> failed;
};

/// Laws that recipes can plant: reversible, pinning, conformal_loss, opening_work, alone, times a crack tip's factor,
/// and times that of its speed.
[[nodiscard]] std::vector<hysteresis::RetractionModel> plantable_laws();
/// Those that are named, all for "all". @throws InvalidArgument for another name, with the nearest one.
[[nodiscard]] std::vector<hysteresis::RetractionModel> plantable_laws(const std::vector<std::string>& names);

/// The recipe with one law of W_ret in its loops. A crack tip has the recipe's tip factors, 1.5, 1.4, 1.3, … where it
/// has none, or the recipe's laws of speed, v0 = 1, 2, 4, … µm/s and n = 0.6 where it has none; opening takes the
/// recipe's work, twice W_int where it has none.
/// @throws InvalidArgument for a recipe without loops, or a crack tip without a smooth reference.
[[nodiscard]] simulation::Recipe with_law(simulation::Recipe recipe, const hysteresis::RetractionModel& law);

/// Makes the recipe's data set once a law and run, studies it from its files, and looks which law the study finds. Same
/// result for any number of threads; data sets that fail stand in the result.
/// @throws what reading the recipe and with_law() throw; InvalidArgument for fewer than one run.
[[nodiscard]] LawRecoveries law_recoveries(const std::string& recipe,
                                           const std::vector<hysteresis::RetractionModel>& laws,
                                           const LawRecoveryOptions& options);

/// Of one law over its runs.
struct LawSummary {
    std::string planted;
    int runs = 0, found = 0, possible = 0, excluded = 0;
    double parameter_planted = 0.0, parameter = 0.0, parameter_standard_error = 0.0;  ///< means [J/m²]; NaN without one
    double surface_left_out = 0.0;                                                    ///< mean [J/m²]
    std::string most_taken;  ///< of others that were found; empty where none was
};
[[nodiscard]] std::vector<LawSummary> summary(const std::vector<LawRecovery>& recoveries);

[[nodiscard]] tables::TidyTable law_summary_table(const std::vector<LawSummary>& rows);
/// One row a data set, SI.
[[nodiscard]] tables::TidyTable law_recovery_table(const std::vector<LawRecovery>& recoveries);

}  // namespace setae::validation
