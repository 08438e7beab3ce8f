// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "both_branches.hpp"
#include "setae/adhesion/left_out.hpp"

namespace setae::hysteresis {

/// Half-Cauchy scales of the scatter of both branches [J/m²], the same for all models that are compared.
struct ScatterScales {
    double approach = 0.0, retraction = 0.0;
};

/// A model fitted to the pairs of all groups but one.
struct FittedToOthers {
    std::vector<Eigen::Index> seen;  ///< places of these pairs
    BranchLines on_approach, on_retraction;
    Eigen::MatrixXd gain;  ///< shift of the inputs by approach per residual of each pair in the fit
};

/// Evidence for one model from pairs that are left out.
struct LeftOutEvidence {
    /// ln density of the measured values of each surface by all others, summed over surfaces [(J/m²)^−n].
    double approach = 0.0, retraction = 0.0;
    std::vector<adhesion::LeftOutPrediction> predictions;  ///< of W_ret
    std::vector<FittedToOthers> fits;                      ///< one each group

    [[nodiscard]] double both() const { return approach + retraction; }
};

/// Evidence for a model from all pairs together.
struct WholeEvidence {
    Estimate work_of_adhesion;  ///< W_int by both branches [J/m²]
    adhesion::ModelScatter approach_scatter;
    Estimate constant;           ///< constant error of W_ret of all pairs [J/m²], where it is free
    double constant_tail = 1.0;  ///< probability of a constant at least as far from 0 if there were none
};

/// Noise that measured values might have had besides, one column a draw: of W_app and of W_ret [J/m²].
struct DrawnNoise {
    Eigen::MatrixXd approach, retraction;
};

/// Leaves out every surface (group = surface) or every elastomer, and predicts both branches of its pairs by a fit of
/// W_int, of the model's number and of all inputs to the others, scatter integrated out.
///
///   ln L = Σ_surfaces Σ_branches ln m(all) − ln m(others)
///
/// m: marginal density of the residuals by adhesion::MarginalScatter, at inputs where the others put them.
[[nodiscard]] LeftOutEvidence left_out_evidence(const BothBranches& model, const std::vector<RankedPair>& pairs,
                                                const ScatterScales& scales, bool by_surface, bool with_constant);

/// The ln densities of left_out_evidence() with each column of noise added to the data, after those of the data.
struct VariedEvidence {
    Eigen::VectorXd approach, retraction;

    [[nodiscard]] Eigen::VectorXd both() const { return approach + retraction; }
};

/// The fits are those to the data.
[[nodiscard]] VariedEvidence varied_evidence(const LeftOutEvidence& evidence, const std::vector<RankedPair>& pairs,
                                             const ScatterScales& scales, const DrawnNoise& noise);

/// rms of measured W_app minus that of a fit of W_int and inputs, with equal weights [J/m²]. scale: of the scatter
/// [J/m²].
[[nodiscard]] double rms_of_approach(const BothBranches& model, const std::vector<RankedPair>& pairs, double scale);

[[nodiscard]] WholeEvidence whole_evidence(const BothBranches& model, const std::vector<RankedPair>& pairs,
                                           const ScatterScales& scales, bool with_constant);

}  // namespace setae::hysteresis
