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
    double size = 0.0;          ///< [N]: the line through the samples after it minus that through those before it
    double significance = 0.0;  ///< |size| over its error
};

/// On which side of a jump the record is in free flight.
enum class FreeSide { neither, before, after };

/// Where jumps are looked for.
struct JumpSearch {
    IndexRange samples;    ///< samples of the jump
    double sign = 0.0;     ///< 1: upwards, −1: downwards, 0: both
    double noise = 0.0;    ///< σ_F of one sample [N]
    Index half_width = 4;  ///< of the windows of slopes: lines of this number of samples, half of it and four are tried
    FreeSide free_side = FreeSide::neither;
    double flat = 0.0;  ///< slope in time that the force in free flight stays below [N a unit of the clock]
};

/// Jumps that exceed six times their error, of all widths and of gaps of 0, 1, 3 and 7 samples.
///
/// The size is the difference of the lines on both sides of the gap, extrapolated to its middle: zero for a steady
/// drift. Its error is that of the lines, whose scatter is at least the noise, and at least 1.4826 times the median
/// deviation of all such differences in the section: slow noise and bends are not jumps. clock: increasing strictly.
/// Cost: linear.
[[nodiscard]] std::vector<ForceJump> force_jumps(const Array1D& clock, const Array1D& force, const JumpSearch& search);

/// Significance of a jump [N]: its size, reduced where it takes several samples or hardly exceeds its error.
[[nodiscard]] double clarity(const ForceJump& jump);

}  // namespace setae::loops
