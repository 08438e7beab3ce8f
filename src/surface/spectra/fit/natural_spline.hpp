// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::spectral_fit {

/// Natural cubic spline from values at fixed positions to values at other fixed positions: a linear map, factored once.
class NaturalSpline {
public:
    /// positions: at least three, increasing. targets: increasing, within the positions.
    NaturalSpline(const Array1D& positions, const Array1D& targets);

    [[nodiscard]] Array1D operator()(const Array1D& values) const;

private:
    Array1D steps_;
    Array1D diagonal_, factor_;                      ///< of the eliminated tridiagonal system of second derivatives
    Eigen::ArrayXi interval_;                        ///< of each target
    Array1D left_, right_, left_bend_, right_bend_;  ///< weights of values and second derivatives at the ends
};

}  // namespace setae::spectral_fit
