// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/adhesion/left_out.hpp"
#include "setae/hysteresis/retraction_pair.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::hysteresis {

/// A model and all pairs as it sees them.
struct ModelPoints {
    RetractionModel model;
    std::vector<adhesion::PairPoint> points;
};

/// How well a model says what was measured.
struct ModelScore {
    FittedModel fitted;
    adhesion::GeneralisedFit fit;
    double rms_residual = 0.0;    ///< measured − model, every pair alike [J/m²]
    double log_likelihood = 0.0;  ///< of all measured values together, at θ and the scatter: ln density [(J/m²)^−n]
    double left_out_log_likelihood = 0.0;  ///< of each surface by the fit to the others: adhesion::leave_out()
    double weight = 0.0;                   ///< ∝ exp(left_out_log_likelihood), over all ranked models
    double surface_left_out = 0.0, elastomer_left_out = 0.0;  ///< rms residual of those that the fit has not seen
                                                              ///< [J/m²]; NaN where there is but one
    std::vector<adhesion::LeftOutPrediction> left_out;
};

/// A model that cannot be judged, and why.
struct UnrankedModel {
    RetractionModel model;
    std::string reason;
};

/// Odds above which a model is told apart as wrong. With four surfaces one in ten laws that were planted is refused at
/// 20 : 1; docs/measured/laws.md.
inline constexpr double told_apart_odds = 50.0;

/// Models, that first which says best of each surface what the others let expect.
struct Ranking {
    std::vector<ModelScore> models;
    std::vector<UnrankedModel> unranked;

    /// Of the models that are not told apart, the one that misses a surface it has not seen least, one without θ before
    /// one with it unless it misses by a quarter more; nothing without models.
    [[nodiscard]] const ModelScore* best() const;
    /// Models against which the odds for the likeliest are at most told_apart_odds : 1, the likeliest first.
    [[nodiscard]] std::vector<const ModelScore*> not_told_apart() const;
};

/// Pairs and surfaces below which no model is judged.
inline constexpr std::size_t fewest_ranked_pairs = 6, fewest_ranked_surfaces = 3;

/// θ by generalised least squares with the scatter of pairs, surfaces and elastomers (adhesion::fit_generalised(); the
/// scatter alone where there is no θ, or where θ would be below 0), then every surface and every elastomer predicted by
/// the others. A law with a parameter pays for it there: what it is fitted to is not what it is judged by.
///
/// All models are to have the same pairs. Same numbers for any number of threads. Source: Geisser, Eddy, J. Am. Stat.
/// Assoc. 74 (1979) 153; Yao, Vehtari, Simpson, Gelman, Bayesian Anal. 13 (2018) 917 (weights).
[[nodiscard]] Ranking rank_models(const std::vector<ModelPoints>& models, parallel::Threads threads = {});

}  // namespace setae::hysteresis
