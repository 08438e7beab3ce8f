// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "setae/core/estimate.hpp"
#include "setae/loops/loop.hpp"

namespace setae::loops {

/// Contact radii on the camera's own clock.
struct CameraRecord {
    Array1D time;            ///< [s], forwards
    Array1D contact_radius;  ///< a [m]; 0 out of contact, NaN where a frame is bad
};

struct ClockOptions {
    std::optional<double> smallest_offset, largest_offset;  ///< searched [s]; else wherever half of the frames overlap
    double min_overlap = 0.5;  ///< share of the frames that must lie within the force record
};

/// How far the camera's clock is behind the force's.
struct ClockAlignment {
    Estimate offset;         ///< [s] to add to the camera's times
    double explained = 0.0;  ///< share of the force's variance at the frames that the radii explain, at the best offset
    double runner_up = 0.0;  ///< the same at the best offset at least five frames away, of the first search
    std::optional<Estimate> by_onset;  ///< from the first frame in contact against the jump-in alone; ± half a frame
    double frame_interval = 0.0;       ///< median [s]
    Index frames = 0;                  ///< used
    std::string method;                ///< "F, δ, a" or "F, a"
    std::string doubt;                 ///< why the offset should not be trusted; empty where nothing speaks against it
};

/// Estimates the offset between the clocks by correlating the size of the contact with force and displacement.
///
/// At any state of an elastic sphere's contact, whatever its work of adhesion and its history,
///
///   F = 2 E* a (δ − a²/3R)      so that   F = c0 + c1 a + c2 a δ + c3 a³
///
/// with constants that take in E*, R and the zeros of force and displacement. The offset is the one at which the frames
/// satisfy this best by least squares, force and displacement averaged over half a frame about the frames' times; it is
/// searched at half a frame (of 2000 frames at most), then refined. Contact onsets and partings weigh most: F and a
/// jump there together. Without displacement the form is F = c0 + c1 a + c2 a^(3/2) + c3 a³ (JKR under load) for the
/// frames before the largest radius and out of contact: hysteresis of adhesion spoils it in between; where the record
/// has a jump-in, it is searched about that. Radii below three standard deviations of their noise are 0. The standard
/// error is read from the profile of the sum of squares, widened for residuals that follow their neighbours and for
/// jumps that hide within a frame.
/// @throws InvalidArgument for series of different length, time that is missing or does not run forwards, an empty
/// search.
/// @throws UndefinedDataError for fewer than 20 usable frames, radii that never change, clocks that cannot overlap.
/// Source of the relation: Johnson, Kendall, Roberts 1971; Maugis 1992.
[[nodiscard]] ClockAlignment align_clocks(const Loop& force, const CameraRecord& camera,
                                          const ClockOptions& options = {});

}  // namespace setae::loops
