// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/loops/loop.hpp"

namespace setae::loops {

/// A sudden change of force between two samples, or within some.
struct ForceJump {
    Index last = 0;             ///< sample before it
    Index next = 0;             ///< first sample after it
    double size = 0.0;          ///< [N]: the line through the samples after it less that through those before it
    double significance = 0.0;  ///< |size| over its error
};

/// On which side of a jump the record is in free flight.
enum class FreeSide { neither, before, after };

/// Where jumps are looked for.
struct JumpSearch {
    IndexRange samples;    ///< of the sample before the jump
    double sign = 0.0;     ///< 1: upwards, −1: downwards, 0: both
    double noise = 0.0;    ///< σ_F of one sample [N]
    Index half_width = 4;  ///< of the windows that show slopes: lines of so many samples, half of it and four are tried
    FreeSide free_side = FreeSide::neither;
    double flat = 0.0;  ///< slope in time that the force in free flight stays below [N a unit of the clock]
};

/// Jumps that exceed six times their error, of all widths and of gaps of 0, 1, 3 and 7 samples.
///
/// The size is what the lines on both sides of the gap differ by, extrapolated to its middle: a steady drift makes
/// none. Its error is that of the lines, whose scatter is at least the noise, and at least 1.4826 times the median
/// deviation of all such differences in the stretch: slow noise and bends do not count as jumps. clock: increasing
/// strictly. Cost: linear.
[[nodiscard]] std::vector<ForceJump> force_jumps(const Array1D& clock, const Array1D& force, const JumpSearch& search);

/// How clearly a jump is one [N]: its size, less where it takes several samples or hardly stands out.
[[nodiscard]] double clarity(const ForceJump& jump);

}  // namespace setae::loops
