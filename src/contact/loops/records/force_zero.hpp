// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/force_drift.hpp"
#include "setae/loops/segments.hpp"

namespace setae::loops {

/// The zero of force that the free flight of the segments shows: their baselines before and after contact, or the force
/// given where neither has a range. A model that needs a stretch more than there is falls back to the line, and to the
/// constant.
///
///   z(t) = Σ_k c_k u^k,  u = 2 (t − t_first)/(t_last − t_first) − 1
///   Cov c = A⁻¹ (Σ_s v_s X_sᵀX_s) A⁻¹,  A = XᵀX,  v_s = σ_s² (1 + φ_s)/(1 − φ_s) of each stretch
///
/// Source: Huber, Ann. Math. Stat. 35 (1964) 73 (the weights).
[[nodiscard]] ForceZero force_zero(const Loop& loop, const Segments& segments, DriftModel model);

/// The loop with a drift of the displacement at a known rate [m/s] subtracted, counted from the first sample. @throws
/// InvalidArgument where the rate is not 0 and the record has no increasing time.
[[nodiscard]] Loop without_displacement_drift(const Loop& loop, double rate);

}  // namespace setae::loops
