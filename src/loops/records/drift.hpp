// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/loop_energy.hpp"

namespace setae::loops {

/// Zero of force along a record, before.force + share · change, and what is uncertain in it.
///
///   between_baselines   share runs from 0 in the middle of the first baseline to 1 in that of the second
///   extrapolated        share is the time since the middle of the first baseline, change its slope
struct ForceZero {
    Array1D share;  ///< empty where the zero is constant
    double change = 0.0;
    double change_standard_error = 0.0;
    double weight_lost = 0.0;  ///< of the first baseline with each unit of share: 1 between baselines, 0 extrapolated

    [[nodiscard]] bool constant() const { return share.size() == 0; }
};

/// The zero of force that a record's baselines allow; constant where they do not allow the drift wanted.
[[nodiscard]] ForceZero force_zero(const Loop& loop, const Segments& segments, DriftModel drift);

/// The loop with its zero of force where the first baseline has it throughout.
[[nodiscard]] Loop without_force_drift(const Loop& loop, const Segments& segments, DriftModel drift);

/// The loop with a drift of the displacement at a known rate [m/s] taken off, counted from the first sample.
/// @throws InvalidArgument where the rate is not 0 and the record has no time that runs on.
[[nodiscard]] Loop without_displacement_drift(const Loop& loop, double rate);

}  // namespace setae::loops
