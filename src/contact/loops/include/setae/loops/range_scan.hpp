// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// The loading fit over part of its branch.
struct RangeFit {
    Index dropped = 0;         ///< samples left out after the jump-in
    double force_share = 1.0;  ///< share of the largest force at which the range ends
    Outcome<JkrFit> fit;
};

/// Dependence of E* and W of loading on the begin and end of the fit.
///
/// Along a fit's error ellipse E* and W are correlated, dW/dE* = ρ σ_W/σ_E*. Where the fits of other ranges lie along
/// that line, a W that increases with the range means that the two cannot be distinguished, not that adhesion
/// increases.
struct RangeScan {
    std::vector<RangeFit>
        by_start;  ///< dropped 0, 1, 2, 3, 5, 7, 10 … up to half of the branch; range to the largest force
    std::vector<RangeFit> by_end;  ///< force shares 0.3, 0.4 … 1; samples dropped as in the options
    double slope = 0.0;            ///< slope of W against E* over all fits [J/m² per Pa]; NaN for fewer than three
    double ellipse_slope = 0.0;    ///< ρ σ_W/σ_E* of the fit over the whole range
};

/// @throws UndefinedDataError for a loop whose loading has too few samples for any fit.
[[nodiscard]] RangeScan scan_ranges(const LoopAnalysis& analysis, const LensAndCounterBody& bodies,
                                    const AnalysisOptions& options);

}  // namespace setae::loops
