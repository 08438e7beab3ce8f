// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/estimate.hpp"

namespace setae {

/// Ratio of the standard deviations of max(0, X) and X, X normal with this mean and standard deviation.
///
///   √[(1 + z²) Φ(z) + z φ(z) − (z Φ(z) + φ(z))²],  z = mean/deviation
///
/// 1 far above 0, 0.58 at 0, 0.24 at z = −1.1, 0 far below. deviation 0: 1 for means above 0, ½ at 0, otherwise 0.
[[nodiscard]] double rectified_share(double mean, double deviation);

/// max(0, X) of an estimate X: value and interval are at least 0, the standard error is that of a rectified normal
/// variable.
[[nodiscard]] Estimate rectified(Estimate raw);

}  // namespace setae
