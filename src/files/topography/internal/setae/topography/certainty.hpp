// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/topography/dilation.hpp"
#include "setae/topography/mask.hpp"

namespace setae::topography {

/// Points at which a scan is certain to be the true surface.
struct Certainty {
    HeightMap reconstruction;  ///< eroded(image)
    Mask certain;              ///< 1 if the reconstruction is the surface, 0 if it is an upper bound
    double share = 0.0;        ///< of certain points among defined ones
};

/// Points of the reconstruction that are the only contact for some position of the tip.
///
/// The tip at x touched the surface at a point x + u with h = i(x) + t(u) = r(x + u): if only one point has r(x + u) >=
/// i(x) + t(u) − tolerance, the surface is known there. Beyond the ends of the window and at undefined heights the
/// surface may be as high as the surrounding image allows, at most as high as the highest measured point: possible
/// contacts there count as contacts. Undefined heights remain undefined and are not certain, for any
/// options.keep_undefined. tolerance [m], >= 0: heights closer than this count as contacts; not given: 1e-9 of the
/// height range, for rounding.
/// @throws InvalidArgument as dilated, and for a negative tolerance.
/// Source: Villarrubia 1997, section 3.4.
[[nodiscard]] Certainty certainty_map(const HeightMap& image, const Tip& tip, const DilationOptions& options = {},
                                      std::optional<double> tolerance = {});

}  // namespace setae::topography
