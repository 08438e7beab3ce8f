// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/hysteresis.hpp"
#include "bulk_speeds.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "hysteresis_pairs.hpp"
#include "loop_residuals.hpp"
#include "loss_decomposition.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/hysteresis/smooth_limit.hpp"
#include "setae/study/study_result.hpp"
#include "smooth_limits.hpp"

namespace setae::study {
namespace {

using hysteresis::FittedModel;
using hysteresis::ModelScore;
using hysteresis::RankedPair;
using hysteresis::Ranking;
using hysteresis::RetractionModel;
using hysteresis::RetractionPair;
using hysteresis::Tip;

/// ln of the normal density of a residual.
double log_density(double residual, double standard_error) {
    const double z = residual / standard_error;
    return -0.5 * z * z - std::log(standard_error) - 0.5 * std::log(2.0 * pi);
}

/// 3/2 π R W_ret [N], where the sphere is given.
std::optional<TracedValue> pull_off_of(const TracedValue& work_retraction, const RetractionPair& pair) {
    if (!pair.radius) return std::nullopt;
    return setae::propagated([](const std::vector<double>& in) { return 1.5 * pi * in[0] * in[1]; },
                             {work_retraction, *pair.radius});
}

/// A model with predictions from roughness.
LikelierModel likelier_of(const PairModel& law) {
    const auto& roughness = *law.pair.from_roughness;
    const auto work = hysteresis::predicted_retraction(law.fitted, roughness);
    return {law.fitted.model, work, pull_off_of(work, roughness)};
}

/// Pairs whose k is outside the simulated range, in one warning.
std::vector<Alert> pinning_alerts(const std::vector<PairHysteresis>& pairs) {
    std::vector<std::string> beyond;
    for (const auto& pair : pairs) {
        if (!pair.pinning || (pair.pinning->approach.measured && pair.pinning->retraction.measured)) continue;
        beyond.push_back(fmt::format("{} × {}", pair.surface, pair.elastomer));
    }
    if (beyond.empty()) return {};
    return {{"PINNING_EXTRAPOLATED", fmt::format("{}", fmt::join(beyond, ", ")),
             "k of the pinning models is extrapolated: no simulated front has this U_el/AW and this number N "
             "of Larkin lengths; the standard error of k includes the distance",
             "use the pinning models as estimates for these pairs; see the simulated range in "
             "docs/validation/crack-front.md"}};
}

class HysteresisOf {
public:
    HysteresisOf(const StudyResult& result, parallel::Threads threads)
        : result_(result), threads_(threads), prepared_(prepared_pairs(result)), pairs_(prepared_.pairs) {
        found_.skipped = std::move(prepared_.skipped);
        found_.elastomers = std::move(prepared_.elastomers);
    }

    [[nodiscard]] Hysteresis all(const std::optional<hysteresis::TrialOptions>& trials) {
        std::vector<hysteresis::RetractionPair> measured;
        for (const auto& pair : pairs_) {
            if (!pair.ranked()) continue;
            ++found_.measured_pairs;
            if (pair.conforms()) ++found_.conforming_pairs;
            measured.push_back(*pair.from_roughness);
        }
        found_.conforming_range = hysteresis::pairs_in_full_contact(measured);
        found_.all = ranking(by_last_points(false));
        if (found_.conforming_pairs < found_.measured_pairs) found_.conforming = ranking(by_last_points(true));
        else found_.conforming = found_.all;
        rank_by_area();
        for (const auto& pair : pairs_) found_.pairs.push_back(of(pair));
        decompose();
        decide();
        found_.smooth_limits = smooth_limits(result_, found_.all);
        found_.alerts = pinning_alerts(found_.pairs);
        for (auto& alert : speeds_beyond_bulk(found_)) found_.alerts.push_back(std::move(alert));
        if (trials) {
            const bool conforming = found_.conforming.best() != nullptr;
            found_.trials = hysteresis::model_trials(seen_by(by_last_points(conforming)),
                                                     conforming ? found_.conforming : found_.all,
                                                     result_.study.work_of_adhesion, *trials);
        }
        return std::move(found_);
    }

private:
    /// A pair for a ranking; empty for pairs that it leaves out.
    using View = std::function<std::optional<RankedPair>(const PreparedPair&)>;
    [[nodiscard]] std::vector<RankedPair> seen_by(const View& view) const;
    [[nodiscard]] Ranking ranking(const View& view) const;
    /// Pairs by the last points of their retraction, all or those in spontaneous full contact.
    [[nodiscard]] static View by_last_points(bool conforming_alone);
    void rank_by_area();
    [[nodiscard]] const Ranking* ranking_of(const PreparedPair& pair) const;
    [[nodiscard]] PairHysteresis of(const PreparedPair& pair);
    [[nodiscard]] std::vector<ModelWork> works_of(const PreparedPair& pair, const Ranking& ranking) const;
    void decompose();
    [[nodiscard]] bool excluded_by_all(const ModelScore& best, const ModelScore& other) const;
    void decide();

    const StudyResult& result_;
    parallel::Threads threads_;
    PreparedPairs prepared_;
    const std::deque<PreparedPair>& pairs_;
    std::vector<PairModel> laws_;
    Hysteresis found_;
};

std::vector<RankedPair> HysteresisOf::seen_by(const View& view) const {
    std::vector<RankedPair> seen;
    for (const auto& pair : pairs_)
        if (auto ranked = view(pair)) seen.push_back(std::move(*ranked));
    return seen;
}

Ranking HysteresisOf::ranking(const View& view) const {
    std::vector<Tip> tips{Tip::none, Tip::reference};
    if (std::ranges::any_of(found_.elastomers, [](const auto& times) { return static_cast<bool>(times.edge); }))
        tips.push_back(Tip::speed);
    return hysteresis::rank_models(hysteresis::retraction_models(tips), seen_by(view), result_.study.work_of_adhesion,
                                   threads_);
}

HysteresisOf::View HysteresisOf::by_last_points(bool conforming_alone) {
    return [=](const PreparedPair& pair) -> std::optional<RankedPair> {
        if (!pair.ranked() || (conforming_alone && !pair.conforms())) return std::nullopt;
        return RankedPair{*pair.as_measured, pair.measured_approach(), {*pair.retraction(), pair.retraction_inputs()}};
    };
}

void HysteresisOf::rank_by_area() {
    for (const auto& pair : pairs_) found_.pairs_by_area += pair.of_area ? 1 : 0;
    found_.by_area = ranking([](const PreparedPair& pair) -> std::optional<RankedPair> {
        if (!pair.of_area) return std::nullopt;
        return RankedPair{*pair.by_area, pair.measured_approach(), *pair.of_area};
    });
}

const Ranking* HysteresisOf::ranking_of(const PreparedPair& pair) const {
    if (pair.conforms() && found_.conforming.best()) return &found_.conforming;
    return found_.all.best() ? &found_.all : nullptr;
}

std::vector<ModelWork> HysteresisOf::works_of(const PreparedPair& pair, const Ranking& ranking) const {
    std::vector<ModelWork> works;
    for (const auto& score : ranking.models) {
        ModelWork work{
            .model = score.fitted.model, .work_retraction = {.value = undefined}, .reason = {}, .log_likelihood = {}};
        work.reason = pair.from_roughness->lacks(work.model);
        if (work.reason.empty())
            work.work_retraction = hysteresis::predicted_retraction(score.fitted, *pair.from_roughness).estimate();
        for (const auto& left_out : score.left_out)
            if (left_out.surface_left_out && left_out.surface == pair.measured.surface &&
                left_out.elastomer == pair.measured.elastomer)
                work.log_likelihood = log_density(left_out.residual, left_out.standard_error);
        works.push_back(std::move(work));
    }
    return works;
}

PairHysteresis HysteresisOf::of(const PreparedPair& pair) {
    PairHysteresis found;
    const auto& roughness = *pair.from_roughness;
    found.surface = pair.measured.surface;
    found.elastomer = pair.measured.elastomer;
    found.energy_share = roughness.energy_share();
    found.conforms = pair.conforms();
    found.tip_factor = roughness.tip_factor;
    if (roughness.speed_factor) found.speed_factor = roughness.speed_factor->factor;
    if (pair.ranked()) found.measured_retraction = pair.retraction();
    FittedModel fitted{.model = hysteresis::model_without_measurements(), .parameter = {}, .scatter = {}};
    PairModel law{pair, fitted, {}, false};
    if (const auto* ranking = ranking_of(pair)) {
        found.models = works_of(pair, *ranking);
        found.pinning = hysteresis::pinning_of(roughness);
        const auto *best = ranking->best(), *answer = ranking->best_with_smooth_limit();
        if (roughness.lacks(best->fitted.model).empty()) {
            law.fitted = best->fitted;
            law.scatter = best->fit.scatter;
            law.ranked = true;
        }
        if (answer && roughness.lacks(answer->fitted.model).empty()) {
            fitted = answer->fitted;
            found.choice = ranking == &found_.conforming ? ModelChoice::conforming_pairs : ModelChoice::all_pairs;
        }
        if (law.ranked && !hysteresis::has_smooth_limit(law.fitted.model)) found.likelier = likelier_of(law);
    }
    laws_.push_back(law);
    found.model = fitted.model;
    found.contact_fraction = pair.measured.contact.area_fraction;
    found.work_approach =
        fitted.work_of_adhesion ? hysteresis::predicted_approach(fitted, roughness) : *pair.measured.partial_contact;
    found.work_retraction = hysteresis::predicted_retraction(fitted, roughness);
    found.pull_off_force = pull_off_of(found.work_retraction, roughness);
    if (!roughness.radius || !roughness.pressing)
        found.loop = Outcome<hysteresis::PredictedRetraction>::missing(
            fmt::format("elastomer {} has no {}", found.elastomer, roughness.radius ? "preload" : "sphere_radius"));
    else if (auto loop = hysteresis::predicted_retraction_loop(fitted, roughness)) found.loop = std::move(*loop);
    else
        found.loop = Outcome<hysteresis::PredictedRetraction>::missing(
            "W_app is 0: stretching the soft side costs more than the contact gains");
    // a rate-dependent edge has no 3/2 πR W_ret: every force has a G of its own
    if (found.loop && fitted.model.tip == Tip::speed) found.pull_off_force = found.loop->pull_off_force;
    found.residuals = loop_residuals(result_, found);
    return found;
}

void HysteresisOf::decompose() {
    auto losses = decomposed_losses(laws_);
    for (std::size_t i = 0; i < losses.pairs.size(); ++i) found_.pairs[i].decomposition = std::move(losses.pairs[i]);
    found_.joint = std::move(losses.joint);
}

/// W_ret by one model minus that by another, for pairs with their models.
TracedValue difference_of(FittedModel one, FittedModel other, const RetractionPair& pair) {
    one.scatter = other.scatter = {};
    const auto first = hysteresis::predicted_retraction(one, pair),
               second = hysteresis::predicted_retraction(other, pair);
    return {first.value - second.value, combined({{1.0, first.components}, {-1.0, second.components}})};
}

/// Whether the ranking of all pairs has the same best model and excludes the other.
bool HysteresisOf::excluded_by_all(const ModelScore& best, const ModelScore& other) const {
    const auto* of_all = found_.all.best();
    if (!of_all || of_all->fitted.model != best.fitted.model) return false;
    return std::ranges::none_of(found_.all.possible(),
                                [&](const ModelScore* score) { return score->fitted.model == other.fitted.model; });
}

/// For the best model and the likeliest other possible model, the pair with the largest difference in standard errors
/// of the prediction.
void HysteresisOf::decide() {
    const bool by_conforming = found_.conforming.best() != nullptr;
    const auto& ranking = by_conforming ? found_.conforming : found_.all;
    const ModelScore *best = ranking.best(), *other_law = nullptr;
    for (const auto* score : ranking.possible())
        if (score != best && !other_law && !excluded_by_all(*best, *score)) other_law = score;
    if (!best || !other_law) return;
    const auto &first = *best, &second = *other_law;
    for (const auto& pair : pairs_) {
        if (by_conforming && !pair.conforms()) continue;
        const auto& roughness = *pair.from_roughness;
        if (!roughness.lacks(first.fitted.model).empty() || !roughness.lacks(second.fitted.model).empty()) continue;
        const auto one = hysteresis::predicted_retraction(first.fitted, roughness),
                   other = hysteresis::predicted_retraction(second.fitted, roughness);
        const double error = std::max(one.standard_error(), other.standard_error());
        const double apart = error > 0.0 ? std::abs(one.value - other.value) / error : 0.0;
        if (found_.deciding && !(apart > found_.deciding->standard_errors)) continue;
        const auto budget = budget_of(difference_of(first.fitted, second.fitted, roughness));
        found_.deciding = DecidingPair{pair.measured.surface,
                                       pair.measured.elastomer,
                                       first.fitted.model.name(),
                                       second.fitted.model.name(),
                                       one.value,
                                       other.value,
                                       budget.empty() ? "" : budget.front().input,
                                       apart};
    }
}

}  // namespace

Hysteresis hysteresis_of(const StudyResult& result, const std::optional<hysteresis::TrialOptions>& trials,
                         parallel::Threads threads) {
    if (!result.work_of_adhesion)
        throw UndefinedDataError("hysteresis cannot be predicted: " + result.work_of_adhesion.reason);
    return HysteresisOf(result, threads).all(trials);
}

}  // namespace setae::study
