// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/imaging/frames.hpp"

namespace setae::imaging {

/// Whether the contact is darker or brighter than what surrounds it.
enum class Polarity { automatic, dark, bright };

/// How a contact is looked for. Lengths in pixels.
struct ContactFrameOptions {
    Polarity polarity = Polarity::automatic;
    bool fringes = false;  ///< rings around the contact: its edge ends the uniform centre, and need not be the
                           ///< strongest; it is right to 0.5 px where the first bright ring lies within 2.5 px of it
    double smallest_radius = 5.0;  ///< smaller contacts count as none
    double min_confidence = 0.5;   ///< of a contact that is reported
};

/// What a frame gave.
enum class FrameState {
    measured,
    no_contact,  ///< nothing stands out of noise and illumination: radius 0
    not_found,   ///< something is there, but no disc
    bad_frame,   ///< the frame could not be read or is blank
    excluded,    ///< by the user, who gave a reason
};

/// An ellipse [px] with standard errors; circle: semi_major = semi_minor.
struct EdgeEllipse {
    double centre_x = 0, centre_y = 0;  ///< of the whole frame
    double semi_major = 0, semi_minor = 0;
    double angle = 0;  ///< [rad] of the major axis from x towards y, in (−π/2, π/2]
    double centre_standard_error = 0;
    double semi_major_standard_error = 0, semi_minor_standard_error = 0;
};

/// The contact of one frame. Lengths in pixels; numbers are NaN where state is not `measured`, but radius 0 without
/// contact.
///
/// Along N rays from the centre, each with the pixels of its own sector, level, contrast and place of the edge are
/// fitted,
///   I(d) = level + contrast/2 erf((d − place)/(√2 w)),  d: distance from the ellipse along its normal, w: edge_width
///   of all rays,
/// a ray agrees where its contrast has the polarity and exceeds 0.3 of the rays' median and its place lies within 4
/// robust standard deviations of the ellipse. radius = sqrt(semi_major semi_minor) + w²/(2 radius), which undoes the
/// shrinking of a blurred convex edge; where less than 0.9 of the edge is seen it is the circle's.
///
/// radius_standard_error: from the scatter of places about the ellipse, at least that of pixel noise, times the square
/// root of (1 + ρ)/(1 − ρ), ρ ≥ 0 the correlation of neighbouring rays: blurred noise counts by what it tells. NaN
/// without contact. The pixel size is taken for exact.
///
/// confidence = agreeing_rays · min(1, 2 visible_share) · min(1, z/5),  z: the median ray's contrast over its standard
/// error.
struct ContactFrame {
    FrameState state = FrameState::not_found;
    std::string reason;  ///< why there is no radius, or a remark on one ("touches the border of the frame")
    Polarity polarity = Polarity::automatic;
    double radius = 0, radius_standard_error = 0;
    EdgeEllipse ellipse;
    double roundness = 0;  ///< semi_minor/semi_major, 1 where a circle was fitted
    double roundness_standard_error = 0;
    double confidence = 0;         ///< in [0, 1]
    double agreeing_rays = 0;      ///< share of the visible rays
    double visible_share = 0;      ///< of the perimeter that lies within the frame
    double contrast_to_noise = 0;  ///< of the edge, over the standard deviation of one pixel
    double edge_width = 0;         ///< w [px]
    bool partial = false;          ///< the contact reaches beyond the frame
};

/// Finds and measures the contact in grey levels. Depends on the pixels and options alone.
/// @throws InvalidArgument for a smallest radius below 3, a confidence outside [0, 1], a frame of fewer than 16 × 16
/// pixels.
[[nodiscard]] ContactFrame measure_contact_frame(const FramePixels& pixels, const ContactFrameOptions& options = {});

}  // namespace setae::imaging
