// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/topography/contour.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// A curve as it was traced: it may turn back, and its direction is the picture's.
struct TracedCurve {
    Array1D x, y;              ///< [m], y upwards, vacuum on the left hand of who walks along it
    Array1D standard_error;    ///< of each point along the normal [m]; empty where unknown
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

/// A traced curve as a function of x.
struct LevelledCurve {
    Profile profile;                   ///< strictly increasing x from 0, heights about their mean line, errors along h, response along x
    double rotation = 0.0;             ///< by which the curve was turned [rad], counterclockwise
    std::vector<ReentrantStretch> reentrant;
    double reentrant_share = 0.0;      ///< of the curve's length, 0 … 1
    std::vector<Alert> alerts;         ///< REENTRANT, CLOSED_OUTLINE
};

/// Turns a curve until its mean line (least perpendicular distance, by length) is horizontal and vacuum lies above, then takes it
/// as a function of x. A closed outline is not turned.
/// @throws InvalidArgument for arrays of different size; UndefinedDataError where fewer than two points remain.
[[nodiscard]] LevelledCurve levelled(const TracedCurve& curve, Reentrance reentrance);

/// Statistics that need no function of x: the curve by its own length s, whole, with its re-entrant stretches.
///
///   share(angle): of length whose direction makes `angle` with the mean line;  tortuosity: length over the distance of its ends
struct ParametricStatistics {
    double length = 0.0, tortuosity = 0.0;
    double rms_normal_distance = 0.0;  ///< from the mean line [m]
    double rms_angle = 0.0;            ///< of the direction about the mean line [rad]
    double rms_curvature = 0.0;        ///< of the curve itself, dθ/ds [1/m]; with the noise of the trace
    double reentrant_share = 0.0;
};
[[nodiscard]] ParametricStatistics parametric_statistics(const TracedCurve& curve);

}  // namespace setae::topography
