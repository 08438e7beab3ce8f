// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "oriented_curve.hpp"

namespace setae::topography {

/// From one length along a curve to another [m].
struct LengthRange {
    double begin = 0.0, end = 0.0;
};

/// What of a curve is seen from above.
struct Visible {
    Profile profile;                ///< positions, heights and standard errors alone
    double length = 0.0;            ///< of the curve that is seen [m]
    std::vector<LengthRange> seen;  ///< in no order
};

/// The upper envelope of a curve as a profile. Where the curve's ends lie below a stretch that runs backwards, sample
/// goes on beyond the picture: what is over those x is left out.
///
/// At a jump the lower side gives way: its points within one mean step of the curve (a third of the stretch at most)
/// are left out, so that the jump is a slope over that step. Finer steps would show a slope that the points cannot: a
/// jump J resolved over the step Δ adds J²/Δ to ∫h'²dx, which is also its part below the wavevector π/Δ.
[[nodiscard]] Visible visible_profile(const OrientedCurve& curve);

}  // namespace setae::topography
