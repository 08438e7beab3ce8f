// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"

namespace setae::adhesion {

/// Prediction of a pair by the other pairs.
struct LeftOutPrediction {
    /// true: all pairs of its surface are left out of the fit; false: all pairs of its elastomer
    bool surface_left_out = true;
    std::string surface, elastomer;
    /// max(0, balance) at W of the others; the standard error includes all inputs and the scatter of the model
    Estimate predicted;
    Estimate measured;             ///< measured value with its own noise
    double residual = 0.0;         ///< measured − predicted
    double standard_error = 0.0;   ///< standard error of the residual
    bool within_interval = false;  ///< whether 0 lies in the 95 % interval of the residual
};

/// Predicts every pair without the pairs of its surface, then without those of its elastomer: expected accuracy for a
/// new surface and for a new elastomer.
///
/// Predictions include the scatter of the other pairs, drawn independently for a new surface (elastomer, pair). Groups
/// whose removal leaves fewer than two pairs are skipped.
/// @throws as fit_generalised() of all pairs.
[[nodiscard]] std::vector<LeftOutPrediction> predict_left_out(const std::vector<PairPoint>& pairs);

}  // namespace setae::adhesion
