// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::scales {

/// Sums of powers of differences about an origin; extremes.
struct DifferenceSums {
    double count = 0.0;
    double powers[4] = {0.0, 0.0, 0.0, 0.0};  ///< Σ (d − origin)^k, k = 1 … 4
    double minimum, maximum;

    DifferenceSums();
    void add(const DifferenceSums& other);
    /// Adds values; undefined ones are left out. In independent lanes for vectorisation; a second pass if one is
    /// undefined.
    void add(const double* values, Index n, double origin);
};

}  // namespace setae::scales
