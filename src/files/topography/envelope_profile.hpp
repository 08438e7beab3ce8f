// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "oriented_curve.hpp"

namespace setae::topography {

/// From one length along a curve to another [m].
struct LengthRange {
    double begin = 0.0, end = 0.0;
};

/// Parts of a curve visible from above.
struct Visible {
    Profile profile;                ///< only positions, heights and standard errors
    double length = 0.0;            ///< visible length of the curve [m]
    std::vector<LengthRange> seen;  ///< in no order
};

/// The upper envelope of a curve as a profile. If the ends of the curve are below a part that runs backwards, the
/// sample continues beyond the picture: parts over those x are left out.
///
/// At a jump, points of the lower side within one mean step of the curve (at most a third of the part) are left out, so
/// the jump is a slope over that step. A finer step would give a slope that the points do not support: a jump J
/// resolved over the step Δ adds J²/Δ to ∫h'²dx, which is also its contribution below the wavevector π/Δ.
[[nodiscard]] Visible visible_profile(const OrientedCurve& curve);

}  // namespace setae::topography
