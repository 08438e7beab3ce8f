// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// What each pair of a fit weighs, held while the pairs move a little: W + hᵀ (y − f(W)), >= 0. With the covariance of the
/// fit held instead, a least cost may lie far off, where that covariance does not hold: a W of 0 takes pairs' predictions
/// away, not their errors.
class GeneralisedWeights {
public:
    GeneralisedWeights(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit);

    /// W of as many pairs.
    [[nodiscard]] double work_of(const std::vector<PairPoint>& pairs) const;

private:
    Eigen::VectorXd weights_;  ///< h
    double work_;
};

}  // namespace setae::adhesion
