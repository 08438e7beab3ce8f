// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/experiment/jkr_fits.hpp"

namespace setae::experiment {

/// Eq. (1) with errors in force and radius, solved for the force: F = E*·4a³/(3R) − √(E*W)·√(8πa³) is single-valued and
/// smooth in a, where a(F) ends in a fold, and linear in E* and √(E*W) once the variances σ_F² + (dF/da)² σ_a² are known;
/// those are renewed until the solution settles.
[[nodiscard]] JkrFit fit_with_both_errors(const BranchData& data, const LensAndCounterBody& bodies);

}  // namespace setae::experiment
