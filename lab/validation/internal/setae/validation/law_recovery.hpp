// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/fields/describe.hpp"
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
    std::string true_model, found;  ///< names of models; `found` is the model that is ranked best
    std::uint64_t seed = 0;
    bool possible = false;  ///< another model is ranked best, and the true one is not excluded
    /// W_x [J/m²], for models with this parameter
    double true_parameter = std::numeric_limits<double>::quiet_NaN();
    double parameter = std::numeric_limits<double>::quiet_NaN();  ///< fitted parameter of the true model
    double parameter_standard_error = std::numeric_limits<double>::quiet_NaN();
    double surface_left_out = 0.0;  ///< leave-one-surface-out error (rms) of the model that is ranked best [J/m²]

    [[nodiscard]] bool is_found() const { return found == true_model; }
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
    std::string true_model;
    int runs = 0, found = 0, possible = 0, excluded = 0;
    double true_parameter = 0.0, parameter = 0.0, parameter_standard_error = 0.0;  ///< means [J/m²]; NaN without one
    double surface_left_out = 0.0;                                                 ///< mean [J/m²]
    std::string most_taken;  ///< most frequent of the other models found; empty without one

    /// The fitted parameter; empty for models without one.
    [[nodiscard]] std::optional<Estimate> fitted_parameter() const {
        if (!std::isfinite(parameter)) return std::nullopt;
        return Estimate{.value = parameter, .standard_error = parameter_standard_error};
    }
};
[[nodiscard]] std::vector<ModelSummary> summary(const std::vector<ModelRecovery>& recoveries);

[[nodiscard]] tables::TidyTable model_summary_table(const std::vector<ModelSummary>& rows);
/// One row a data set, SI.
[[nodiscard]] tables::TidyTable model_recovery_table(const std::vector<ModelRecovery>& recoveries);

/// Output of `setae lab loops` with mechanisms.
struct MechanismsOutput {
    std::string recipe;
    int runs = 0;
    std::uint64_t first_seed = 0;
    std::vector<ModelSummary> mechanisms;
};

}  // namespace setae::validation

template <>
struct setae::fields::Described<setae::validation::ModelSummary> {
    using T = validation::ModelSummary;
    static constexpr std::array rows{
        field<&T::true_model>("planted", "retraction model of the simulated loops"),
        field<&T::runs>("runs", "number of data sets"),
        field<&T::found>("found", "number of data sets in which the true model was ranked best"),
        field<&T::possible>(
            "possible",
            "number of data sets in which another model was ranked best and the true model was not excluded"),
        field<&T::excluded>("excluded",
                            "number of data sets in which the true model was excluded: another model was clearly "
                            "better, or a constant error was found"),
        value<&T::surface_left_out>("rms_residual_surface_left_out", "J/m2",
                                    "leave-one-surface-out error (rms) of the model that was ranked best"),
        made<T>("work_per_true_area", "W_x", "J/m2",
                "fitted W_x, mean over the data sets, with the mean standard error",
                [](const T& of) { return of.fitted_parameter(); }),
        made_value<T>(
            "work_per_true_area_planted", "J/m2", "true W_x of the simulated loops",
            [](const T& of) { return of.fitted_parameter() ? std::optional(of.true_parameter) : std::nullopt; }),
        inner<&T::true_parameter>(),
        inner<&T::parameter>(),
        inner<&T::parameter_standard_error>(),
        inner<&T::most_taken>(),
    };
    static constexpr Description description{"", "one retraction model over its data sets", rows};
};
static_assert(setae::fields::complete<setae::validation::ModelSummary>);

template <>
struct setae::fields::Described<setae::validation::MechanismsOutput> {
    using T = validation::MechanismsOutput;
    static constexpr std::array rows{
        field<&T::recipe>("recipe", "name of the recipe's file, as given"),
        field<&T::runs>("runs", "number of data sets of each mechanism"),
        field<&T::first_seed>("first_seed", "seed of the first data set"),
        field<&T::mechanisms>("mechanisms", "one entry per mechanism"),
    };
    static constexpr Description description{"", "known mechanisms in the loops of a recipe, with --mechanism", rows};
};
static_assert(setae::fields::complete<setae::validation::MechanismsOutput>);
