// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/core/estimate.hpp"
#include "setae/loops/loop.hpp"

namespace setae::loops {

/// Contact radii with the camera's own clock.
struct CameraRecord {
    Array1D time;            ///< [s], increasing
    Array1D contact_radius;  ///< a [m]; 0 out of contact, NaN for a bad frame
};

struct ClockOptions {
    /// search range [s]; else wherever half of the frames overlap
    std::optional<double> smallest_offset, largest_offset;
    double min_overlap = 0.5;  ///< share of the frames that must be within the force record
};

/// Offset of the camera's clock relative to that of the force.
struct ClockAlignment {
    Estimate offset;         ///< [s] to add to the camera's times
    double explained = 0.0;  ///< share of the force's variance at the frames that the radii explain, at the best offset
    double runner_up = 0.0;  ///< the same share at the best offset at least five frames away, in the first search
    std::optional<Estimate> by_onset;  ///< from the first frame in contact and the jump-in only; ± half a frame
    double frame_interval = 0.0;       ///< median [s]
    Index frames = 0;                  ///< number of frames used
    std::string method;                ///< "F, δ, a" or "F, a"
    std::string doubt;                 ///< reason to doubt the offset; empty without one
};

/// Estimates the offset between the clocks by correlating the size of the contact with force and displacement.
///
/// For any state of an elastic sphere's contact, independent of its work of adhesion and its history,
///
///   F = 2 E* a (δ − a²/3R)      so that   F = c0 + c1 a + c2 a δ + c3 a³
///
/// with constants that include E*, R and the zeros of force and displacement. The offset is the one at which the frames
/// satisfy this best by least squares, force and displacement averaged over half a frame about the frames' times; it is
/// searched at half a frame (for at most 2000 frames), then refined. Contact onsets and separations have the largest
/// weight: F and a jump together there. Without displacement the form is F = c0 + c1 a + c2 a^(3/2) + c3 a³ (JKR under
/// load) for the frames before the largest radius and out of contact, because of adhesion hysteresis between; where the
/// record has a jump-in, the offset is searched about it. Radii below three standard deviations of their noise are 0.
/// The standard error comes from the profile of the sum of squares, widened for correlated residuals and for jumps
/// within a frame.
/// @throws InvalidArgument for series of different length, time that is missing or does not increase, an empty search.
/// @throws UndefinedDataError for fewer than 20 usable frames, radii that never change, clocks that cannot overlap.
/// Source of the relation: Johnson, Kendall, Roberts 1971; Maugis 1992.
[[nodiscard]] ClockAlignment align_clocks(const Loop& force, const CameraRecord& camera,
                                          const ClockOptions& options = {});

}  // namespace setae::loops
