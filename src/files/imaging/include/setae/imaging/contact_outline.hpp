// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/imaging/contact_radius.hpp"

namespace setae::imaging {

/// A hole in a contact: where the surfaces do not touch, inside the edge.
struct ContactVoid {
    double x = 0, y = 0;  ///< centre [px] of the whole frame
    double area = 0;      ///< [px²]
};

/// The edge of a contact as it is, no ellipse. Lengths in pixels.
struct ContactOutline {
    Array1D radius;          ///< at equal angles from x towards y, about the centre asked for
    double place_error = 0;  ///< standard deviation of one place by pixel noise
    std::vector<ContactVoid> voids;
};

/// Finds the edge around a contact that was measured, along rays from a centre, one place a ray.
///
/// Grey levels are sampled along the rays every half pixel. The closed path of the largest sum of steps
///   s(θ, ρ) = mean over (ρ, ρ + 3 px] − mean over [ρ − 3 px, ρ), in units of the median ray's largest
/// less 0.05 for every half pixel it moves from a ray to the next is found by dynamic programming; on it the place is
/// where the inside would end if the edge were sharp,
///   place = ρ − 3 px + ∫_{ρ − 3 px}^{ρ + 3 px} (outer − I)/(outer − inner) dρ',
/// inner and outer: means 3 to 7 px off, over 16 px along the edge. It is linear in the grey levels: noise makes no
/// bias. Overhangs are cut off; edges within 8 px of the centre are not seen.
///
/// A void is a group of pixels, more than 4 px inside the edge, that lie nearer to the outer level than to the inner
/// one after an average over a Gaussian of 1 px, and cover at least `smallest_void` [px²].
/// contact: of this frame, measured and not partial. centre [px] of the region, angles: >= 16.
/// @throws InvalidArgument for another contact, fewer angles, or where the rays would leave the frame.
[[nodiscard]] ContactOutline trace_contact_outline(const FramePixels& pixels, const ContactFrame& contact,
                                                   double centre_x, double centre_y, Index angles,
                                                   double smallest_void = 16.0);

/// The edge in all frames of a recording that show it whole.
struct RecordedLine {
    std::vector<long> frames;                     ///< numbers of the frames, one a row of the line
    Array1D time;                                 ///< M times [s]
    Array2D radius;                               ///< r (M, N) at N equal angles [m]
    double place_error = 0;                       ///< standard deviation of one place by pixel noise [m]
    double pixel_size = 0;                        ///< [m]
    double centre_x = 0, centre_y = 0;            ///< [px] of the whole frame: the mean of the frames'
    std::vector<std::vector<ContactVoid>> voids;  ///< of every frame
    std::vector<std::string> left_out;            ///< "frame 12: reaches beyond the frame: 80 % of its edge is seen"
};

struct LineOptions {
    std::optional<Index> angles;  ///< default: a ray every 2 px of the largest edge
    double smallest_void = 16.0;  ///< [px²]
    parallel::Threads threads;
};

/// @throws InvalidArgument as trace_contact_outline.
/// @throws UndefinedDataError where no frame shows a whole contact.
[[nodiscard]] RecordedLine measure_contact_line(const FrameSource& source, const ContactRadii& radii,
                                                const LineOptions& options = {});

}  // namespace setae::imaging
