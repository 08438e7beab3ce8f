// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::imaging {

/// A curve in a picture [px], with vacuum on the left as displayed.
struct PlaneCurve {
    Array1D x, y;
    bool closed = false;  ///< the last point is joined to the first

    [[nodiscard]] Index size() const { return x.size(); }
    [[nodiscard]] double length() const;
    /// The index of a point, wrapped if the curve is closed, otherwise limited to its ends.
    [[nodiscard]] Index at(Index i) const;
};

/// Unit normals of a curve, towards its left.
struct Normals {
    Array1D x, y;
};
[[nodiscard]] Normals normals(const PlaneCurve& curve);

/// Points at equal distances close to `step` along the polyline, its ends kept; `smooth`: on a cubic (Catmull–Rom)
/// instead.
[[nodiscard]] PlaneCurve resampled(const PlaneCurve& curve, double step, bool smooth);

/// Mean of the points with a Gaussian weight of `deviation` points; ends are mirrored at the end points, which remain
/// fixed.
[[nodiscard]] PlaneCurve smoothed(const PlaneCurve& curve, double deviation);

}  // namespace setae::imaging
