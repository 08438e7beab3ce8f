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

/// Effects of the model that can be distinguished.
struct ScatterLevels {
    bool surfaces = true, elastomers = true;
};

/// The scatter of pairs about their balance, by restricted maximum likelihood.
class ScatterFit {
public:
    /// wanted: effects of surfaces (elastomers) are estimated where there are three of them, one with several pairs.
    ScatterFit(const std::vector<PairPoint>& pairs, ScatterLevels wanted);

    /// V: known errors and the scatter. Without any uncertainty all pairs have equal weights.
    [[nodiscard]] Eigen::MatrixXd covariance(const PairResiduals& at, const ModelScatter& scatter) const;
    /// −½ (rᵀPr + ln|V| + ln|XᵀV⁻¹X|), without its constant.
    [[nodiscard]] double restricted_log_likelihood(const PairResiduals& at, const ModelScatter& scatter) const;
    /// −½ (rᵀV⁻¹r + ln|V| + n ln 2π).
    [[nodiscard]] double log_likelihood(const PairResiduals& at, const ModelScatter& scatter) const;
    [[nodiscard]] bool tells(double ModelScatter::*level) const;
    /// The most likely scatter: the highest of the maxima that are reached from `scatter` and from a grid over all
    /// levels. For a level that the pairs do not determine, that of `scatter`.
    [[nodiscard]] ModelScatter most_likely(const PairResiduals& at, ModelScatter scatter) const;
    /// The summit next to `scatter`: where the highest is known to be near.
    [[nodiscard]] ModelScatter nearest_summit(const PairResiduals& at, const ModelScatter& scatter) const;
    /// Components of a parameter that moves with y − f by h: inputs, noise of every pair and the scatter.
    [[nodiscard]] Components components(const PairResiduals& at, const std::vector<Components>& inputs,
                                        const ModelScatter& scatter, const Eigen::VectorXd& h) const;

private:
    class Restricted;

    [[nodiscard]] ModelScatter climbed(Restricted& restricted, ModelScatter scatter, double reach) const;
    [[nodiscard]] std::vector<ModelScatter> summits_of_grid(Restricted& restricted, double reach) const;
    /// The largest scatter that is looked for.
    [[nodiscard]] double reach_of(const PairResiduals& at) const;
    void write_covariance(const PairResiduals& at, const ModelScatter& scatter, Eigen::MatrixXd& whole) const;
    void add_scatter(Components& result, const PairResiduals& at, const ModelScatter& scatter,
                     const Eigen::VectorXd& h) const;

    const std::vector<PairPoint>& pairs_;
    Eigen::MatrixXd same_surface_, same_elastomer_;
    std::vector<double ModelScatter::*> levels_;
    double largest_ = 0.0;
};

}  // namespace setae::adhesion
