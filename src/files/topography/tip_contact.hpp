// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/topography/dilation.hpp"

namespace setae::topography {

/// Highest minus lowest defined height of the surface, or the one of the options.
/// @throws InvalidArgument for infinite heights or a negative range, UndefinedDataError if nothing is defined.
[[nodiscard]] double height_range(const HeightMap& surface, const DilationOptions& options);

/// Distance [m] from its axis at which a tip can touch within a height range; for an ArrayTip that of its last finite
/// point.
[[nodiscard]] double contact_reach(const Tip& tip, double range);

/// The tip on the pixels of a surface, as far as it can touch.
/// @throws InvalidArgument for a tip outside its domain, or one that reaches farther than a map that is not periodic.
[[nodiscard]] TipImage touching_tip(const HeightMap& surface, const Tip& tip, const DilationOptions& options);

}  // namespace setae::topography
