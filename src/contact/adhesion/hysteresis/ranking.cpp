// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "model_evidence.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/core/words.hpp"
#include "setae/hysteresis/smooth_limit.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::hysteresis {
namespace {

using adhesion::GeneralisedFit;
using adhesion::PairPoint;
using Eigen::MatrixXd, Eigen::VectorXd;

GeneralisedFit fit_of(const RetractionModel& model, const std::vector<PairPoint>& pairs) {
    if (!model.fitted()) return adhesion::fit_scatter(pairs, 0.0);
    auto fit = adhesion::fit_generalised(pairs);
    return fit.work_of_adhesion.value > 0.0 ? fit : adhesion::fit_scatter(pairs, 0.0);
}

/// Why there are too few pairs to rank models; empty where there are enough.
std::string too_few(const std::vector<RankedPair>& pairs) {
    std::set<std::string> surfaces;
    for (const auto& pair : pairs) surfaces.insert(pair.pair.rough.name);
    if (pairs.size() >= min_ranked_pairs && surfaces.size() >= min_ranked_surfaces) return "";
    return fmt::format(
        "{} on {} with measured W_app and W_ret; a ranking of models needs at least {} pairs on {} surfaces",
        counted(pairs.size(), "pair", "pairs"), counted(surfaces.size(), "surface", "surfaces"), min_ranked_pairs,
        min_ranked_surfaces);
}

double rms_left_out(const std::vector<adhesion::LeftOutPrediction>& predictions, bool surfaces) {
    double sum = 0.0;
    int count = 0;
    for (const auto& prediction : predictions) {
        if (prediction.surface_left_out != surfaces) continue;
        sum += prediction.residual * prediction.residual;
        ++count;
    }
    return count == 0 ? undefined : std::sqrt(sum / count);
}

/// Scatter of a pair of a new surface and a new elastomer.
Estimate scatter_of_next(const GeneralisedFit& fit) {
    const auto& s = fit.scatter;
    const double variance = s.pair * s.pair + s.surface * s.surface + s.elastomer * s.elastomer;
    Estimate scatter{.value = 0.0, .standard_error = std::sqrt(variance)};
    scatter.degrees_of_freedom = std::max(1.0, fit.freedom.pair);
    return scatter;
}

/// One model during its evaluation.
struct Judged {
    std::unique_ptr<BothBranches> model;
    ModelScore score;
    double rms_approach = 0.0;  ///< measured − fitted W_app, at the widest scales [J/m²]
    LeftOutEvidence surfaces;   ///< each left out
    VectorXd log_likelihood;    ///< for the data and for each draw
    VectorXd approach;          ///< for approach only
    std::string reason;         ///< why it cannot be judged

    [[nodiscard]] bool ok() const { return reason.empty(); }
};

class Judgement {
public:
    Judgement(const std::vector<RetractionModel>& models, const std::vector<RankedPair>& pairs,
              const std::optional<Estimate>& known_work, parallel::Threads threads)
        : pairs_(pairs), known_work_(known_work), threads_(threads), judged_(models.size()) {
        for (std::size_t i = 0; i < models.size(); ++i) judged_[i].score.fitted.model = models[i];
    }

    [[nodiscard]] Ranking ranking() {
        each([this](Judged& of) { fit(of); });
        find_scales();
        each([this](Judged& of) { leave_out(of); });
        vary();
        auto ranking = sorted();
        ranking.proportional_work = proportional_work(ranking);
        return ranking;
    }

private:
    template <class Part>
    void each(const Part& part) {
        parallel::for_each_index(judged_.size(), threads_, [&](std::size_t i) {
            auto& of = judged_[i];
            if (!of.ok()) return;
            try {
                part(of);
            } catch (const Cancelled&) {
                throw;
            } catch (const Error& error) {
                of.reason = error.what();
            }
        });
    }

    void fit(Judged& of) {
        auto& score = of.score;
        const auto& model = score.fitted.model;
        std::vector<PairPoint> points;
        for (const auto& [pair, approach, measured] : pairs_) {
            if (auto reason = pair.lacks(model); !reason.empty()) {
                of.reason = std::move(reason);
                return;
            }
            points.push_back(retraction_point(model, pair, measured));
        }
        score.fit = fit_of(model, points);
        score.fitted.parameter = score.fit.work_of_adhesion;
        score.fitted.scatter = scatter_of_next(score.fit);
        for (const auto& point : points)
            score.rms_residual +=
                std::pow(point.measured.value - point.prediction(score.fit.work_of_adhesion.value), 2);
        score.rms_residual = std::sqrt(score.rms_residual / static_cast<double>(points.size()));
        score.log_likelihood = score.fit.log_likelihood;
        of.model = std::make_unique<BothBranches>(model, pairs_, known_work_);
        of.rms_approach = rms_of_approach(*of.model, pairs_, widest_scales().approach);
    }

    /// Half-Cauchy scales of a fifth of the median measured work.
    [[nodiscard]] ScatterScales widest_scales() const {
        constexpr double of_median = 0.2;
        std::vector<double> approach, retraction;
        for (const auto& pair : pairs_) {
            approach.push_back(std::abs(pair.approach.value.value));
            retraction.push_back(std::abs(pair.retraction.value.value));
        }
        const auto median = [](const std::vector<double>& values) {
            return std::max(upper_median(values), 1e-6 * *std::ranges::max_element(values));
        };
        return {of_median * median(approach), of_median * median(retraction)};
    }

    /// Twice the deviation of the best model, where this is smaller: the prior must include small scatter, too.
    void find_scales() {
        scales_ = widest_scales();
        constexpr double of_residual = 2.0, least = 1e-5;
        const auto widest = scales_;
        double approach = std::numeric_limits<double>::infinity(), retraction = approach;
        for (const auto& of : judged_) {
            if (!of.ok()) continue;
            approach = std::min(approach, of.rms_approach);
            retraction = std::min(retraction, of.score.rms_residual);
        }
        scales_.approach = std::max(least * widest.approach, std::min(widest.approach, of_residual * approach));
        scales_.retraction = std::max(least * widest.retraction, std::min(widest.retraction, of_residual * retraction));
    }

    void leave_out(Judged& of) const {
        auto& score = of.score;
        of.surfaces = left_out_evidence(*of.model, pairs_, scales_, true, false);
        const auto elastomers = left_out_evidence(*of.model, pairs_, scales_, false, false),
                   with_constant = left_out_evidence(*of.model, pairs_, scales_, true, true);
        of.log_likelihood = VectorXd::Constant(1, of.surfaces.both());
        of.approach = VectorXd::Constant(1, of.surfaces.approach);
        score.left_out_log_likelihood = of.surfaces.both();
        score.left_out_approach = of.surfaces.approach;
        score.left_out_retraction = of.surfaces.retraction;
        score.left_out = std::move(of.surfaces.predictions);
        score.left_out.insert(score.left_out.end(), elastomers.predictions.begin(), elastomers.predictions.end());
        score.surface_left_out = rms_left_out(score.left_out, true);
        score.elastomer_left_out = rms_left_out(score.left_out, false);
        const auto whole = whole_evidence(*of.model, pairs_, scales_, false),
                   biased = whole_evidence(*of.model, pairs_, scales_, true);
        score.work_of_adhesion = whole.work_of_adhesion;
        score.approach_scatter = whole.approach_scatter;
        auto& bias = score.bias;
        bias.value = biased.constant;
        bias.probability = biased.constant_tail;
        bias.odds_with_it = std::exp(with_constant.both() - score.left_out_log_likelihood);
        constexpr double surely = 0.005, likely = 0.05, odds = 10.0;
        bias.refuses_model = bias.probability < surely || (bias.odds_with_it > odds && bias.probability < likely);
        if (pinned_on_approach_at_all(score.fitted.model))
            score.fitted.work_of_adhesion =
                TracedValue(score.work_of_adhesion, "W_int by " + score.fitted.model.name());
    }

    static bool pinned_on_approach_at_all(const RetractionModel& model) {
        return model.law == Law::pinning || model.law == Law::pinning_by_bands || model.law == Law::fitted_pinning;
    }

    /// The ranking with noise added to the data, for models close to the best.
    void vary() {
        constexpr double far = 25.0;  // difference in ln L that no noise compensates
        double most = -std::numeric_limits<double>::infinity();
        for (const auto& of : judged_)
            if (of.ok()) most = std::max(most, of.log_likelihood[0]);
        each([&](Judged& of) {
            const auto& model = of.score.fitted.model;
            const bool compared = model.tip == Tip::none && (model.law == Law::reversible || model.law == Law::pinning);
            if (of.log_likelihood[0] < most - far && !compared) return;  // against_pinning() compares these
            const auto varied = varied_evidence(of.surfaces, pairs_, scales_, drawn_noise(*of.model));
            of.log_likelihood = varied.both();
            of.approach = varied.approach;
        });
    }

    /// Noise that the pairs' own ± allows, the same for every model.
    static DrawnNoise drawn_noise(const BothBranches& model) {
        constexpr Index draws = 100;
        const auto n = model.size();
        const auto normal = [n](std::uint64_t stream) -> MatrixXd {
            return numerics::normal_numbers({1, stream}, 0, n * draws).matrix().reshaped(n, draws);
        };
        return {model.noise(Branch::approach).asDiagonal() * normal(0),
                model.noise(Branch::retraction).asDiagonal() * normal(1)};
    }

    /// 5 and 95 % points of exp(one − other).
    static Odds odds_of(const VectorXd& one, const VectorXd& other) {
        const auto number = [](double difference) {
            constexpr double most = 600.0;  // largest logarithm of odds that are a finite number
            return std::exp(std::clamp(difference, -most, most));
        };
        const double odds_of_data = number(one[0] - other[0]);
        Odds odds{odds_of_data, odds_of_data, odds_of_data};
        if (one.size() != other.size() || one.size() < 2) return odds;
        VectorXd varied = one.tail(one.size() - 1) - other.tail(other.size() - 1);
        std::ranges::sort(varied);
        const auto at = [&](double p) {
            return number(
                varied[std::min<Index>(varied.size() - 1, static_cast<Index>(p * static_cast<double>(varied.size())))]);
        };
        odds.lower = at(0.05);
        odds.upper = at(0.95);
        return odds;
    }

    [[nodiscard]] Ranking sorted() {
        Ranking ranking;
        std::vector<Judged*> ranked;
        for (auto& of : judged_) {
            if (of.ok() && std::isfinite(of.score.left_out_log_likelihood)) ranked.push_back(&of);
            else
                ranking.unranked.push_back(
                    {of.score.fitted.model, of.ok() ? "its likelihood is not a finite number" : of.reason});
        }
        if (ranked.empty()) return ranking;
        std::ranges::stable_sort(ranked, [](const Judged* a, const Judged* b) {
            return a->score.left_out_log_likelihood > b->score.left_out_log_likelihood;
        });
        double sum = 0.0;
        for (auto* of : ranked) {
            of->score.weight = std::exp(of->log_likelihood[0] - ranked.front()->log_likelihood[0]);
            sum += of->score.weight;
        }
        const auto reference =
            std::ranges::find_if(ranked, [](const Judged* of) { return !of->score.bias.refuses_model; });
        const auto& likeliest = reference == ranked.end() ? *ranked.front() : **reference;
        for (auto* of : ranked) {
            of->score.weight /= sum;
            of->score.odds_against = odds_of(likeliest.log_likelihood, of->log_likelihood);
        }
        ranking.approach_against_pinning = against_pinning(ranked);
        for (auto* of : ranked) ranking.models.push_back(std::move(of->score));
        return ranking;
    }

    /// The likeliest model with W_int of each elastomer in proportion to its reference, against one W_int.
    [[nodiscard]] std::optional<ProportionalWork> proportional_work(const Ranking& ranking) const {
        const auto* best = ranking.best();
        std::set<std::string> elastomers;
        for (const auto& of : pairs_) {
            if (!of.pair.reference_work) return std::nullopt;
            elastomers.insert(of.pair.soft.name);
        }
        if (!best || known_work_ || elastomers.size() < 2) return std::nullopt;
        const auto& model = best->fitted.model;
        const BothBranches common(model, pairs_, {}), by_reference(model, pairs_, {}, WorkOfElastomers::by_reference);
        const auto noise = drawn_noise(common);
        const auto evidence = [&](const BothBranches& of, bool by_surface) {
            return varied_evidence(left_out_evidence(of, pairs_, scales_, by_surface, false), pairs_, scales_, noise);
        };
        const auto one = evidence(common, true), other = evidence(by_reference, true);
        return ProportionalWork{odds_of(other.approach, one.approach),
                                odds_of(evidence(by_reference, false).approach, evidence(common, false).approach),
                                odds_of(other.both(), one.both())};
    }

    /// For approach only: `reversible` and `pinning` differ by the pinning.
    static std::optional<Odds> against_pinning(const std::vector<Judged*>& ranked) {
        const auto find = [&](Law law) -> const Judged* {
            for (const auto* of : ranked)
                if (of->score.fitted.model == RetractionModel{law, Tip::none}) return of;
            return nullptr;
        };
        const auto *without = find(Law::reversible), *with = find(Law::pinning);
        if (!without || !with) return std::nullopt;
        return odds_of(without->approach, with->approach);
    }

    const std::vector<RankedPair>& pairs_;
    std::optional<Estimate> known_work_;
    parallel::Threads threads_;
    std::vector<Judged> judged_;
    ScatterScales scales_;
};

/// The model that a fitted model equals for a parameter of 0.
RetractionModel parent_of(const RetractionModel& model) { return {Law::reversible, model.tip}; }

/// The first, or its parent where its number may be 0 and the parent is among them.
const ModelScore* first_of(const std::vector<const ModelScore*>& scores) {
    if (scores.empty()) return nullptr;
    const auto* first = scores.front();
    const auto& model = first->fitted.model;
    if (model.law != Law::fitted_pinning && model.law != Law::fitted_conformal_loss) return first;
    const auto interval = interval_of(first->fitted.parameter.estimate());
    if (!interval || interval->lower > 0.0) return first;
    for (const auto* score : scores)
        if (score->fitted.model == parent_of(model)) return score;
    return first;
}

}  // namespace

const char* name_of(Distinction distinction) {
    switch (distinction) {
        case Distinction::cannot_be_distinguished: return "cannot be distinguished";
        case Distinction::better: return "better";
        case Distinction::clearly_better: return "clearly better";
    }
    throw InternalError("a distinction without a name");
}

Distinction Odds::distinction() const {
    const double least = std::min(value, lower);
    if (least > clearly_better_odds) return Distinction::clearly_better;
    return least > better_odds ? Distinction::better : Distinction::cannot_be_distinguished;
}

bool Ranking::all_refused() const {
    return std::ranges::all_of(models, [](const ModelScore& score) { return score.bias.refuses_model; });
}

std::vector<const ModelScore*> Ranking::possible() const {
    std::vector<const ModelScore*> found;
    for (const auto& score : models)
        if ((all_refused() || !score.bias.refuses_model) &&
            score.odds_against.distinction() != Distinction::clearly_better)
            found.push_back(&score);
    return found;
}

const ModelScore* Ranking::best() const { return first_of(possible()); }

const ModelScore* Ranking::best_with_smooth_limit() const {
    std::vector<const ModelScore*> limited, refused;
    for (const auto& score : models)
        if (has_smooth_limit(score.fitted.model)) (score.bias.refuses_model ? refused : limited).push_back(&score);
    return first_of(limited.empty() ? refused : limited);
}

Ranking rank_models(const std::vector<RetractionModel>& models, const std::vector<RankedPair>& pairs,
                    const std::optional<Estimate>& known_work, parallel::Threads threads) {
    if (const auto reason = too_few(pairs); !reason.empty()) {
        Ranking none;
        for (const auto& model : models) none.unranked.push_back({model, reason});
        return none;
    }
    return Judgement(models, pairs, known_work, threads).ranking();
}

}  // namespace setae::hysteresis
