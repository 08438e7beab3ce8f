// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "pair_inputs.hpp"
#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// @throws UndefinedDataError for a matrix that is not positive definite.
[[nodiscard]] Eigen::LLT<Eigen::MatrixXd> factor_of(const Eigen::MatrixXd& covariance);

/// (XᵀV⁻¹X)⁻¹XᵀV⁻¹, one row a parameter: how far it moves with each y − f.
[[nodiscard]] Eigen::MatrixXd generalised_weights(const Eigen::MatrixXd& design, const Eigen::MatrixXd& covariance);

/// Which effects of the model are told from each other.
struct ScatterLevels {
    bool surfaces = true, elastomers = true;
};

/// The scatter of pairs about their balance, by restricted maximum likelihood.
class ScatterFit {
public:
    /// wanted: effects of surfaces (elastomers) are looked for where there are three of them, one with several pairs.
    ScatterFit(const std::vector<PairPoint>& pairs, ScatterLevels wanted);

    /// V: what is known and the scatter. Where nothing is uncertain every pair counts alike.
    [[nodiscard]] Eigen::MatrixXd covariance(const PairResiduals& at, const ModelScatter& scatter) const;
    /// −½ (rᵀPr + ln|V| + ln|XᵀV⁻¹X|), without its constant.
    [[nodiscard]] double restricted_log_likelihood(const PairResiduals& at, const ModelScatter& scatter) const;
    /// −½ (rᵀV⁻¹r + ln|V| + n ln 2π).
    [[nodiscard]] double log_likelihood(const PairResiduals& at, const ModelScatter& scatter) const;
    [[nodiscard]] bool tells(double ModelScatter::*level) const;
    /// The most likely scatter, from one that is near; of a level that the pairs do not tell, that one's.
    [[nodiscard]] ModelScatter most_likely(const PairResiduals& at, ModelScatter scatter) const;
    /// Components of a parameter that moves with y − f by h: inputs, noise of every pair and the scatter.
    [[nodiscard]] Components components(const PairResiduals& at, const std::vector<Components>& inputs,
                                        const ModelScatter& scatter, const Eigen::VectorXd& h) const;

private:
    class Restricted;

    void write_covariance(const PairResiduals& at, const ModelScatter& scatter, Eigen::MatrixXd& whole) const;
    void add_scatter(Components& result, const PairResiduals& at, const ModelScatter& scatter,
                     const Eigen::VectorXd& h) const;

    const std::vector<PairPoint>& pairs_;
    Eigen::MatrixXd same_surface_, same_elastomer_;
    std::vector<double ModelScatter::*> levels_;
    double largest_ = 0.0;
};

}  // namespace setae::adhesion
