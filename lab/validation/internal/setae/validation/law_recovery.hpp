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

struct ModelRecoveryOptions {
    int runs = 1;
    std::uint64_t first_seed = 1;  ///< run r makes the recipe with seed first_seed + r
    std::string folder;            ///< where data sets are made; each is removed when it is analysed
    parallel::Threads threads;
    std::function<void(int done)> progress;  ///< called after each data set, one call at a time
};

/// One data set with a known retraction model, and the result of its study.
struct ModelRecovery {
    std::string planted, found;  ///< names of models; `found` is the model that is ranked best
    std::uint64_t seed = 0;
    bool possible = false;  ///< another model is ranked best, and the true one is not excluded
    /// W_x [J/m²], for models with this parameter
    double true_parameter = std::numeric_limits<double>::quiet_NaN();
    double parameter = std::numeric_limits<double>::quiet_NaN();  ///< fitted parameter of the true model
    double parameter_standard_error = std::numeric_limits<double>::quiet_NaN();
    double surface_left_out = 0.0;  ///< leave-one-surface-out error (rms) of the model that is ranked best [J/m²]

    [[nodiscard]] bool is_found() const { return found == planted; }
};

struct ModelRecoveries {
    std::vector<ModelRecovery> recoveries;  ///< in the order of models, then of runs
    std::vector<FailedRun> failed;
};

/// Retraction models that recipes can simulate: reversible, pinning, conformal_loss, opening_work, without a tip
/// factor, times a crack tip's factor, and times that of its speed.
[[nodiscard]] std::vector<hysteresis::RetractionModel> simulated_models();
/// Those that are named, all for "all". @throws InvalidArgument for another name, with the nearest one.
[[nodiscard]] std::vector<hysteresis::RetractionModel> simulated_models(const std::vector<std::string>& names);

/// The recipe with one retraction model in its loops. A crack tip has the recipe's tip factors, else 1.5, 1.4, 1.3, …,
/// or the recipe's rate dependence, else v0 = 1, 2, 4, … µm/s and n = 0.6; opening has the recipe's work, else twice
/// W_int.
/// @throws InvalidArgument for a recipe without loops, or a crack tip without a smooth reference.
[[nodiscard]] simulation::Recipe with_model(simulation::Recipe recipe, const hysteresis::RetractionModel& law);

/// Makes the recipe's data set once per model and run, analyses the study from its files, and compares the model found.
/// Equal result for any number of threads; failed data sets are listed in the result.
/// @throws what reading the recipe and with_model() throw; InvalidArgument for fewer than one run.
[[nodiscard]] ModelRecoveries model_recoveries(const std::string& recipe,
                                               const std::vector<hysteresis::RetractionModel>& laws,
                                               const ModelRecoveryOptions& options);

/// Summary of one model over its runs.
struct ModelSummary {
    std::string planted;
    int runs = 0, found = 0, possible = 0, excluded = 0;
    double true_parameter = 0.0, parameter = 0.0, parameter_standard_error = 0.0;  ///< means [J/m²]; NaN without one
    double surface_left_out = 0.0;                                                 ///< mean [J/m²]
    std::string most_taken;  ///< most frequent of the other models found; empty without one
};
[[nodiscard]] std::vector<ModelSummary> summary(const std::vector<ModelRecovery>& recoveries);

[[nodiscard]] tables::TidyTable model_summary_table(const std::vector<ModelSummary>& rows);
/// One row a data set, SI.
[[nodiscard]] tables::TidyTable model_recovery_table(const std::vector<ModelRecovery>& recoveries);

}  // namespace setae::validation
