// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "height_bands.hpp"

namespace setae::topography {

/// A height and the next one along its scan line; NaN if there is none.
struct SampledHeight {
    double height, next;
};

/// Result of one pass over heights: their range, and a sample spread over all of them.
struct HeightSample {
    double least, greatest;              ///< of all defined heights; +∞ and −∞ if there is none
    std::vector<SampledHeight> heights;  ///< the defined ones, in order of position
};

/// Positions of the sample: all points of small maps, otherwise 2^14 at irregular distances, which do not coincide with
/// the period of a grating.
[[nodiscard]] HeightSample sampled(const HeightBands& bands);

}  // namespace setae::topography
