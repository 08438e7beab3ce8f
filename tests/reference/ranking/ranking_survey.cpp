// SPDX-License-Identifier: GPL-3.0-or-later
#include "ranking_survey.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "setae/hysteresis/retraction_model_trials.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::reference {
namespace {

using hysteresis::Distinction;
using hysteresis::Law;
using hysteresis::ModelScore;
using hysteresis::RankedPair;
using hysteresis::Ranking;
using hysteresis::RetractionModel;
using hysteresis::Tip;

constexpr RetractionModel reversible{Law::reversible, Tip::none};

const ModelScore* score_of(const Ranking& ranking, const RetractionModel& model) {
    const auto found =
        std::ranges::find_if(ranking.models, [&](const ModelScore& score) { return score.fitted.model == model; });
    return found == ranking.models.end() ? nullptr : &*found;
}

double quantile(std::vector<double> values, double p) {
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1) + 0.5)];
}

/// The likeliest model that no constant refuses: odds count against it.
const ModelScore* likeliest(const Ranking& ranking) {
    const auto found =
        std::ranges::find_if(ranking.models, [](const ModelScore& score) { return !score.bias.refuses_model; });
    return found == ranking.models.end() ? nullptr : &*found;
}

void count(ModelCalibration& result, const Ranking& ranking, const RetractionModel& truth) {
    const auto* own = score_of(ranking, truth);
    if (!own) return;
    ++result.sets;
    const auto possible = ranking.possible();
    result.left += static_cast<int>(possible.size());
    const auto distinction = own->odds_against.distinction();
    if (own->bias.refuses_model) ++result.refused;
    else if (likeliest(ranking) == own) ++result.best;
    else if (distinction == Distinction::clearly_better) ++result.beaten_clearly;
    else if (distinction == Distinction::better) ++result.beaten_better;
    else ++result.not_distinguished;
    const bool wins = likeliest(ranking) == own;
    if (!wins && !own->bias.refuses_model && distinction != Distinction::cannot_be_distinguished)
        ++result.beaten_by[likeliest(ranking)->fitted.model.name()];
    for (const auto& other : ranking.models) {
        if (!wins || &other == own) continue;
        if (other.odds_against.distinction() == Distinction::clearly_better) ++result.claims_clearly;
        if (other.odds_against.distinction() == Distinction::better) ++result.claims_better;
    }
    const auto is_possible = [&](const RetractionModel& model) {
        return std::ranges::any_of(possible, [&](const ModelScore* score) { return score->fitted.model == model; });
    };
    if (!is_possible(reversible)) ++result.reversible_excluded;
    else if (is_possible(truth)) ++result.reversible_undecided;
}

}  // namespace

std::vector<ModelScore> true_models(const Ranking& ranking, double scatter) {
    const double part = scatter / std::sqrt(3.0);
    std::vector<ModelScore> models;
    for (const auto& score : ranking.models) {
        if (score.fitted.model.fitted() && !(score.fitted.parameter.value > 0.0)) continue;
        models.push_back(score);
        models.back().fit.scatter = models.back().approach_scatter = {part, part, part};
    }
    return models;
}

ModelCalibration calibrate(const std::vector<RetractionModel>& models, const std::vector<RankedPair>& pairs,
                           const ModelScore& truth, int sets, std::uint64_t first_seed) {
    ModelCalibration result{.model = truth.fitted.model.name()};
    std::vector<double> log_odds;
    for (int set = 0; set < sets; ++set) {
        const auto ranking = hysteresis::rank_models(
            models, hysteresis::simulated_pairs(pairs, truth, first_seed + static_cast<std::uint64_t>(set)), {}, {1});
        count(result, ranking, truth.fitted.model);
        const auto *own = score_of(ranking, truth.fitted.model), *other = score_of(ranking, reversible);
        if (own && other) log_odds.push_back(own->left_out_log_likelihood - other->left_out_log_likelihood);
    }
    result.odds_lower = quantile(log_odds, 0.05);
    result.odds_median = quantile(log_odds, 0.5);
    result.odds_upper = quantile(log_odds, 0.95);
    return result;
}

BiasCalibration calibrate_bias(const std::vector<RankedPair>& pairs, const ModelScore& truth, double constant, int sets,
                               std::uint64_t first_seed) {
    BiasCalibration result{.model = truth.fitted.model.name()};
    for (int set = 0; set < sets; ++set) {
        auto simulated = hysteresis::simulated_pairs(pairs, truth, first_seed + static_cast<std::uint64_t>(set));
        for (auto& pair : simulated) pair.retraction.value.value += constant;
        const auto ranking = hysteresis::rank_models({truth.fitted.model}, simulated, {}, {1});
        if (ranking.models.empty()) continue;
        ++result.sets;
        result.refused += ranking.models.front().bias.refuses_model ? 1 : 0;
    }
    return result;
}

std::vector<JitteredOdds> jitter(const std::vector<RetractionModel>& models, const std::vector<RankedPair>& pairs,
                                 double deviation, int sets, std::uint64_t first_seed) {
    std::vector<JitteredOdds> results;
    for (const auto& score : hysteresis::rank_models(models, pairs, {}, {1}).models) {
        const auto& odds = score.odds_against;
        results.push_back(
            {.model = score.fitted.model.name(), .value = odds.value, .lower = odds.lower, .upper = odds.upper});
    }
    std::map<std::string, std::vector<double>> found;
    for (int set = 0; set < sets; ++set) {
        auto moved = pairs;
        const Array1D normal = numerics::normal_numbers({first_seed + static_cast<std::uint64_t>(set)}, 0,
                                                        static_cast<Index>(pairs.size()));
        for (std::size_t i = 0; i < moved.size(); ++i)
            moved[i].retraction.value.value += deviation * normal[static_cast<Index>(i)];
        const auto ranking = hysteresis::rank_models(models, moved, {}, {1});
        for (auto& result : results)
            for (const auto& score : ranking.models) {
                if (score.fitted.model.name() != result.model) continue;
                found[result.model].push_back(score.odds_against.value);
                result.refused += score.bias.refuses_model ? 1 : 0;
                if (likeliest(ranking) == &score) {
                    ++result.likeliest;
                    continue;
                }
                switch (score.odds_against.distinction()) {
                    case Distinction::cannot_be_distinguished: ++result.cannot_be_distinguished; break;
                    case Distinction::better: ++result.better; break;
                    case Distinction::clearly_better: ++result.clearly_better; break;
                }
            }
    }
    for (auto& result : results) {
        result.jittered_lower = quantile(found[result.model], 0.05);
        result.jittered_median = quantile(found[result.model], 0.5);
        result.jittered_upper = quantile(found[result.model], 0.95);
    }
    return results;
}

}  // namespace setae::reference
