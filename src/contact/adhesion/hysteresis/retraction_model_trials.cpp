// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/retraction_model_trials.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "both_branches.hpp"
#include "setae/adhesion/scatter_effects.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::hysteresis {
namespace {

using adhesion::ScatterEffects;
using numerics::RandomKey;

/// Result of one run for the known model.
struct TrialOutcome {
    RetractionModel best;
    bool possible = false;
};

TrialOutcome outcome_of(const std::vector<RetractionModel>& models, const RetractionModel& true_model,
                        const std::vector<RankedPair>& pairs, const std::optional<Estimate>& known_work) {
    const auto ranking = rank_models(models, pairs, known_work, {1});
    const auto* best = ranking.best();
    return {best ? best->fitted.model : true_model,
            std::ranges::any_of(ranking.possible(),
                                [&](const ModelScore* score) { return score->fitted.model == true_model; })};
}

ModelTrials summary(const RetractionModel& true_model, const std::vector<TrialOutcome>& outcomes) {
    ModelTrials result{.true_model = true_model, .runs = static_cast<int>(outcomes.size()), .most_taken = {}};
    std::map<std::string, int> taken;
    for (const auto& outcome : outcomes) {
        if (outcome.best == true_model) ++result.found;
        else {
            ++taken[outcome.best.name()];
            ++(outcome.possible ? result.possible : result.excluded);
        }
    }
    const auto most =
        std::max_element(taken.begin(), taken.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most != taken.end()) result.most_taken = most->first;
    return result;
}

}  // namespace

std::vector<RankedPair> simulated_pairs(const std::vector<RankedPair>& pairs, const ModelScore& score,
                                        std::uint64_t seed) {
    const RandomKey key{seed};
    const auto n = static_cast<Index>(pairs.size());
    const auto noise = [&](std::uint64_t stream) {
        return numerics::normal_numbers(numerics::substream(key, stream), 0, n);
    };
    const Array1D noise_of_approach = noise(0), noise_of_retraction = noise(1);
    ScatterEffects on_approach(score.approach_scatter, numerics::substream(key, 2)),
        on_retraction(score.fit.scatter, numerics::substream(key, 3));
    const auto& model = score.fitted.model;
    const BothBranches before(model, pairs, {});
    Eigen::VectorXd truth = before.at(score.work_of_adhesion.value, score.fitted.parameter.value);
    truth.tail(truth.size() - BothBranches::shared_count) =
        before.drawn(numerics::normal_numbers(numerics::substream(key, 4), 0, before.directions()).matrix());
    auto simulated = pairs;
    std::vector<double> errors;
    for (Index i = 0; i < n; ++i) {
        auto& pair = simulated[static_cast<std::size_t>(i)];
        const double work =
            before.predicted(Branch::approach, i, truth) + on_approach.of(pair.pair.rough.name, pair.pair.soft.name);
        errors.push_back(before.noise(Branch::approach)[i] * noise_of_approach[i]);
        pair.approach.value.value = pair.pair.approach->value = std::max(0.0, work + errors.back());
    }
    const BothBranches after(model, simulated, {});
    for (Index i = 0; i < n; ++i) {
        auto& pair = simulated[static_cast<std::size_t>(i)];
        pair.retraction.value.value =
            after.predicted(Branch::retraction, i, truth, -errors[static_cast<std::size_t>(i)]) +
            on_retraction.of(pair.pair.rough.name, pair.pair.soft.name) +
            after.noise(Branch::retraction)[i] * noise_of_retraction[i];
    }
    return simulated;
}

std::vector<ModelTrials> model_trials(const std::vector<RankedPair>& pairs, const Ranking& ranking,
                                      const std::optional<Estimate>& known_work, const TrialOptions& options) {
    if (options.runs < 1)
        throw InvalidArgument(fmt::format("{} trials of each model; expected 1 or more", options.runs));
    const auto* best = ranking.best();
    if (!best) return {};
    const auto runs = static_cast<std::size_t>(options.runs);
    std::vector<RetractionModel> models;
    std::vector<ModelScore> true_scores;
    for (const auto& score : ranking.models) {
        models.push_back(score.fitted.model);
        if (score.fitted.model.fitted() && !(score.fitted.parameter.value > 0.0)) continue;
        true_scores.push_back(score);
        true_scores.back().fit.scatter = best->fit.scatter;
        true_scores.back().approach_scatter = best->approach_scatter;
    }
    std::vector<std::vector<TrialOutcome>> outcomes(true_scores.size(), std::vector<TrialOutcome>(runs));
    parallel::for_each_index(true_scores.size() * runs, options.threads, [&](std::size_t i) {
        if (options.cancelled && *options.cancelled) throw Cancelled("the trials of the models were stopped");
        const auto& score = true_scores[i / runs];
        outcomes[i / runs][i % runs] =
            outcome_of(models, score.fitted.model, simulated_pairs(pairs, score, options.seed + i % runs), known_work);
    });
    std::vector<ModelTrials> result;
    for (std::size_t k = 0; k < true_scores.size(); ++k)
        result.push_back(summary(true_scores[k].fitted.model, outcomes[k]));
    return result;
}

}  // namespace setae::hysteresis
