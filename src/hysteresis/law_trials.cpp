// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/law_trials.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "setae/adhesion/planted_pairs.hpp"
#include "setae/core/errors.hpp"

namespace setae::hysteresis {
namespace {

/// What one run says of the law that was planted.
struct TrialOutcome {
    RetractionModel best;
    bool not_told_apart = false;
};

TrialOutcome trial(const std::vector<ModelPoints>& models, const ModelPoints& planted, double parameter,
                   const adhesion::ModelScatter& scatter, std::uint64_t seed) {
    const auto values = adhesion::planted_values(planted.points, parameter, scatter, seed);
    auto measured = models;
    for (auto& model : measured)
        for (std::size_t i = 0; i < values.size(); ++i) model.points[i].measured.value = values[i];
    const auto ranking = rank_models(measured, {1});
    const auto alike = ranking.not_told_apart();
    return {ranking.best()->fitted.model, std::any_of(alike.begin(), alike.end(), [&](const ModelScore* score) {
                return score->fitted.model == planted.model;
            })};
}

LawTrials summary(const RetractionModel& planted, const std::vector<TrialOutcome>& outcomes) {
    LawTrials result{.planted = planted, .runs = static_cast<int>(outcomes.size()), .most_taken = {}};
    std::map<std::string, int> taken;
    for (const auto& outcome : outcomes) {
        if (outcome.best == planted) ++result.found;
        else {
            ++taken[outcome.best.name()];
            ++(outcome.not_told_apart ? result.not_told_apart : result.refused);
        }
    }
    const auto most =
        std::max_element(taken.begin(), taken.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most != taken.end()) result.most_taken = most->first;
    return result;
}

}  // namespace

std::vector<LawTrials> law_trials(const std::vector<ModelPoints>& models, const Ranking& ranking,
                                  const TrialOptions& options) {
    if (options.runs < 1) throw InvalidArgument(fmt::format("{} trials of each law; expected 1 or more", options.runs));
    if (!ranking.best()) return {};
    const auto runs = static_cast<std::size_t>(options.runs);
    std::vector<const ModelScore*> planted;
    for (const auto& score : ranking.models)
        if (!score.fitted.model.fitted() || score.fitted.parameter.value > 0.0) planted.push_back(&score);
    std::vector<ModelPoints> ranked;
    for (const auto& model : models)
        if (std::any_of(ranking.models.begin(), ranking.models.end(),
                        [&](const ModelScore& score) { return score.fitted.model == model.model; }))
            ranked.push_back(model);
    std::vector<std::vector<TrialOutcome>> outcomes(planted.size(), std::vector<TrialOutcome>(runs));
    parallel::for_each_index(planted.size() * runs, options.threads, [&](std::size_t i) {
        if (options.cancelled && *options.cancelled) throw Cancelled("trials of laws were stopped");
        const auto& score = *planted[i / runs];
        const auto of = std::find_if(ranked.begin(), ranked.end(),
                                     [&](const ModelPoints& model) { return model.model == score.fitted.model; });
        outcomes[i / runs][i % runs] =
            trial(ranked, *of, score.fitted.parameter.value, ranking.best()->fit.scatter, options.seed + i % runs);
    });
    std::vector<LawTrials> result;
    for (std::size_t k = 0; k < planted.size(); ++k) result.push_back(summary(planted[k]->fitted.model, outcomes[k]));
    return result;
}

}  // namespace setae::hysteresis
