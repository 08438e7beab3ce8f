// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/hysteresis.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include <fmt/format.h>

#include "setae/adhesion/contact_scales.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/hysteresis/pinning_law.hpp"
#include "setae/roughness/energy_below.hpp"
#include "setae/study/loop_dependence.hpp"
#include "setae/study/study_result.hpp"

namespace setae::study {
namespace {

using hysteresis::FittedModel;
using hysteresis::Law;
using hysteresis::ModelPoints;
using hysteresis::ModelScore;
using hysteresis::Ranking;
using hysteresis::RetractionModel;
using hysteresis::RetractionPair;
using hysteresis::Tip;

/// φ of an elastomer's references, the mean of both branches over all of them.
std::optional<TracedValue> tip_factor_of(const StudyResult& result, const std::string& elastomer) {
    std::vector<Estimate> approach, retraction;
    for (const auto& reference : result.references) {
        if (reference.elastomer != elastomer || !(reference.approach.value > 0.0) ||
            !(reference.retraction.value > 0.0))
            continue;
        approach.push_back(reference.approach);
        retraction.push_back(reference.retraction);
    }
    if (approach.empty()) return std::nullopt;
    const std::vector<Estimate> both{mean_of(retraction), mean_of(approach)};
    return TracedValue(setae::propagated([](const Array1D& x) { return x[0] / x[1]; }, both),
                       fmt::format("W_ret/W_app of the reference on {}", elastomer));
}

/// U_el by bands of a factor of 4, finest first, over all of it.
std::vector<double> band_shares_of(const spectra::Spectrum& curve) {
    const auto cumulative = roughness::cumulative_parameters(curve);
    const auto &q = cumulative.wavevector, &energy = cumulative.elastic_energy_per_modulus;
    const Index last = q.size() - 1;
    if (last < 1 || !(energy[last] > 0.0)) return {};
    const auto below = [&](double wavevector) { return roughness::energy_below(cumulative, wavevector); };
    constexpr double factor = 4.0;
    std::vector<double> shares;
    for (double upper = q[last]; upper > q[0]; upper /= factor)
        shares.push_back((below(upper) - below(upper / factor)) / energy[last]);
    return shares;
}

/// ln of the normal density of a residual.
double log_density(double residual, double standard_error) {
    const double z = residual / standard_error;
    return -0.5 * z * z - std::log(standard_error) - 0.5 * std::log(2.0 * pi);
}

/// The preload that the study states, else the force under which the measured contact area is reached.
std::optional<hysteresis::Pressing> pressing_of(const ElastomerResult& elastomer, const PairResult& pair,
                                                const RetractionPair& base) {
    if (elastomer.input.preload) return hysteresis::Pressing{.maximum_force = *elastomer.input.preload};
    if (!base.radius || !pair.contact_area || !pair.approach || !(pair.approach->value > 0.0)) return std::nullopt;
    const double force =
        contact::jkr::force(std::sqrt(*pair.contact_area / pi),
                            {base.radius->value, base.soft.contact_modulus.value, pair.approach->value});
    return hysteresis::Pressing{.maximum_force = std::max(0.0, force)};
}

/// The mean of what loops on the pair state, else of what loops on its elastomer do; nothing where none does.
std::optional<TracedValue> machine_stiffness_of(const StudyResult& result, const PairResult& pair) {
    const auto stated = [&](bool on_pair) {
        std::vector<TracedValue> found;
        for (const auto& e : result.experiments) {
            if (e.failed() || e.input.excluded() || !e.input.machine_stiffness || e.input.elastomer != pair.elastomer)
                continue;
            if (on_pair && (e.input.reference || e.input.surface != pair.surface)) continue;
            const auto& value = *e.input.machine_stiffness;
            found.emplace_back(value, input_name(value, e.input.file + ".machine_stiffness"));
        }
        return found;
    };
    auto found = stated(true);
    if (found.empty()) found = stated(false);
    if (found.empty()) return std::nullopt;
    const double share = 1.0 / static_cast<double>(found.size());
    TracedValue mean;
    for (const auto& one : found) {
        mean.value += share * one.value;
        mean.components = combined({{1.0, mean.components}, {share, one.components}});
    }
    return mean;
}

/// The factor of the pair's edge: about W_ret as measured, else about twice W_int; nothing where something is not known.
std::optional<hysteresis::SpeedFactor> speed_factor_of(const RetractionPair& pair, const PairDrive& drive,
                                                       const std::optional<Estimate>& read) {
    if (!pair.edge_speed || !pair.radius || !(pair.contact_area || pair.pressing)) return std::nullopt;
    hysteresis::TracedSphere sphere{.radius = *pair.radius,
                                    .contact_modulus = pair.soft.contact_modulus,
                                    .contact_radius = {}};
    if (pair.machine_stiffness) sphere.machine_stiffness = *pair.machine_stiffness;
    const double work = pair.work_of_adhesion.value;
    if (pair.contact_area)
        sphere.contact_radius = setae::propagated(
            [](const std::vector<double>& in) { return std::sqrt(in[0] / pi); }, {*pair.contact_area});
    else
        sphere.contact_radius = contact::jkr::contact_radius_at_force(
            pair.pressing->maximum_force, {pair.radius->value, pair.soft.contact_modulus.value, work});
    const double speed = drive.drive.retraction_speed;
    try {
        if (read && read->value > 0.0)
            return speed_factor_of_reading(sphere, *pair.edge_speed, speed, drive.reading_time, read->value);
        return speed_factor(sphere, *pair.edge_speed, speed, drive.reading_time, 2.0 * work);
    } catch (const InvalidArgument&) {
        return std::nullopt;  // a law so steep that no edge of it can be followed
    }
}

/// A pair of the study with what lives as long as laws look at it.
struct PreparedPair {
    const PairResult& measured;
    const ElastomerResult& elastomer;
    adhesion::RoughnessInContact roughness;
    std::optional<RetractionPair> from_roughness, as_measured;

    [[nodiscard]] const std::optional<Estimate>& retraction() const {
        return measured.retraction ? measured.retraction : measured.pull_off;
    }
    [[nodiscard]] const Components& retraction_inputs() const {
        return measured.retraction ? measured.retraction_inputs : measured.pull_off_inputs;
    }
    [[nodiscard]] bool ranked() const { return measured.approach && measured.approach->value > 0.0 && retraction(); }
    [[nodiscard]] bool conforms() const {
        return from_roughness->energy_share() <= hysteresis::conforming_energy_share;
    }
};

class HysteresisOf {
public:
    HysteresisOf(const StudyResult& result, parallel::Threads threads) : result_(result), threads_(threads) {
        prepare();
    }

    [[nodiscard]] Hysteresis all(const std::optional<hysteresis::TrialOptions>& trials) {
        for (const auto& pair : pairs_) {
            if (!pair.ranked()) continue;
            ++found_.measured_pairs;
            if (pair.conforms()) ++found_.conforming_pairs;
        }
        found_.all = ranking(false);
        if (found_.conforming_pairs < found_.measured_pairs) found_.conforming = ranking(true);
        else found_.conforming = found_.all;
        for (const auto& pair : pairs_) found_.pairs.push_back(of(pair));
        decide();
        if (trials) {
            const bool conforming = found_.conforming.best() != nullptr;
            found_.trials = hysteresis::law_trials(models_of(conforming).points,
                                                   conforming ? found_.conforming : found_.all, *trials);
        }
        return std::move(found_);
    }

private:
    void prepare();
    /// Found once an elastomer.
    [[nodiscard]] const ElastomerTimes& times_of(const std::string& elastomer);
    /// Laws with the pairs they are ranked by; those that lack something, and what.
    struct Models {
        std::vector<ModelPoints> points;
        std::vector<hysteresis::UnrankedModel> lacking;
    };
    [[nodiscard]] Models models_of(bool conforming_alone) const;
    [[nodiscard]] Ranking ranking(bool conforming_alone) const;
    [[nodiscard]] const Ranking* ranking_of(const PreparedPair& pair) const;
    [[nodiscard]] PairHysteresis of(const PreparedPair& pair) const;
    [[nodiscard]] std::vector<ModelWork> works_of(const PreparedPair& pair, const Ranking& ranking) const;
    [[nodiscard]] Outcome<LossDecomposition> decomposed(const PreparedPair& pair, const FittedModel& model) const;
    [[nodiscard]] bool told_apart_by_all(const ModelScore& best, const ModelScore& other) const;
    void decide();

    const StudyResult& result_;
    parallel::Threads threads_;
    std::deque<PreparedPair> pairs_;  // whose places do not change
    Hysteresis found_;
};

/// Why laws say nothing of a pair; empty where they do.
std::string reason_against(const SurfaceResult& surface, const PairResult& pair, double work_of_adhesion,
                           const ElastomerResult& elastomer) {
    if (surface.failed()) return surface.error;
    if (!pair.modified) return "no modulus is known";
    const hysteresis::PairState state{.area_ratio = pair.area_ratio,
                                      .work_of_adhesion = work_of_adhesion,
                                      .surface_energy = elastomer.input.surface_energy.value};
    return state.conforming_gain() > 0.0 ? "" : "stretching the soft side costs more than W_int gains";
}

const ElastomerTimes& HysteresisOf::times_of(const std::string& elastomer) {
    for (const auto& times : found_.elastomers)
        if (times.elastomer == elastomer) return times;
    return found_.elastomers.emplace_back(
        ElastomerTimes{elastomer, edge_speed_of(result_, elastomer), relaxation_of(result_, elastomer)});
}

void HysteresisOf::prepare() {
    for (const auto& pair : result_.pairs) {
        const auto& surface = result_.surface(pair.surface);
        const auto& elastomer = result_.elastomer(pair.elastomer);
        if (auto reason = reason_against(surface, pair, result_.traced_work_of_adhesion.value, elastomer);
            !reason.empty()) {
            found_.skipped.push_back({pair.surface, pair.elastomer, std::move(reason)});
            continue;
        }
        const auto& spectrum = surface.used();
        auto& prepared = pairs_.emplace_back(PreparedPair{
            pair, elastomer, adhesion::roughness_in_contact(spectrum.parameters, spectrum.spread, pair.seen), {}, {}});
        RetractionPair base{.rough = {surface.name, prepared.roughness.parameters, prepared.roughness.spread},
                            .soft = elastomer.soft_side(),
                            .work_of_adhesion = result_.traced_work_of_adhesion,
                            .tip_factor = tip_factor_of(result_, pair.elastomer),
                            .band_shares = band_shares_of(spectrum.curve)};
        if (elastomer.input.sphere_radius) base.radius = elastomer.traced_radius();
        base.pressing = pressing_of(elastomer, pair, base);
        base.machine_stiffness = machine_stiffness_of(result_, pair);
        const auto& times = times_of(pair.elastomer);
        if (times.edge) base.edge_speed = times.edge->law;
        base.relaxation = times.relaxation;
        auto measured = base;
        measured.approach = pair.traced_approach();
        if (pair.contact_area) measured.contact_area = TracedValue(*pair.contact_area, pair.contact_area_inputs);
        if (const auto drive = drive_of(result_, pair.surface, pair.elastomer)) {
            base.drive = {drive->drive.approach_speed, drive->drive.retraction_speed, drive->drive.hold_time};
            base.speed_factor = speed_factor_of(measured, *drive, prepared.retraction());
            measured.drive = base.drive;
            measured.speed_factor = base.speed_factor;
        }
        prepared.from_roughness.emplace(std::move(base));
        prepared.as_measured.emplace(std::move(measured));
    }
}

HysteresisOf::Models HysteresisOf::models_of(bool conforming_alone) const {
    Models models;
    std::vector<Tip> tips{Tip::none, Tip::reference};
    if (std::ranges::any_of(found_.elastomers, [](const auto& times) { return static_cast<bool>(times.edge); }))
        tips.push_back(Tip::speed);
    for (const auto& model : hysteresis::retraction_models(tips)) {
        ModelPoints points{model, {}};
        std::string reason;
        for (const auto& pair : pairs_) {
            if (!pair.ranked() || (conforming_alone && !pair.conforms())) continue;
            if (reason.empty()) reason = pair.as_measured->lacks(model);
            if (reason.empty())
                points.points.push_back(hysteresis::retraction_point(model, *pair.as_measured,
                                                                     {*pair.retraction(), pair.retraction_inputs()}));
        }
        if (reason.empty()) models.points.push_back(std::move(points));
        else models.lacking.push_back({model, reason});
    }
    return models;
}

Ranking HysteresisOf::ranking(bool conforming_alone) const {
    const auto models = models_of(conforming_alone);
    auto ranking = hysteresis::rank_models(models.points, threads_);
    ranking.unranked.insert(ranking.unranked.end(), models.lacking.begin(), models.lacking.end());
    return ranking;
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

/// E_loss of the measured works over the contact area, with the sphere's jumps in the pair's machine.
TracedValue loss_of_works(const PreparedPair& pair, const TracedValue& retraction) {
    const auto& measured = *pair.as_measured;
    const double preload = measured.pressing ? measured.pressing->maximum_force : 0.0;
    const bool area_known = measured.contact_area.has_value(), machine_known = measured.machine_stiffness.has_value();
    return setae::propagated(
        [&](const std::vector<double>& in) {
            const double approach = in[0], radius = in[2], modulus = in[3];
            hysteresis::HystereticSphere sphere{radius, modulus, approach, std::max(approach, in[1])};
            const double force =
                area_known ? std::max(0.0, contact::jkr::force(std::sqrt(in[4] / pi), sphere.approach())) : preload;
            hysteresis::Pressing pressing{.maximum_force = force};
            if (machine_known) pressing.machine_stiffness = in[5];
            return hysteresis::sphere_loop(sphere, pressing).energy_loss();
        },
        {*measured.approach, retraction, *measured.radius, measured.soft.contact_modulus,
         measured.contact_area.value_or(TracedValue()), measured.machine_stiffness.value_or(TracedValue())});
}

Outcome<LossDecomposition> HysteresisOf::decomposed(const PreparedPair& pair, const FittedModel& model) const {
    using Missing = Outcome<LossDecomposition>;
    const auto& measured = *pair.as_measured;
    const auto retraction =
        pair.measured.retraction ? pair.measured.traced_retraction() : pair.measured.traced_pull_off();
    if (!pair.ranked() || !retraction) return Missing::missing("no work of adhesion is measured on both branches");
    if (!measured.radius || !(measured.contact_area || measured.pressing))
        return Missing::missing("the radius of the sphere and the contact area or a preload are not known");
    const auto loop = hysteresis::predicted_retraction_loop(model, measured);
    if (!loop) return Missing::missing("W_app is 0");
    LossDecomposition result;
    const auto recorded = pair.measured.traced_loss();
    result.of_works = !recorded;
    result.measured = recorded ? *recorded : loss_of_works(pair, *retraction);
    result.shares = loop->shares;
    result.unexplained = {result.measured.value - loop->energy_loss.value,
                          combined({{1.0, result.measured.components}, {-1.0, loop->energy_loss.components}})};
    return result;
}

PairHysteresis HysteresisOf::of(const PreparedPair& pair) const {
    PairHysteresis found;
    const auto& roughness = *pair.from_roughness;
    found.surface = pair.measured.surface;
    found.elastomer = pair.measured.elastomer;
    found.energy_share = roughness.energy_share();
    found.conforms = pair.conforms();
    found.tip_factor = roughness.tip_factor;
    if (roughness.speed_factor) found.speed_factor = roughness.speed_factor->factor;
    if (pair.ranked()) found.measured_retraction = pair.retraction();
    FittedModel fitted{.model = {Law::conformal_loss, Tip::none}, .parameter = {}, .scatter = {}};
    if (const auto* ranking = ranking_of(pair)) {
        found.models = works_of(pair, *ranking);
        found.choice = ranking == &found_.conforming ? ModelChoice::conforming_pairs : ModelChoice::all_pairs;
        if (const auto* best = ranking->best(); roughness.lacks(best->fitted.model).empty()) fitted = best->fitted;
        else found.choice = ModelChoice::assumed;
    }
    found.model = fitted.model;
    found.contact_fraction = pair.measured.contact.area_fraction;
    found.work_approach = *pair.measured.partial_contact;
    found.work_retraction = hysteresis::predicted_retraction(fitted, roughness);
    if (roughness.radius)
        found.pull_off_force = setae::propagated([](const std::vector<double>& in) { return 1.5 * pi * in[0] * in[1]; },
                                                 {found.work_retraction, *roughness.radius});
    if (!roughness.radius || !roughness.pressing)
        found.loop = Outcome<hysteresis::PredictedRetraction>::missing(
            fmt::format("elastomer {} has no {}", found.elastomer, roughness.radius ? "preload" : "sphere_radius"));
    else if (auto loop = hysteresis::predicted_retraction_loop(fitted, roughness)) found.loop = std::move(*loop);
    else
        found.loop = Outcome<hysteresis::PredictedRetraction>::missing(
            "no work of adhesion on approach: stretching costs all that the contact gains");
    found.decomposition = decomposed(pair, fitted);
    return found;
}

/// W_ret by one model less that by another, pairs on their laws.
TracedValue difference_of(FittedModel one, FittedModel other, const RetractionPair& pair) {
    one.scatter = other.scatter = {};
    const auto first = hysteresis::predicted_retraction(one, pair),
               second = hysteresis::predicted_retraction(other, pair);
    return {first.value - second.value, combined({{1.0, first.components}, {-1.0, second.components}})};
}

/// Whether the ranking of all pairs has the same best law and tells the other from it.
bool HysteresisOf::told_apart_by_all(const ModelScore& best, const ModelScore& other) const {
    const auto* of_all = found_.all.best();
    if (!of_all || of_all->fitted.model != best.fitted.model) return false;
    return std::ranges::none_of(found_.all.not_told_apart(),
                                [&](const ModelScore* score) { return score->fitted.model == other.fitted.model; });
}

/// Of the best law and the likeliest that is not told apart from it, the pair on which they differ most, in standard
/// errors of what is predicted there.
void HysteresisOf::decide() {
    const bool by_conforming = found_.conforming.best() != nullptr;
    const auto& ranking = by_conforming ? found_.conforming : found_.all;
    const ModelScore *best = ranking.best(), *other_law = nullptr;
    for (const auto* score : ranking.not_told_apart())
        if (score != best && !other_law && !told_apart_by_all(*best, *score)) other_law = score;
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
        throw UndefinedDataError("no hysteresis can be predicted: " + result.work_of_adhesion.reason);
    return HysteresisOf(result, threads).all(trials);
}

}  // namespace setae::study
