// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/arrays.hpp"
#include "setae/core/estimate.hpp"

namespace setae {

/// Mean of n > 0 values with the standard error from their scatter.
///
///   m = Σ x_i/n,  SE² = Σ (x_i − m)²/(n (n − 1)),  ν = n − 1
///
/// method: that of the estimate. One value: no standard error.
[[nodiscard]] Estimate sample_mean(const ArrayView1D& values, const std::string& method);

}  // namespace setae
