// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::contact_line {

/// The edge of a contact in time: r(θ, t) about a fixed centre, one radius per direction.
///
/// Shapes: M frames, N equal angles θ_j = 2πj/N. Not for a contact of several parts, nor for a ray that meets the edge
/// more than once.
struct ContactLine {
    Array1D time;              ///< M times [s], increasing
    Array2D radius;            ///< r (M, N) [m], > 0
    double place_error = 0.0;  ///< standard deviation of the noise of one position [m], independent between positions

    [[nodiscard]] Index frames() const { return radius.rows(); }
    [[nodiscard]] Index angles() const { return radius.cols(); }
};

/// @throws InvalidArgument unless M >= 1 times increase, N >= 16, every r is finite and > 0 and the error is >= 0; the
/// message names the frame.
void require_valid(const ContactLine& line);

/// The edge at fewer angles, with the waves that these can represent. angles: from 16 to the present number.
/// @throws InvalidArgument as require_valid, and for other angles.
[[nodiscard]] ContactLine at_fewer_angles(const ContactLine& line, Index angles);

/// The edge at other times within the record [s], by linear interpolation between frames.
/// @throws InvalidArgument as require_valid, and for a time before the first frame or after the last.
[[nodiscard]] ContactLine at_times(const ContactLine& line, const ArrayView1D& times);

/// Geometry of the edge in every frame.
struct LineShape {
    Array1D mean_radius;  ///< ⟨r⟩ over angles [m]
    Array1D area;         ///< ½ ∫ r² dθ [m²]
    Array1D perimeter;    ///< ∫ √(r² + r'²) dθ [m], of the polygon through the positions; noise increases it
    /// rms of r without its first and second harmonics, those of the centre and of an ellipse [m]; includes the noise
    /// of the positions
    Array1D deviation;
};

/// @throws InvalidArgument as require_valid.
[[nodiscard]] LineShape line_shape(const ContactLine& line);

}  // namespace setae::contact_line
