// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "setae/hysteresis/ranking.hpp"

namespace setae::reference {

/// How often one model is judged how, over data sets made with it.
struct ModelCalibration {
    std::string model;
    int sets = 0;
    int best = 0;                                                      ///< it is the likeliest model
    int not_distinguished = 0, beaten_better = 0, beaten_clearly = 0;  ///< it is not, by the class of the likeliest
    std::map<std::string, int> beaten_by;       ///< data sets in which a model is better or clearly better
    int refused = 0;                            ///< a constant refuses it
    int left = 0;                               ///< models that remain possible, summed over data sets
    int claims_clearly = 0, claims_better = 0;  ///< other models that it beats in each class, where it is likeliest
    // against `reversible`
    double odds_lower = 0.0, odds_median = 0.0, odds_upper = 0.0;  ///< 5, 50 and 95 % points of ln odds
    int reversible_excluded = 0;                                   ///< data sets whose verdict excludes `reversible`
    int reversible_undecided = 0;                                  ///< … whose verdict leaves both possible
};

/// W_ret of many data sets with one constant added.
struct BiasCalibration {
    std::string model;
    int sets = 0;
    int refused = 0;
};

/// Spread of the odds against a model while W_ret is jittered.
struct JitteredOdds {
    std::string model;
    double value = 1.0, lower = 1.0, upper = 1.0;                              ///< as printed for the data
    double jittered_lower = 1.0, jittered_median = 1.0, jittered_upper = 1.0;  ///< 5, 50 and 95 % points
    int cannot_be_distinguished = 0, better = 0, clearly_better = 0, likeliest = 0, refused = 0;
};

/// Models of the ranking whose number is above 0: those that data sets are made with, at their W_int and their number.
/// scatter: of both branches, equal parts (in squares) between pairs, surfaces and elastomers [J/m²].
[[nodiscard]] std::vector<hysteresis::ModelScore> true_models(const hysteresis::Ranking& ranking, double scatter);

/// Data sets by hysteresis::simulated_pairs(), ranked among `models`.
[[nodiscard]] ModelCalibration calibrate(const std::vector<hysteresis::RetractionModel>& models,
                                         const std::vector<hysteresis::RankedPair>& pairs,
                                         const hysteresis::ModelScore& truth, int sets, std::uint64_t first_seed);

/// The same with `constant` [J/m²] added to W_ret of every pair, the true model alone.
[[nodiscard]] BiasCalibration calibrate_bias(const std::vector<hysteresis::RankedPair>& pairs,
                                             const hysteresis::ModelScore& truth, double constant, int sets,
                                             std::uint64_t first_seed);

/// W_ret of every pair moved by a normal number of this standard deviation [J/m²], many times.
[[nodiscard]] std::vector<JitteredOdds> jitter(const std::vector<hysteresis::RetractionModel>& models,
                                               const std::vector<hysteresis::RankedPair>& pairs, double deviation,
                                               int sets, std::uint64_t first_seed);

}  // namespace setae::reference
