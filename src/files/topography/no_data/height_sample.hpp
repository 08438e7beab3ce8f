// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "height_bands.hpp"

namespace setae::topography {

/// A height and the next one along its scan line; NaN where there is none.
struct SampledHeight {
    double height, next;
};

/// What one pass over heights shows: their range, and a sample spread over all of them.
struct HeightSample {
    double least, greatest;              ///< of all defined heights; +∞ and −∞ where there is none
    std::vector<SampledHeight> heights;  ///< those that are defined, in the order of their places
};

/// Places of the sample: all points of small maps, else 2^14 at irregular distances, so that no grating is in step with
/// them.
[[nodiscard]] HeightSample sampled(const HeightBands& bands);

}  // namespace setae::topography
