// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/topography/contour.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// A curve as it was traced: it may turn back, and its direction is the picture's.
struct TracedCurve {
    Array1D x, y;            ///< [m], y upwards, vacuum on the left hand of who walks along it
    Array1D standard_error;  ///< of each point along the normal [m]; empty where unknown
    bool closed = false;
    std::optional<TraceResponse> response;  ///< along the curve's length, noise along its normal
    Metadata metadata;
};

/// What becomes of stretches where a curve is no function of x.
enum class Reentrance {
    envelope,  ///< the highest point over each x: what a rigid body from above meets
    cut,       ///< stretches that turn back are left out, as clean_contour does
};

/// A stretch over which the curve runs backwards or below itself.
struct ReentrantStretch {
    double begin = 0, end = 0;  ///< along the curve's length [m]
    double depth = 0;           ///< how far it turns back along x [m]
};

/// A traced curve as a function of x. Metadata: attributes "rotation" and "reentrant_share" beside those of the trace.
struct LevelledCurve {
    Profile profile;  ///< strictly increasing x from 0, heights about their mean line, errors along h, response along x
    double rotation = 0.0;                    ///< by which the curve was turned [rad], counterclockwise
    std::vector<ReentrantStretch> reentrant;  ///< hidden (envelope) or cut, from the curve's beginning on
    double reentrant_share = 0.0;             ///< of the curve's length, 0 … 1
    std::vector<Alert> alerts;                ///< REENTRANT, CLOSED_OUTLINE
};

/// Turns a curve until its mean line (least perpendicular distance, by length) is horizontal and vacuum lies above,
/// then takes it as a function of x. Of a closed outline the part from its leftmost to its rightmost point over the top
/// is taken, not turned.
///
/// Envelope: where it jumps, the lower side's points within one mean step are left out, so that the jump is a slope
/// over that step. Steps back along x below 4 √2 standard errors are the trace's noise: such points are dropped and are
/// no re-entrant stretch. σ_h = σ_n/cos of the slope over five points, at most 10 σ_n. With stretch = length of what is
/// taken/its extent along x, the response's lengths are divided by stretch and N_h = N_n stretch: on a segment of slope
/// h' noise of C1D N_n along s and the normal n has the autocorrelation N_n δ(s − s') (1 + h'²) = N_n √(1 + h'²) δ(x −
/// x') along h, and ⟨√(1 + h'²)⟩ = stretch.
/// @throws InvalidArgument for arrays of different size; UndefinedDataError where fewer than two points remain.
[[nodiscard]] LevelledCurve levelled(const TracedCurve& curve, Reentrance reentrance);

/// Statistics that need no function of x: the curve by its own length s, whole, with its re-entrant stretches.
///
/// Exact on straight segments; a segment counts by its length, a corner for the curvature by half the segments beside
/// it.
/// @throws as levelled.
struct ParametricStatistics {
    double length = 0.0;               ///< [m], of a closed outline all around
    double tortuosity = 0.0;           ///< length over the distance of its ends; NaN for a closed outline
    double rms_normal_distance = 0.0;  ///< from the mean line [m]
    double rms_angle = 0.0;            ///< of the direction about the mean line [rad]
    double rms_curvature = 0.0;        ///< of the curve itself, dθ/ds [1/m]; with the noise of the trace
    double reentrant_share =
        0.0;  ///< of the length, hidden from above by overhangs: as levelled finds with its envelope
};
[[nodiscard]] ParametricStatistics parametric_statistics(const TracedCurve& curve);

}  // namespace setae::topography
