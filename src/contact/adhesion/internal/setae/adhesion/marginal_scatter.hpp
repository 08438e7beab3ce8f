// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// Surface and elastomer of a residual.
struct PairLabels {
    std::string surface, elastomer;
};

/// At how many quantiles of the prior each level is taken.
struct ScatterNodes {
    int pair = 10, surface = 8, elastomer = 8;
};

/// Scatter of pairs, surfaces and elastomers integrated out of the density of residuals.
///
///   r ~ N(0, C + τ² 1 + τ_s² S + τ_e² E),  τ, τ_s, τ_e ~ half-Cauchy(scale)
///
/// S, E: 1 for pairs of one surface, of one elastomer. Each level is summed over equally probable pieces of its prior,
/// each represented by its median: scale · tan(π p/2), p = (i + ½)/n. Log densities at 10 × 8 × 8 nodes are within 0.2
/// of those at 24 × 14 × 14 (test MarginalScatter).
///
/// With four surfaces, the most likely scatter would treat a bias as an effect that all surfaces share by chance; the
/// integral over the scatter does not. Source of the prior: Gelman, Bayesian Anal. 1 (2006) 515.
class MarginalScatter {
public:
    /// scale: of the prior [as the residuals], > 0. @throws InvalidArgument outside its domain, or without pairs.
    MarginalScatter(const std::vector<PairLabels>& pairs, double scale, ScatterNodes nodes = {});

    [[nodiscard]] Eigen::Index size() const { return same_surface_.rows(); }

    /// One node: the scatter there, ln of its weight in the prior, and the factor of its covariance.
    struct Node {
        ModelScatter scatter;
        double log_weight = 0.0;
        const Eigen::LLT<Eigen::MatrixXd>& factor;
    };
    /// Visits all nodes, in one order. covariance: C.
    /// @throws UndefinedDataError where a covariance is not positive definite.
    void visit(const Eigen::MatrixXd& covariance, const std::function<void(const Node&)>& visitor) const;

    /// ln densities of residuals, one column each, [unit of the residuals]^−n.
    [[nodiscard]] Eigen::VectorXd log_densities(const Eigen::MatrixXd& covariance,
                                                const Eigen::MatrixXd& residuals) const;

    /// Square roots of the posterior means of τ², τ_s², τ_e².
    [[nodiscard]] ModelScatter posterior_scatter(const Eigen::MatrixXd& covariance,
                                                 const Eigen::VectorXd& residuals) const;

    /// C with a scatter.
    [[nodiscard]] Eigen::MatrixXd with(const Eigen::MatrixXd& covariance, const ModelScatter& scatter) const;

private:
    Eigen::MatrixXd same_surface_, same_elastomer_;
    std::vector<double> pair_levels_, surface_levels_, elastomer_levels_;
};

/// Sums of exp(x) kept as logarithms.
class LogSum {
public:
    void add(double x);
    [[nodiscard]] double value() const;

private:
    double largest_ = -1e300, sum_ = 0.0;
};

}  // namespace setae::adhesion
