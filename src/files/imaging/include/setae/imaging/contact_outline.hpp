// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/imaging/contact_radius.hpp"

namespace setae::imaging {

/// A hole in a contact: an area inside the edge without contact.
struct ContactVoid {
    double x = 0, y = 0;  ///< centre [px] of the whole frame
    double area = 0;      ///< [px²]
};

/// The edge of a contact without a fitted ellipse. Lengths in pixels.
struct ContactOutline {
    Array1D radius;          ///< at equal angles from x towards y, about the given centre
    double place_error = 0;  ///< standard deviation of one place from pixel noise
    std::vector<ContactVoid> voids;
};

/// Finds the edge around a contact that was measured, along rays from a centre, one place per ray.
///
/// Grey levels are sampled along the rays every half pixel. The closed path of the largest sum of steps
///   s(θ, ρ) = mean over (ρ, ρ + 3 px] − mean over [ρ − 3 px, ρ), in units of the largest step of the median ray
/// less 0.05 for every half pixel it moves from a ray to the next is found by dynamic programming. On this path the
/// place is the position of an equivalent sharp edge,
///   place = ρ − 3 px + ∫_{ρ − 3 px}^{ρ + 3 px} (outer − I)/(outer − inner) dρ',
/// inner and outer: means at a distance of 3 to 7 px, over 16 px along the edge. The place is linear in the grey
/// levels: noise causes no bias. Overhangs are cut off; edges within 8 px of the centre are not found.
///
/// A void is a group of pixels, more than 4 px inside the edge, that are nearer to the outer level than to the inner
/// one after smoothing with a Gaussian of 1 px, and cover at least `smallest_void` [px²].
/// contact: of this frame, measured and not partial. centre [px] of the region, angles: >= 16.
/// @throws InvalidArgument for another contact, fewer angles, or if the rays leave the frame.
[[nodiscard]] ContactOutline trace_contact_outline(const FramePixels& pixels, const ContactFrame& contact,
                                                   double centre_x, double centre_y, Index angles,
                                                   double smallest_void = 16.0);

/// The edge in all frames of a recording with the whole edge visible.
struct RecordedLine {
    std::vector<long> frames;                     ///< numbers of the frames, one per row of the line
    Array1D time;                                 ///< M times [s]
    Array2D radius;                               ///< r (M, N) at N equal angles [m]
    double place_error = 0;                       ///< standard deviation of one place from pixel noise [m]
    double pixel_size = 0;                        ///< [m]
    double centre_x = 0, centre_y = 0;            ///< [px] of the whole frame: mean over the frames
    std::vector<std::vector<ContactVoid>> voids;  ///< of every frame
    std::vector<std::string> left_out;            ///< "frame 12: reaches beyond the frame: 80 % of its edge is seen"
};

struct LineOptions {
    std::optional<Index> angles;  ///< default: one ray per 2 px of the largest edge
    double smallest_void = 16.0;  ///< [px²]
    parallel::Threads threads;
};

/// @throws InvalidArgument as trace_contact_outline.
/// @throws UndefinedDataError if no frame shows a whole contact.
[[nodiscard]] RecordedLine measure_contact_line(const FrameSource& source, const ContactRadii& radii,
                                                const LineOptions& options = {});

}  // namespace setae::imaging
