// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tip.hpp"

namespace setae::topography {

/// Assumptions on the tip for a blind estimate.
struct BlindTipOptions {
    Index points_x = 21, points_y = 21;  ///< extent of the estimate in pixels of the map, odd
    double noise_threshold = 0.0;        ///< [m], >= 0: only a larger contradiction by the image sharpens the tip
    int rounds = 100;                    ///< maximum number of sweeps over the image, > 0
    parallel::Threads threads;
};

/// A bound of the tip from its own scan.
struct BlindTip {
    ArrayTip tip;            ///< not above the true tip at any point of the extent, relative to the apex
    bool converged = false;  ///< the last sweep caused no change
    int rounds = 0;          ///< number of sweeps
};

/// The bluntest tip that is compatible with the image.
///
/// If the tip at x touched the surface at x + u, the height of the surface there is i(x) + t(u), and no other position
/// of the tip penetrates it: i(x + u) >= i(x) + t(u) and t(v) >= i(x) + t(u) − i(x + u − v) for all v. The offset u of
/// the contact is unknown, so from t = 0
///
///   t(v) <- max[t(v), min_u {i(x) + t(u) − i(x + u − v)} − ε]  over u with i(x + u) >= i(x) + t(u) − ε
///
/// first from the local peaks of the image, then from the points that opening with the tip (erosion, then dilation)
/// lowers by more than ε, until nothing changes; ε: the threshold plus 1e-12 of the height range. Points nearer to the
/// end of the window (unless periodic) or to an undefined height than the extent are left out. The estimate is never
/// above the true tip if the tip touches within the extent and ε is at least twice the largest deviation of the noise.
/// It equals the tip if the surface has features sharper than the tip. Same bytes for any number of threads.
/// @throws InvalidArgument for extents that are even or not positive, a map without a point farther from its ends than
/// the extent, a negative threshold or no rounds; UndefinedDataError if undefined heights leave no such point. Source:
/// Villarrubia 1997, section 4 and appendix.
[[nodiscard]] BlindTip blind_tip(const HeightMap& image, const BlindTipOptions& options = {});

}  // namespace setae::topography
