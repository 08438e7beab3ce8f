// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/topography/traced_curve.hpp"

namespace setae::topography {

/// A curve rotated so that its mean line is horizontal with vacuum above, in the direction +x; points differ from their
/// predecessors.
struct OrientedCurve {
    Array1D x, y;            ///< [m], y about the mean line
    Array1D along;           ///< length from the beginning of the curve [m]
    Array1D standard_error;  ///< along the normal [m]; empty if unknown

    [[nodiscard]] OrientedCurve points(const std::vector<Index>& chosen) const;

    /// x at a length along the curve [m].
    [[nodiscard]] double x_at(double length) const;

    /// Standard errors along h [m]: those along the normal divided by the cosine of the slope over five points, at most
    /// by the cosine 0.1. Empty if unknown.
    [[nodiscard]] Array1D height_error() const;
};

struct Orientation {
    OrientedCurve curve;
    double rotation = 0.0;  ///< [rad], counterclockwise
};

/// Defined points that differ from their predecessors; a closed outline's last one also from its first.
/// @throws InvalidArgument for arrays of different size; UndefinedDataError if fewer than two are left.
[[nodiscard]] std::vector<Index> distinct_points(const TracedCurve& traced);

/// A closed outline is reduced to its upper part from the leftmost to the rightmost point, not rotated; heights about
/// its mean.
/// @throws as distinct_points.
[[nodiscard]] Orientation oriented_curve(const TracedCurve& traced);

/// CLOSED_OUTLINE with the share of the outline visible from above. length: of that part [m].
[[nodiscard]] Alert closed_outline_alert(const TracedCurve& traced, double length);

}  // namespace setae::topography
