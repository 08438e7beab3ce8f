// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/core/table.hpp"
#include "setae/loops/force_curve_fit.hpp"
#include "setae/loops/outcome.hpp"

namespace setae::loops {

/// Summary of a force curve in one row.
struct ForceCurveSummary {
    /// segment of the reported E*: the approach for hertz, the retraction for a model with adhesion
    std::string fitted_segment;
    Outcome<Estimate> contact_modulus;   ///< E* [Pa]
    Outcome<Estimate> youngs_modulus;    ///< E of the sample [Pa]
    Outcome<Estimate> work_of_adhesion;  ///< W [J/m²]: of the fit where its model has one, else from the pull-off
    Outcome<Estimate> pull_off_force;    ///< smallest force of the retraction [N], < 0
    Outcome<Estimate> energy_loss;       ///< ∮F dδ of approach and retraction [J]
    bool work_by_pull_off = false;       ///< W = 2|F_po|/(3πR), the pull-off under fixed load (Eq. S1)
};

/// A number of a summary, with its names and its unit.
struct CurveQuantity {
    const char* name;
    const char* symbol;
    const char* column;  ///< name in tables: "E_star"
    const char* unit;
    Outcome<Estimate> ForceCurveSummary::*value;
};
/// E*, E, W, pull-off force, energy loss.
[[nodiscard]] std::span<const CurveQuantity> curve_quantities();

/// The summary of a curve with one fitted segment.
///
///   σ²(F_po) = σ_F² (1 + 1/n + (δ_po − δ̄)²/S),   σ²(E_loss) = Σ [σ_F² Σ w² + σ_F² L² (1/n + (δ_m − δ̄)²/S)]
///
/// σ_F: noise of force about the baseline's line of n samples with mean δ̄ and sum of squares S; w: weights of the
/// trapezoid rule; L, δ_m: length and middle of the integrated displacements, which both branches pass; the sum is over
/// both branches. Missing values have a reason; a retraction whose free end scatters five times as much as that of the
/// approach gives no loss.
/// @throws as segments_of_curve; InvalidArgument for bodies and options that fit no tip.
[[nodiscard]] ForceCurveSummary summary_of_force_curve(const Table& curve, const LensAndCounterBody& bodies,
                                                       const ForceCurveFitOptions& options = {});

/// A curve with the fits of all its segments and its summary.
struct ForceCurveAnalysis {
    std::vector<NamedCurveFit> segments;
    ForceCurveSummary summary;
};
/// @throws as summary_of_force_curve.
[[nodiscard]] ForceCurveAnalysis analyse_force_curve(const Table& curve, const LensAndCounterBody& bodies,
                                                     const ForceCurveFitOptions& options = {});

}  // namespace setae::loops
