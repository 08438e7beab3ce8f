// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "setae/core/traced_value.hpp"

namespace setae::statistics {

/// Values that share inputs, conditioned on further knowledge of these inputs.
///
/// Inputs are directions ξ ~ N(0, 1), as in Component. Residuals r + Cξ = 0, measured minus computed, are one fit of
/// all inputs to all of them, to first order:
///
///   ξ = −Cᵀ S⁻¹ r,  S = C Cᵀ,  covariance P = 1 − Cᵀ S⁻¹ C
///
/// P is a projection, so that a value y + dᵀξ has the components P d afterwards: updated values keep their covariances.
/// Source: Gauß and Markov; JCGM 102:2011, 6.2.1 (multivariate models); Rauch et al. (1965) for one step.
class ConditionedValues {
public:
    /// @throws UndefinedDataError where residuals do not depend on their inputs independently: S is singular.
    explicit ConditionedValues(const std::vector<TracedValue>& residuals);

    [[nodiscard]] TracedValue updated(const TracedValue& value) const;

    [[nodiscard]] double chi2() const { return chi2_; }  ///< rᵀ S⁻¹ r, with as many degrees of freedom as residuals
    /// ln density of the residuals: −(n ln 2π + ln|S| + χ²)/2.
    [[nodiscard]] double log_likelihood() const { return log_likelihood_; }
    /// Inputs of the residuals, and the shift of each in its standard errors; several directions together.
    [[nodiscard]] const std::map<std::string, double>& moves() const { return moves_; }

private:
    /// First position of each input's directions, and their number.
    std::map<std::string, std::pair<Index, Index>> places_;
    Eigen::MatrixXd basis_;  ///< Q of Cᵀ = Q R: P = 1 − Q Qᵀ
    Eigen::VectorXd shift_;  ///< ξ
    double chi2_ = 0.0, log_likelihood_ = 0.0;
    std::map<std::string, double> moves_;

    [[nodiscard]] Eigen::VectorXd directions_of(const TracedValue& value) const;
};

}  // namespace setae::statistics
