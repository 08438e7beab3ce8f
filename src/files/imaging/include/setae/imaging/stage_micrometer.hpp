// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/imaging/frames.hpp"

namespace setae::imaging {

/// Scale of a camera from one set of parallel lines at a known distance.
///
///   n p = c + (a·X)(1 + d r²/r_c²),  X in pixels from the centre of the picture, r = |X|, r_c at its corners
struct RulingFit {
    Estimate pixel_size;  ///< |a| at the centre of the picture, across the lines [m]; includes the ± of the pitch
    double angle = 0.0;   ///< of the normal to the lines against the x axis, which points right, y down [rad]
    Estimate distortion;  ///< d: stretching of the corners relative to the centre
    double probability = undefined;  ///< two-sided probability of such a d without distortion
    int lines = 0;
    int places = 0;             ///< number of line positions
    double rms_residual = 0.0;  ///< of the positions [m]
};

/// Scale of a camera from pictures of a stage micrometer.
struct CameraScale {
    std::optional<RulingFit> across_x, across_y;  ///< from vertical lines, from horizontal lines
    Estimate pixel_size;                          ///< along x if vertical lines were found, otherwise along y [m]
    std::optional<Estimate> aspect;  ///< height of a pixel over its width, if both kinds of lines were found
    long width = 0, height = 0;      ///< of the pictures [px]
    std::vector<std::string> notes;
};

/// Fits the lines of one or several pictures of a ruling or a grid, taken by one camera.
///
/// In each of up to 32 bands of rows (columns for horizontal lines) the positions of dark or bright lines are centroids
/// of the grey levels beyond the middle of the range of the band. The numbers of the lines follow from their distances,
/// the offsets of the bands from each other; c, a, d by least squares, without positions beyond four deviations.
/// Standard errors count lines, not positions: the error of a line is constant along it. If two pictures show the same
/// axis, the later one is used.
/// pitch: distance of neighbouring lines [m], ± of the ruling.
/// @throws InvalidArgument for no picture, pictures of different size, a pitch that is not > 0; UndefinedDataError for
/// a picture without five lines in either direction.
[[nodiscard]] CameraScale camera_scale(const std::vector<FramePixels>& pictures, const Estimate& pitch);

/// Scale of a camera from picture files, read by read_micrograph().
[[nodiscard]] CameraScale camera_scale(const std::vector<std::string>& files, const Estimate& pitch);

}  // namespace setae::imaging
