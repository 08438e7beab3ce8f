// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// How well a pair would have been predicted by the others.
struct LeftOutPrediction {
    bool surface_left_out = true;  ///< all pairs of its surface were left out of the fit; else all of its elastomer
    std::string surface, elastomer;
    Estimate predicted;  ///< max(0, balance) at W of the others; ± of all inputs, the scatter of the model among them
    Estimate measured;   ///< own noise
    double residual = 0.0;        ///< measured − predicted
    double standard_error = 0.0;  ///< of the residual
    bool held = false;            ///< 0 lies in the 95 % interval of the residual
};

/// Every pair predicted without the pairs of its surface, then without those of its elastomer: what a fit promises of
/// the next surface, the next elastomer.
///
/// Predictions carry the scatter that the others show, which a new surface (elastomer, pair) has anew. Groups whose
/// removal leaves fewer than two pairs are passed over.
/// @throws as fit_generalised() of all pairs.
[[nodiscard]] std::vector<LeftOutPrediction> predict_left_out(const std::vector<PairPoint>& pairs);

/// How W and the scatter are found from pairs.
using PairFit = std::function<GeneralisedFit(const std::vector<PairPoint>&)>;

/// What a law with its own fit says of what that fit has not seen.
struct LeftOut {
    std::vector<LeftOutPrediction> predictions;
    /// ln density of all that was measured, every surface by the fit to the others, Σ over surfaces. Pairs of one
    /// surface together: Student's t of as many degrees of freedom as the scatter of the others was estimated with,
    /// scale matrix of everything their residuals rest on, the effect of a new surface among it. NaN for fewer than
    /// three surfaces, or where one leaves fewer than two pairs.
    double surface_log_density = 0.0;
};

/// predict_left_out() by another fit.
[[nodiscard]] LeftOut leave_out(const std::vector<PairPoint>& pairs, const PairFit& fit);

}  // namespace setae::adhesion
