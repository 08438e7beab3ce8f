// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The points of fits as tables: measured values, and the model at these points.

#include "setae/answers/loops.hpp"
#include "setae/core/table.hpp"
#include "setae/loops/force_curve_fit.hpp"

namespace setae::answers {

/// The record as analysed: force relative to its zero, drift and deflection of the testing machine subtracted.
[[nodiscard]] Table corrected_record(const AnalysedLoop& loop);

/// Samples of the fits of a branch; no columns where the loop has no such branch.
[[nodiscard]] Table fitted_samples(const AnalysedLoop& loop, loops::LoopBranch branch);

/// Displacement and force of a segment with the fitted samples: columns "displacement", "force", "best_fit", NaN where
/// a sample was not fitted.
[[nodiscard]] Table fitted_segment(const loops::ForceCurveFit& fit);

}  // namespace setae::answers
