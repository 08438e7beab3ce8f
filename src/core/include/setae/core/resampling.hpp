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
/// @throws InvalidArgument for fewer than 2 replicas (all three).
[[nodiscard]] Interval percentile_interval(std::vector<double> replicas, double level = 0.95);

/// Bias-corrected and accelerated: quantiles of the replicas at Φ(z0 + (z0 ± z)/(1 − a (z0 ± z))).
///
/// z0: from the share of replicas below the value. a: Σ d³/(6 (Σ d²)^1.5) of the jackknife's d = θ_(·) − θ_(i), by
/// stratum with its factor (n_g − 1)/n_g. A share of 0 or 1 is taken half a replica inwards. Source: Efron, J. Am.
/// Stat. Assoc. 82 (1987) 171, (4.4), (6.6).
[[nodiscard]] Interval bca_interval(double value, std::vector<double> replicas, std::span<const LeaveOneOut> strata,
                                    double level = 0.95);

/// Studentised: value − q SE, q the quantiles of (replica − value)/(its own standard error).
///
/// replica_errors: of each replica; those that are not > 0 are passed over.
/// Source: Efron, Tibshirani (1993), ch. 12.
[[nodiscard]] Interval bootstrap_t_interval(const Estimate& value, std::span<const double> replicas,
                                            std::span<const double> replica_errors, double level = 0.95);

}  // namespace setae
