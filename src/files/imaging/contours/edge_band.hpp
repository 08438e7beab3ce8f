// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "plane_curve.hpp"
#include "two_phases.hpp"

namespace setae::imaging {

/// A pixel near a curve. It belongs only to the nearest place of the curve: without interpolation white noise remains
/// white.
struct BandPixel {
    Index index = 0;      ///< the place is between points `index` and the next
    double fraction = 0;  ///< fraction of the distance, in [0, 1]
    double distance = 0;  ///< [px], positive on the left hand (vacuum)
    double value = 0;     ///< grey level
};

/// Finds the pixels near curves through one picture.
class EdgeBand {
public:
    /// Keeps references to both, which must outlive this object. hidden: 1 where the picture shows no sample.
    EdgeBand(const FramePixels& pixels, const PixelMask& hidden);

    /// Pixels within `reach` of a curve whose points are about a pixel apart, except hidden ones and those beyond the
    /// ends of an open curve.
    [[nodiscard]] std::vector<BandPixel> near(const PlaneCurve& curve, double reach);

private:
    const FramePixels& pixels_;
    const PixelMask& hidden_;
    std::vector<std::int32_t> slot_;  ///< of each pixel of the picture, −1 if it is not near
};

}  // namespace setae::imaging
