// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "setae/core/arrays.hpp"

namespace setae::spectral_fit {

/// ⟨(h − ⟨h⟩)³⟩/⟨(h − ⟨h⟩)²⟩^1.5 over all points.
inline double skewness_of(const Array2D& heights) {
    const Array2D centred = heights - heights.mean();
    return centred.cube().mean() / std::pow(centred.square().mean(), 1.5);
}

}  // namespace setae::spectral_fit
