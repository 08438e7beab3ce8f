// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "setae/core/estimate.hpp"

namespace setae {

/// Values of a statistic, each without one member of a stratum (the measurements of one instrument); all other strata
/// are complete.
using LeaveOneOut = std::vector<double>;

/// The delete-one jackknife, stratified.
///
///   v_g = (n_g − 1)/n_g Σ_i (θ_(gi) − θ_(g·))²,  SE² = Σ_g v_g,  interval θ ± t_ν SE,  ν by Satterthwaite from ν_g =
///   n_g − 1
///
/// value: θ of all members. strata: θ without each member of stratum g; strata with one member give no variance and are
/// skipped. Returns method "jackknife t"; no standard error if no stratum has two members.
/// Source: Efron, Tibshirani, An Introduction to the Bootstrap (1993), ch. 11.
[[nodiscard]] Estimate jackknife_estimate(double value, std::span<const LeaveOneOut> strata, double level = 0.95);

/// Interval between the quantiles (1 ∓ level)/2 of the replicas.
/// @throws InvalidArgument for fewer than 2 replicas.
[[nodiscard]] Interval percentile_interval(std::vector<double> replicas, double level = 0.95);

}  // namespace setae
