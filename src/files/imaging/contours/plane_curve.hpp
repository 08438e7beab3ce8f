// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::imaging {

/// A curve through a picture [px], vacuum on the left hand as the picture is seen.
struct PlaneCurve {
    Array1D x, y;
    bool closed = false;  ///< the last point is joined to the first

    [[nodiscard]] Index size() const { return x.size(); }
    [[nodiscard]] double length() const;
    /// The index of a point, wrapped where the curve is closed, else held at its ends.
    [[nodiscard]] Index at(Index i) const;
};

/// Unit vectors across a curve, towards its left hand.
struct Normals {
    Array1D x, y;
};
[[nodiscard]] Normals normals(const PlaneCurve& curve);

/// Points at equal distances close to `step` along the polyline, its ends kept; `smooth`: on a cubic (Catmull–Rom)
/// instead.
[[nodiscard]] PlaneCurve resampled(const PlaneCurve& curve, double step, bool smooth);

/// The mean of its points under a Gaussian of `deviation` points; ends mirrored at themselves, so that they stay.
[[nodiscard]] PlaneCurve smoothed(const PlaneCurve& curve, double deviation);

}  // namespace setae::imaging
