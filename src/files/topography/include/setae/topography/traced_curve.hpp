// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/topography/contour.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// A curve as traced: it may turn back, and has the orientation of the picture.
struct TracedCurve {
    Array1D x, y;            ///< [m], y upwards, vacuum on the left in the direction of the points
    Array1D standard_error;  ///< of each point along the normal [m]; empty if unknown
    bool closed = false;
    std::optional<TraceResponse> response;  ///< along the length of the curve, noise along its normal
    Metadata metadata;
};

/// Treatment of parts where a curve is no function of x.
enum class Reentrance {
    envelope,  ///< the highest point over each x: the contact of a rigid body from above
    cut,       ///< parts that turn back are left out, see clean_contour
};

/// A part where the curve runs backwards or below itself.
struct ReentrantStretch {
    double begin = 0, end = 0;  ///< along the length of the curve [m]
    double depth = 0;           ///< distance of turning back along x [m]
};

/// A traced curve as a function of x. Metadata: attributes "rotation" and "reentrant_share" in addition to those of the
/// trace.
struct LevelledCurve {
    Profile profile;  ///< strictly increasing x from 0, heights about their mean line, errors along h, response along x
    double rotation = 0.0;                    ///< rotation of the curve [rad], counterclockwise
    std::vector<ReentrantStretch> reentrant;  ///< hidden (envelope) or removed, from the beginning of the curve on
    double reentrant_share = 0.0;             ///< of the length of the curve, 0 … 1
    std::vector<Alert> alerts;                ///< REENTRANT, CLOSED_OUTLINE
};

/// Rotates a curve so that its mean line (least perpendicular distance, by length) is horizontal with vacuum above,
/// then converts it to a function of x. A closed outline is not rotated; its upper part from the leftmost to the
/// rightmost point is used.
///
/// Envelope: at a jump, points on the lower side within one mean step are left out, so the jump is a slope over that
/// step. Steps back along x below 4 √2 standard errors are noise of the trace: such points are dropped and are no
/// re-entrant part. σ_h = σ_n/cos of the slope over five points, at most 10 σ_n. With stretch = length of the used
/// part/its extent along x, the lengths of the response are divided by stretch and N_h = N_n stretch: on a segment of
/// slope h' noise of C1D N_n along s and the normal n has the autocorrelation N_n δ(s − s') (1 + h'²) = N_n √(1 + h'²)
/// δ(x − x') along h, and ⟨√(1 + h'²)⟩ = stretch.
/// @throws InvalidArgument for arrays of different size; UndefinedDataError if fewer than two points remain.
[[nodiscard]] LevelledCurve levelled(const TracedCurve& curve, Reentrance reentrance);

/// Statistics of the whole curve over its length s, with its re-entrant parts; they need no function of x.
///
/// Exact on straight segments; a segment counts by its length, a corner for the curvature by half the length of its two
/// segments.
/// @throws as levelled.
struct ParametricStatistics {
    double length = 0.0;               ///< [m]; of a closed outline its perimeter
    double tortuosity = 0.0;           ///< length over the distance of the ends; NaN for a closed outline
    double rms_normal_distance = 0.0;  ///< from the mean line [m]
    double rms_angle = 0.0;            ///< of the direction about the mean line [rad]
    double rms_curvature = 0.0;        ///< of the curve, dθ/ds [1/m]; includes the noise of the trace
    double reentrant_share = 0.0;  ///< of the length, hidden from above by overhangs; see levelled with its envelope
};
[[nodiscard]] ParametricStatistics parametric_statistics(const TracedCurve& curve);

}  // namespace setae::topography
