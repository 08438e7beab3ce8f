// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// Motion of the testing machine during the first contact of a record.
struct LoopDrive {
    double approach_speed = 0.0;    ///< speed of the motor [m/s], > 0
    double retraction_speed = 0.0;  ///< speed of the motor [m/s], > 0
    double hold_time = 0.0;         ///< hold time at the turning point [s]
};

/// Speeds of free flight before the jump in and after pull-off, where the displacement is that of the motor; without
/// free flight, of δ + F/k_m along the branch. The hold time is the time between both slopes extended to the farthest
/// position.
///
/// machine_stiffness: k_m [N/m]; infinite: fixed grips. Empty for a record without time, displacement or retraction, or
/// whose motor does not move forth and back.
[[nodiscard]] std::optional<LoopDrive> loop_drive(const LoopAnalysis& analysis,
                                                  double machine_stiffness = std::numeric_limits<double>::infinity());

}  // namespace setae::loops
