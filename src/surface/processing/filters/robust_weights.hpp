// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::processing {

/// Tukey's biweight of residuals and its scale, updated after every fit.
///
///   δ = (1 − (r/c)²)² for |r| < c, otherwise 0;  c = 4.4478 median |r|
class RobustScale {
public:
    /// Weights for another fit, 0 for undefined heights; false if the scale has converged to 1e-4, is 0 or was updated
    /// 50 times.
    bool update(const ArrayView2D& heights, const ArrayView2D& smooth, Array2D& weights);
    [[nodiscard]] int updates() const { return updates_; }

private:
    double scale_ = 0.0;
    int updates_ = 0;
};

}  // namespace setae::processing
