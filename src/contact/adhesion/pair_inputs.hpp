// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "setae/adhesion/pair_point.hpp"

namespace setae::adhesion {

/// y − f(W) of pairs at one W, and its known errors without the scatter.
struct PairResiduals {
    Eigen::VectorXd value;       ///< y − f
    Eigen::MatrixXd design;      ///< ∂f/∂θ, one column a parameter that some pair answers to
    Eigen::VectorXd share;       ///< share of an error of the balance that passes its floor
    Eigen::MatrixXd covariance;  ///< covariance of own noise and inputs
};

/// Shared errors of pairs, looked up by the names of inputs once for all W.
///
/// Inputs change measured − prediction(W) by ρ m + e − σ (W s − o): m, e those of the measured value, s, o of the line,
/// ρ and σ as in residual_inputs(). Products of all of these over all pairs give the covariance at any W.
class PairInputs {
public:
    /// @throws InvalidArgument where two values have one input with different numbers of directions.
    explicit PairInputs(const std::vector<PairPoint>& pairs);

    /// The design has one column, or none where no pair answers to W.
    [[nodiscard]] PairResiduals residuals_at(double work) const;

private:
    enum Part : Index { measured, noise, slope, offset, parts };

    [[nodiscard]] auto products(Index a, Index b) const { return products_.block(a * size_, b * size_, size_, size_); }
    /// PairPoint::prediction_variance().
    [[nodiscard]] double prediction_variance(Index pair, double work) const;

    const std::vector<PairPoint>& pairs_;
    Index size_;
    Eigen::MatrixXd products_;  ///< part × pair, both ways
};

/// residual_inputs() of each.
[[nodiscard]] std::vector<Components> residual_inputs(const std::vector<PairPoint>& pairs, double work);

}  // namespace setae::adhesion
