// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/hysteresis/ranking.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::hysteresis {

struct TrialOptions {
    int runs = 20;           ///< number of runs per model, > 0
    std::uint64_t seed = 1;  ///< seed of the first run; the others have the next seeds
    parallel::Threads threads;
    const std::atomic<bool>* cancelled = nullptr;
};

/// Recovery of a known model from simulated pairs.
struct ModelTrials {
    RetractionModel true_model;
    int runs = 0;
    int found = 0;     ///< number of runs in which it is Ranking::best()
    int possible = 0;  ///< number of runs in which it is not the best, but not excluded
    int excluded = 0;  ///< number of runs in which another model is clearly better, or a constant refuses the model
    std::string most_taken;  ///< the other model that was best most often; empty without one
};

/// Both works of adhesion of pairs as simulated by a model: inputs drawn within their standard errors, scatter of
/// pairs, surfaces and elastomers of both branches, own noise.
[[nodiscard]] std::vector<RankedPair> simulated_pairs(const std::vector<RankedPair>& pairs, const ModelScore& score,
                                                      std::uint64_t seed);

/// Test of whether such measurements can distinguish the models.
///
/// Each model of a ranking serves as the known model on its pairs with its θ and its W_int, the scatter of the best
/// one, and all other inputs drawn with their standard errors; then all models are ranked with the simulated values. A
/// model whose θ is 0 equals another one and is left out. A seed gives equal numbers with any number of threads.
/// @throws InvalidArgument for runs < 1; Cancelled where the options say so.
[[nodiscard]] std::vector<ModelTrials> model_trials(const std::vector<RankedPair>& pairs, const Ranking& ranking,
                                                    const std::optional<Estimate>& known_work,
                                                    const TrialOptions& options);

}  // namespace setae::hysteresis

namespace setae::fields {

template <>
struct Described<hysteresis::ModelTrials> {
    using T = hysteresis::ModelTrials;
    static constexpr std::array rows{
        made<T>("planted", "retraction model of the simulated pairs", [](const T& of) { return of.true_model.name(); }),
        inner<&T::true_model>(),
        field<&T::runs>("runs", "number of data sets"),
        field<&T::found>("found", "number of data sets in which the true model was ranked best"),
        field<&T::possible>("possible",
                            "number of data sets in which another model was ranked best and the true model was not "
                            "excluded"),
        field<&T::excluded>(
            "excluded",
            "number of data sets in which the true model was excluded: another model was clearly better, "
            "or a constant error was found"),
        inner<&T::most_taken>(),
    };
    static constexpr Description description{"", "recovery of a known retraction model from simulated pairs", rows};
};
static_assert(complete<hysteresis::ModelTrials>);

}  // namespace setae::fields
