// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/adhesion/left_out.hpp"
#include "setae/fields/describe.hpp"
#include "setae/hysteresis/retraction_pair.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::hysteresis {

/// A pair with both works of adhesion measured.
struct RankedPair {
    RetractionPair pair;      ///< pair whose `approach` is `approach` with all its inputs
    MeasuredWork approach;    ///< measured W_app
    MeasuredWork retraction;  ///< measured W_ret
};

/// Distinction of two models by the 5 % point of their odds (the odds themselves where they are lower): above 20, above
/// 3, or neither.
enum class Distinction { cannot_be_distinguished, better, clearly_better };

/// "clearly better", "better", "cannot be distinguished".
[[nodiscard]] const char* name_of(Distinction distinction);

/// The odds for one model against another.
struct Odds {
    double value = 1.0;               ///< exp of the difference of ln L, which may be infinite
    double lower = 1.0, upper = 1.0;  ///< 5 and 95 % points when the data vary within their standard errors

    [[nodiscard]] Distinction distinction() const;
};
inline constexpr double clearly_better_odds = 20.0, better_odds = 3.0;

/// A constant error of W_ret of all pairs, in addition to the scatter of pairs, surfaces and elastomers.
struct ConstantBias {
    Estimate value;              ///< [J/m²]
    double probability = 1.0;    ///< probability of a constant at least as far from 0 by chance
    double odds_with_it = 1.0;   ///< odds for the model with a free constant, with surfaces left out
    bool refuses_model = false;  ///< probability < 0.005; or odds above 10 and probability < 0.05
};

/// Agreement of a model with the measured values on both branches.
struct ModelScore {
    FittedModel fitted;
    adhesion::GeneralisedFit fit;  ///< fit of the model's parameter to W_ret
    double rms_residual = 0.0;     ///< rms of measured − model of W_ret, with equal weights [J/m²]
    /// joint log-likelihood of all measured W_ret, at θ and the scatter: ln density [(J/m²)^−n]
    double log_likelihood = 0.0;
    /// Log-likelihood of each surface by the fit to the others, for both branches and for each branch: ln density
    /// [(J/m²)^−n].
    double left_out_log_likelihood = 0.0, left_out_approach = 0.0, left_out_retraction = 0.0;
    double weight = 0.0;  ///< ∝ exp(left_out_log_likelihood), over all ranked models
    Odds odds_against;    ///< odds for the likeliest model without a constant error
    ConstantBias bias;
    Estimate work_of_adhesion;                ///< W_int fitted to both branches [J/m²]
    adhesion::ModelScatter approach_scatter;  ///< scatter of W_app in the posterior
    /// leave-one-out error (rms) of W_ret for surfaces and for elastomers [J/m²]; NaN where there is only one
    double surface_left_out = 0.0, elastomer_left_out = 0.0;
    std::vector<adhesion::LeftOutPrediction> left_out;
};

/// A model that cannot be ranked, with the reason.
struct UnrankedModel {
    RetractionModel model;
    std::string reason;
};

/// W_int,e = c W_app of the smooth reference on elastomer e, one number c, against one common W_int.
struct ProportionalWork {
    Odds surfaces_left_out, elastomers_left_out;  ///< odds for proportional W_int, on approach only
    Odds both_branches;  ///< odds for proportional W_int, with surfaces left out, by the likeliest model of W_ret
};

/// Models in the order of their leave-one-surface-out log-likelihood, the best first.
struct Ranking {
    std::vector<ModelScore> models;
    std::vector<UnrankedModel> unranked;
    /// Odds for a common W_app = g W without pinning of the edge, against the same with pinning, on approach of
    /// surfaces left out.
    std::optional<Odds> approach_against_pinning;
    std::optional<ProportionalWork> proportional_work;  ///< where every elastomer has a reference and W_int is fitted

    /// The likeliest model without a constant error. A fitted model whose parameter may be 0 is replaced by the model
    /// with that parameter at 0. The likeliest of all where every model has a constant error; empty without models.
    [[nodiscard]] const ModelScore* best() const;
    /// The best model of those whose W_ret tends to that of a smooth surface, has_smooth_limit(): it is used for
    /// predictions. It may be clearly worse than best().
    [[nodiscard]] const ModelScore* best_with_smooth_limit() const;
    /// Models that are not excluded: without a constant error and not clearly worse than the likeliest one. The
    /// likeliest first; all models where every model has a constant error.
    [[nodiscard]] std::vector<const ModelScore*> possible() const;
    /// Whether a constant refuses every model.
    [[nodiscard]] bool all_refused() const;
};

/// Minimum numbers of pairs and surfaces for a ranking. With three surfaces, two remain where one is left out, and the
/// scatter of two surfaces is undetermined.
inline constexpr std::size_t min_ranked_pairs = 6, min_ranked_surfaces = 4;

/// Predicts both branches of every surface by the others. W_int, the model's parameter and all inputs are fitted again
/// without the surface; the scatter of pairs, surfaces and elastomers is integrated out with a half-Cauchy prior
/// (adhesion::MarginalScatter). A fitted parameter thus does not improve the score of the data to which it is fitted.
/// The reported parameter is that of generalised least squares of W_ret.
///
/// known_work: W_int where the study states it; else it is fitted with each model.
/// Models without the required data of a pair are unranked. Equal numbers for any number of threads. Calibration:
/// docs/validation/ranking.md. Source: Geisser, Eddy, J. Am. Stat. Assoc. 74 (1979) 153; Gelman, Bayesian Anal. 1
/// (2006) 515 (scatter); Yao, Vehtari, Simpson, Gelman, Bayesian Anal. 13 (2018) 917 (weights).
[[nodiscard]] Ranking rank_models(const std::vector<RetractionModel>& models, const std::vector<RankedPair>& pairs,
                                  const std::optional<Estimate>& known_work = {}, parallel::Threads threads = {});

}  // namespace setae::hysteresis

namespace setae::fields {

template <>
struct Described<hysteresis::Odds> {
    using T = hysteresis::Odds;
    static constexpr std::array<std::string_view, 3> distinctions{"cannot be distinguished", "better",
                                                                  "clearly better"};
    static constexpr std::array rows{
        field<&T::value>("value", "odds for the measured data"),
        field<&T::lower>("lower", "lower end of the interval when the data vary within their standard errors"),
        field<&T::upper>("upper", "upper end of the interval"),
        made<T>("level", "probability of the interval", [](const T&) { return 0.9; }),
        made<T>("distinction", "distinction of the models by the lower end of the interval",
                [](const T& of) { return hysteresis::name_of(of.distinction()); })
            .one_of(distinctions),
    };
    static constexpr Description description{"odds", "odds for one model against another", rows};
};
static_assert(complete<hysteresis::Odds>);

template <>
struct Described<hysteresis::ProportionalWork> {
    using T = hysteresis::ProportionalWork;
    static constexpr std::array rows{
        field<&T::surfaces_left_out>("surfaces_left_out", "odds on approach, with surfaces left out"),
        field<&T::elastomers_left_out>("elastomers_left_out", "odds on approach, with elastomers left out"),
        field<&T::both_branches>("both_branches",
                                 "odds on both branches, with surfaces left out, by the likeliest model"),
    };
    static constexpr Description description{
        "", "odds for W_int of each elastomer in proportion to its smooth reference, against one W_int", rows};
};
static_assert(complete<hysteresis::ProportionalWork>);

template <>
struct Described<hysteresis::ModelScore> {
    using T = hysteresis::ModelScore;
    /// The model's parameter, where it has one of this name.
    static std::optional<Estimate> parameter(const T& of, std::string_view name) {
        const auto& model = of.fitted.model;
        if (!model.fitted() || model.parameter().quantity != name) return {};
        return of.fitted.parameter.estimate();
    }
    static constexpr std::array rows{
        made<T>("model", "name of the model", [](const T& of) { return of.fitted.model.name(); }),
        made<T>("formula", "formula of the model for W_ret at pull-off",
                [](const T& of) { return of.fitted.model.formula(); }),
        made<T>("parameters", "parameters fitted to all pairs",
                [](const T& of) { return of.fitted.model.fitted() ? 1 : 0; }),
        made<T>("pinning_coefficient", "k", "1", "k, where it is fitted",
                [](const T& of) { return parameter(of, "pinning_coefficient"); }),
        made<T>("work_per_true_area", "W_x", "J/m2", "W_x at pull-off, where it is fitted",
                [](const T& of) { return parameter(of, "work_per_true_area"); }),
        value<&T::rms_residual>("rms_residual", "J/m2", "rms of measured minus predicted W_ret"),
        value<&T::surface_left_out>("rms_residual_surface_left_out", "J/m2", "leave-one-surface-out error (rms)"),
        value<&T::elastomer_left_out>("rms_residual_elastomer_left_out", "J/m2", "leave-one-elastomer-out error (rms)"),
        made_value<T>("scatter", "J/m2",
                      "scatter of a pair about the model beyond all standard errors, one standard deviation",
                      [](const T& of) { return of.fitted.scatter.standard_error; }),
        field<&T::log_likelihood>("log_likelihood", "ln of the probability density of all measured values"),
        field<&T::left_out_log_likelihood>(
            "log_likelihood_surface_left_out",
            "ln of the probability density of each surface by the fit to the other surfaces, summed over "
            "both branches"),
        field<&T::left_out_approach>("log_likelihood_approach", "contribution of W_app to the left-out log-likelihood"),
        field<&T::left_out_retraction>("log_likelihood_retraction",
                                       "contribution of W_ret to the left-out log-likelihood"),
        field<&T::weight>("weight", "weight of the model among all ranked models"),
        field<&T::odds_against>("odds_against",
                                "odds for the likeliest model without a constant error, against this model"),
        made<T>("constant", "b", "J/m2", "constant error of W_ret of all pairs",
                [](const T& of) { return of.bias.value; }),
        made<T>("constant_probability", "probability of a constant at least as far from 0 by chance",
                [](const T& of) { return of.bias.probability; }),
        made<T>("constant_odds", "odds for the model with a free constant, with surfaces left out",
                [](const T& of) { return of.bias.odds_with_it; }),
        made<T>("refused", "whether the model is refused because of the constant error",
                [](const T& of) { return of.bias.refuses_model; }),
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W_int", "J/m2", "W_int fitted to both branches")
            .as("intrinsic_work_of_adhesion"),
        inner<&T::fitted>(),
        inner<&T::fit>(),
        inner<&T::bias>(),
        inner<&T::approach_scatter>(),
        inner<&T::left_out>(),
    };
    static constexpr Description description{"", "agreement of a model with the measured values", rows};
};
static_assert(complete<hysteresis::ModelScore>);

template <>
struct Described<hysteresis::UnrankedModel> {
    using T = hysteresis::UnrankedModel;
    static constexpr std::array rows{
        made<T>("model", "name of the model", [](const T& of) { return of.model.name(); }),
        made<T>("formula", "formula of the model for W_ret at pull-off",
                [](const T& of) { return of.model.formula(); }),
        field<&T::reason>("reason", "reason for which it is missing or left out"),
        inner<&T::model>(),
    };
    static constexpr Description description{"", "model that cannot be ranked", rows};
};
static_assert(complete<hysteresis::UnrankedModel>);

template <>
struct Described<hysteresis::Ranking> {
    using T = hysteresis::Ranking;
    static constexpr std::array rows{
        made<T>("best", "likeliest model without a constant error",
                [](const T& of) {
                    const auto* best = of.best();
                    return best ? std::optional(best->fitted.model.name()) : std::nullopt;
                })
            .or_null(),
        made<T>("possible", "models that are not excluded, the likeliest first",
                [](const T& of) {
                    std::vector<std::string> names;
                    for (const auto* score : of.possible()) names.push_back(score->fitted.model.name());
                    return names;
                }),
        field<&T::approach_against_pinning>("approach_without_pinning", "odds on approach against pinning of the edge")
            .or_null(),
        field<&T::proportional_work>(
            "proportional_work",
            "odds for W_int of each elastomer in proportion to its smooth reference, against one W_int")
            .or_null(),
        field<&T::models>("models", "ranked models, the likeliest first"),
        field<&T::unranked>("unranked", "models that could not be ranked"),
    };
    static constexpr Description description{
        "law_ranking",
        "models of the works of adhesion, ranked by their agreement with measured values on both "
        "branches",
        rows};
};
static_assert(complete<hysteresis::Ranking>);

}  // namespace setae::fields
