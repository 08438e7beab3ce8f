// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "nested_design.hpp"
#include "setae/core/arrays.hpp"

namespace setae::statistics {

/// Variances of a design's levels where its restricted likelihood is largest.
struct LikelihoodMaximum {
    Array1D variances;            ///< one per level, >= 0
    double log_likelihood = 0.0;  ///< as VarianceFit
    bool converged = true;
};

/// ln L_R of a design at given variances, one per level.
[[nodiscard]] double log_restricted_likelihood(const NestedDesign& design, const Array1D& variances);

/// The global maximum over variances >= 0: every set of levels at 0, the others by Newton steps in ln θ from several
/// starts.
[[nodiscard]] LikelihoodMaximum maximise_restricted_likelihood(const NestedDesign& design);

/// A surface's mean, or a difference of two, at given variances.
struct GeneralizedMean {
    double value = 0.0;
    double variance = 0.0;
    Array1D gradient;  ///< derivative of the variance by each level's θ
};

/// Means and variances of a design at given θ. X: indicators of surfaces.
struct DesignInformation {
    Eigen::VectorXd means;                   ///< μ = Φ XᵀV⁻¹y, in the order of the surfaces
    Eigen::MatrixXd row_weights;             ///< Φ XᵀV⁻¹: ∂μ/∂y, a column each row of the design
    Eigen::MatrixXd means_covariance;        ///< Φ = (XᵀV⁻¹X)⁻¹
    std::vector<Eigen::MatrixXd> gradients;  ///< ∂Φ/∂θ of each level
    Array2D covariance;  ///< covariance of the variances: inverse of ½ tr(P Z_j Z_jᵀ P Z_k Z_kᵀ)

    [[nodiscard]] GeneralizedMean mean(std::size_t surface) const;
    [[nodiscard]] GeneralizedMean difference(std::size_t later, std::size_t earlier) const;
};

/// @throws InternalError where V cannot be inverted.
[[nodiscard]] DesignInformation information_of(const NestedDesign& design, const Array1D& variances);

}  // namespace setae::statistics
