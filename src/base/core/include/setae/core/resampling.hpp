// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "setae/core/estimate.hpp"

namespace setae {

/// A statistic without each member of one stratum in turn (one instrument's measurements), the others complete.
using LeaveOneOut = std::vector<double>;

/// The delete-one jackknife, stratified.
///
///   v_g = (n_g − 1)/n_g Σ_i (θ_(gi) − θ_(g·))²,  SE² = Σ_g v_g,  interval θ ± t_ν SE,  ν by Satterthwaite from ν_g =
///   n_g − 1
///
/// value: θ of all members. strata: θ without each member of stratum g; strata of one member give no variance and are
/// passed over. Returns method "jackknife t"; no standard error where no stratum has two members.
/// Source: Efron, Tibshirani, An Introduction to the Bootstrap (1993), ch. 11.
[[nodiscard]] Estimate jackknife_estimate(double value, std::span<const LeaveOneOut> strata, double level = 0.95);

/// Between the quantiles (1 ∓ level)/2 of the replicas.
/// @throws InvalidArgument for fewer than 2 replicas.
[[nodiscard]] Interval percentile_interval(std::vector<double> replicas, double level = 0.95);

}  // namespace setae
