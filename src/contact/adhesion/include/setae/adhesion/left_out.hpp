// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace setae::adhesion
