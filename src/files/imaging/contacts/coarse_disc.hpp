// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "edge_ellipse.hpp"

namespace setae::imaging {

/// A disc found in a frame of reduced resolution.
struct CoarseDisc {
    Outline outline;      ///< [px] of the whole frame
    double sign = 1;      ///< +1: brighter outside
    double strength = 0;  ///< step of grey levels across its edge times its radius: glare and dust are small
};

struct CoarseSearch {
    std::vector<CoarseDisc> candidates;  ///< best first
    bool structure = false;              ///< a signal above noise and illumination
    long binning = 1;                    ///< pixels averaged in either direction
    bool last_level = false;             ///< a coarser level would have too few pixels
};

/// Discs in a frame.
///
/// The frame is averaged over squares of pixels to some 200 across (level 0), 100 (1), 50 (2), with a parabola of
/// illumination subtracted. Pixels whose gradient exceeds the noise vote for centres along their gradient (Hough 1962;
/// Ballard 1981); about the best centres the mean over circles has its step at the radius. Rays from there give points
/// of the edge, consensus of triples a circle, and reweighted least squares an ellipse.
[[nodiscard]] CoarseSearch find_discs(const FramePixels& pixels, const ContactFrameOptions& options, int level);

}  // namespace setae::imaging
