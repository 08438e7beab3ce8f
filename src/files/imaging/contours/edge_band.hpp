// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "plane_curve.hpp"
#include "two_phases.hpp"

namespace setae::imaging {

/// A pixel near a curve. It belongs to the nearest place of the curve alone: nothing is interpolated, so that white
/// noise stays white.
struct BandPixel {
    Index index = 0;      ///< the place lies between points `index` and the next
    double fraction = 0;  ///< by this much, in [0, 1]
    double distance = 0;  ///< [px], positive on the left hand (vacuum)
    double value = 0;     ///< grey level
};

/// Finds the pixels near curves through one picture.
class EdgeBand {
public:
    /// Keeps references to both, which must outlive it. hidden: 1 where the picture shows no sample.
    EdgeBand(const FramePixels& pixels, const PixelMask& hidden);

    /// Pixels within `reach` of a curve whose points are about a pixel apart; hidden ones are left out, and those
    /// beyond the ends of an open curve.
    [[nodiscard]] std::vector<BandPixel> near(const PlaneCurve& curve, double reach);

private:
    const FramePixels& pixels_;
    const PixelMask& hidden_;
    std::vector<std::int32_t> slot_;  ///< of each pixel of the picture, −1 where it is not near
};

}  // namespace setae::imaging
