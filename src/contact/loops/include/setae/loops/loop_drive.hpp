// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// How the machine moved during the first contact of a record.
struct LoopDrive {
    double approach_speed = 0.0;    ///< of the motor [m/s], > 0
    double retraction_speed = 0.0;  ///< likewise
    double hold_time = 0.0;         ///< for which it rested at the turning point [s]
};

/// Speeds of free flight before the jump in and behind pull-off, where the motor alone moves the displacement; where
/// there is none, of δ + F/k_m along the branch. The rest is what lies between both slopes extended to the farthest
/// position.
///
/// machine_stiffness: k_m [N/m]; infinite: fixed grips. Nothing for a record without time, displacement or retraction,
/// or whose motor does not come and go.
[[nodiscard]] std::optional<LoopDrive> loop_drive(const LoopAnalysis& analysis,
                                                  double machine_stiffness = std::numeric_limits<double>::infinity());

}  // namespace setae::loops
