// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/imaging/frames.hpp"

namespace setae::imaging {

/// Whether the contact is darker or brighter than its surroundings.
enum class Polarity { automatic, dark, bright };

/// Options of the search for a contact. Lengths in pixels.
struct ContactFrameOptions {
    Polarity polarity = Polarity::automatic;
    bool fringes = false;  ///< rings around the contact: its edge is the end of the uniform centre, not necessarily the
                           ///< strongest edge; accurate to 0.5 px if the first bright ring is within 2.5 px of it
    double smallest_radius = 5.0;  ///< smaller contacts are ignored
    double min_confidence = 0.5;   ///< of a contact that is reported
};

/// Result of a frame.
enum class FrameState {
    measured,
    no_contact,  ///< no signal above noise and illumination: radius 0
    not_found,   ///< a structure, but no disc
    bad_frame,   ///< the frame could not be read or is blank
    excluded,    ///< by the user, with a reason
};

/// An ellipse [px] with standard errors; circle: semi_major = semi_minor.
struct EdgeEllipse {
    double centre_x = 0, centre_y = 0;  ///< of the whole frame
    double semi_major = 0, semi_minor = 0;
    double angle = 0;  ///< [rad] of the major axis from x towards y, in (−π/2, π/2]
    double centre_standard_error = 0;
    double semi_major_standard_error = 0, semi_minor_standard_error = 0;
};

/// The contact of one frame. Lengths in pixels; numbers are NaN where state is not `measured`, except radius 0 without
/// contact.
///
/// Along N rays from the centre, each with the pixels of its own sector, level, contrast and place of the edge are
/// fitted:
///   I(d) = level + contrast/2 erf((d − place)/(√2 w)),  d: distance from the ellipse along its normal, w: edge_width
///   of all rays.
/// A ray agrees if its contrast has the polarity and exceeds 0.3 of the median of the rays and its place is within 4
/// robust standard deviations of the ellipse. radius = sqrt(semi_major semi_minor) + w²/(2 radius), which corrects the
/// inward shift of a blurred convex edge; if less than 0.9 of the edge is visible it is that of the circle.
///
/// radius_standard_error: from the scatter of places about the ellipse, at least that of pixel noise, times the square
/// root of (1 + ρ)/(1 − ρ), ρ ≥ 0 the correlation of neighbouring rays, which accounts for blurred noise. NaN without
/// contact. The pixel size is exact.
///
/// confidence = agreeing_rays · min(1, 2 visible_share) · min(1, z/5),  z: contrast of the median ray over its standard
/// error.
struct ContactFrame {
    FrameState state = FrameState::not_found;
    std::string reason;  ///< why there is no radius, or a warning ("touches the border of the frame")
    Polarity polarity = Polarity::automatic;
    double radius = 0, radius_standard_error = 0;
    EdgeEllipse ellipse;
    double roundness = 0;  ///< semi_minor/semi_major, 1 for a circle
    double roundness_standard_error = 0;
    double confidence = 0;         ///< in [0, 1]
    double agreeing_rays = 0;      ///< share of the visible rays
    double visible_share = 0;      ///< share of the perimeter within the frame
    double contrast_to_noise = 0;  ///< of the edge, over the standard deviation of one pixel
    double edge_width = 0;         ///< w [px]
    bool partial = false;          ///< the contact reaches beyond the frame
};

/// Finds and measures the contact in grey levels. Depends only on pixels and options.
/// @throws InvalidArgument for a smallest radius below 3, a confidence outside [0, 1], a frame of fewer than 16 × 16
/// pixels.
[[nodiscard]] ContactFrame measure_contact_frame(const FramePixels& pixels, const ContactFrameOptions& options = {});

}  // namespace setae::imaging
