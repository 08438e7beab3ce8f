// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/adhesion/left_out.hpp"
#include "setae/hysteresis/retraction_pair.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::hysteresis {

/// A pair with both works of adhesion measured.
struct RankedPair {
    RetractionPair pair;      ///< whose `approach` is `approach` with all that it rests on
    MeasuredWork approach;    ///< W_app
    MeasuredWork retraction;  ///< W_ret
};

/// How surely one model is likelier than another, by the 5 % point of their odds (the odds themselves where they are
/// lower): above 20, above 3, or neither.
enum class Distinction { cannot_be_distinguished, better, clearly_better };

/// "clearly better", "better", "cannot be distinguished".
[[nodiscard]] const char* name_of(Distinction distinction);

/// The odds for one model against another.
struct Odds {
    double value = 1.0;               ///< exp of the difference of ln L, which may be infinite
    double lower = 1.0, upper = 1.0;  ///< 5 and 95 % points as the data vary within their own ±

    [[nodiscard]] Distinction distinction() const;
};
inline constexpr double clearly_better_odds = 20.0, better_odds = 3.0;

/// A constant that W_ret of all pairs is off by, beside the scatter of pairs, surfaces and elastomers.
struct ConstantBias {
    Estimate value;              ///< [J/m²]
    double probability = 1.0;    ///< of one at least as far from 0 where there is none
    double odds_with_it = 1.0;   ///< for the model with a free constant, on surfaces left out
    bool refuses_model = false;  ///< probability < 0.005; or odds above 10 and probability < 0.05
};

/// How well a model says what was measured on both branches.
struct ModelScore {
    FittedModel fitted;
    adhesion::GeneralisedFit fit;  ///< of the model's number to W_ret
    double rms_residual = 0.0;     ///< of W_ret, measured − model, every pair alike [J/m²]
    double log_likelihood = 0.0;   ///< of all measured W_ret together, at θ and the scatter: ln density [(J/m²)^−n]
    /// Of each surface by the fit to the others, both branches and each alone: ln density [(J/m²)^−n].
    double left_out_log_likelihood = 0.0, left_out_approach = 0.0, left_out_retraction = 0.0;
    double weight = 0.0;  ///< ∝ exp(left_out_log_likelihood), over all ranked models
    Odds odds_against;    ///< for the likeliest model that no constant refuses
    ConstantBias bias;
    Estimate work_of_adhesion;                                ///< W_int by both branches [J/m²]
    adhesion::ModelScatter approach_scatter;                  ///< of W_app, as the posterior has it
    double surface_left_out = 0.0, elastomer_left_out = 0.0;  ///< rms residual of W_ret of those that the fit has not
                                                              ///< seen [J/m²]; NaN where there is but one
    std::vector<adhesion::LeftOutPrediction> left_out;
};

/// A model that cannot be judged, and why.
struct UnrankedModel {
    RetractionModel model;
    std::string reason;
};

/// W_int,e = c W_app of the smooth reference on elastomer e, one number c, against one common W_int.
struct ProportionalWork {
    Odds surfaces_left_out, elastomers_left_out;  ///< for it, on approach alone
    Odds both_branches;                           ///< for it, surfaces left out, by the likeliest model of W_ret
};

/// Models, that first which says best of each surface what the others let expect.
struct Ranking {
    std::vector<ModelScore> models;
    std::vector<UnrankedModel> unranked;
    /// For a common W_app = g W without what pins an edge, against the same with it, on approach of surfaces left out.
    std::optional<Odds> approach_against_pinning;
    std::optional<ProportionalWork> proportional_work;  ///< where every elastomer has a reference and W_int is fitted

    /// The likeliest model that no constant refuses. A fitted model whose number may be 0 gives way to the one that it
    /// then is. The likeliest of all where every model is refused; nothing without models.
    [[nodiscard]] const ModelScore* best() const;
    /// The same of the models whose W_ret tends to a smooth surface's, has_smooth_limit(): predictions go by it. It may
    /// be clearly worse than best().
    [[nodiscard]] const ModelScore* best_with_smooth_limit() const;
    /// Models that are not excluded: no constant refuses them, and the likeliest of these is not clearly better. The
    /// likeliest first; all of them where every model is refused.
    [[nodiscard]] std::vector<const ModelScore*> possible() const;
    /// Whether a constant refuses every model.
    [[nodiscard]] bool all_refused() const;
};

/// Pairs and surfaces below which no model is judged: of three surfaces two remain where one is left out, and their
/// scatter hides anything.
inline constexpr std::size_t fewest_ranked_pairs = 6, fewest_ranked_surfaces = 4;

/// Both branches of every surface predicted by the others. W_int, the model's number and all inputs are fitted anew
/// without the surface, scatter of pairs, surfaces and elastomers is integrated out with a half-Cauchy prior
/// (adhesion::MarginalScatter), and a model with a number pays for it there: what it is fitted to is not what it is
/// judged by. The model's number as it is used is that of generalised least squares of W_ret.
///
/// known_work: W_int where the study states it; else it is found with each model.
/// Models that lack something of a pair are unranked. Same numbers for any number of threads. Calibration:
/// docs/measured/ranking.md. Source: Geisser, Eddy, J. Am. Stat. Assoc. 74 (1979) 153; Gelman, Bayesian Anal. 1 (2006)
/// 515 (scatter); Yao, Vehtari, Simpson, Gelman, Bayesian Anal. 13 (2018) 917 (weights).
[[nodiscard]] Ranking rank_models(const std::vector<RetractionModel>& models, const std::vector<RankedPair>& pairs,
                                  const std::optional<Estimate>& known_work = {}, parallel::Threads threads = {});

}  // namespace setae::hysteresis
