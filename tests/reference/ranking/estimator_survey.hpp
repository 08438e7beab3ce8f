// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"
#include "setae/adhesion/pair_point.hpp"

namespace setae::reference {

/// Which pairs are measured, and how far the full-contact balance (Eq. 7) misses them.
struct EstimatorDesign {
    std::string name;
    std::vector<adhesion::PairPoint> pairs;  ///< of which `measured` is replaced
    adhesion::ModelScatter scatter;          ///< between pairs, surfaces and elastomers [J/m²]
    int floored = -1;                        ///< pairs whose true balance is below 0 in every data set; -1: any number
};

/// W_int of one estimator over many data sets.
struct EstimatorSurvey {
    std::string estimator;
    int sets = 0;
    double bias = 0.0;        ///< mean of W_int found − true W_int [J/m²]
    double deviation = 0.0;   ///< standard deviation of W_int found [J/m²]
    double stated = 0.0;      ///< rms of the standard errors stated [J/m²]
    double width = 0.0;       ///< mean width of the 95 % intervals [J/m²]
    double covered_68 = 0.0;  ///< share of the 68.3 % intervals that cover the true W_int
    double covered_95 = 0.0;
};

inline constexpr double true_work = 0.037;  ///< W_int that every data set is made with [J/m²]

/// The pairs of these surfaces and elastomers.
[[nodiscard]] std::vector<adhesion::PairPoint> subset(const std::vector<adhesion::PairPoint>& pairs,
                                                      const std::vector<std::string>& surfaces,
                                                      const std::vector<std::string>& elastomers);

/// W_app of a design as it would be measured if W_int were true_work.
///
///   W_app = max(0, max(0, W_int r − o) + scatter + noise)
///
/// Inputs are drawn within their standard errors, slopes r and offsets o in their logarithms: the same inputs move all
/// pairs that share them. Stated inputs remain those of the design.
[[nodiscard]] std::vector<adhesion::PairPoint> drawn_pairs(const EstimatorDesign& design, std::uint64_t seed);

/// The posterior, least squares (every pair alike, pairs independent; clustered), the moment estimator (scatter such
/// that χ² is the number of degrees of freedom) and generalised least squares.
[[nodiscard]] std::vector<EstimatorSurvey> survey_estimators(const EstimatorDesign& design, int sets,
                                                             std::uint64_t first_seed);

}  // namespace setae::reference
