// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/imaging/frames.hpp"

namespace setae::imaging {

/// What one set of parallel lines at a known distance says of a camera.
///
///   n p = c + (a·X)(1 + d r²/r_c²),  X in pixels from the picture's centre, r = |X|, r_c of its corners
struct RulingFit {
    Estimate pixel_size;  ///< |a| at the picture's centre, across the lines [m]; with the pitch's own ±
    double angle = 0.0;   ///< of the normal to the lines against the x axis, which points right, y down [rad]
    Estimate distortion;  ///< d: by how much the corners are stretched against the centre
    double probability = undefined;  ///< two-sided, of such a d where the optics are straight
    int lines = 0;
    int places = 0;             ///< where a line was found
    double rms_residual = 0.0;  ///< of the places [m]
};

/// Scale of a camera from pictures of a stage micrometer.
struct CameraScale {
    std::optional<RulingFit> across_x, across_y;  ///< of lines that stand upright, of lines that lie
    Estimate pixel_size;                          ///< along x where upright lines were seen, else along y [m]
    std::optional<Estimate> aspect;  ///< height of a pixel over its width, where both kinds of lines were seen
    long width = 0, height = 0;      ///< of the pictures [px]
    std::vector<std::string> notes;
};

/// Fits the lines of one or several pictures of a ruling or a grid, taken by one camera.
///
/// In each of up to 32 bands of rows (columns for lines that lie) the dark or bright lines are centroids of what lies
/// beyond the middle of the band's grey levels. Their numbers follow from their distances, the bands' offsets from
/// each other; c, a, d by least squares, places beyond four deviations left out. Standard errors count lines, not
/// places: a line's own error is the same all along it. Of an axis seen in two pictures the later counts.
/// pitch: distance of neighbouring lines [m], ± of the ruling itself.
/// @throws InvalidArgument for no picture, pictures of different size, a pitch that is not > 0; UndefinedDataError for
/// a picture without five lines either way.
[[nodiscard]] CameraScale camera_scale(const std::vector<FramePixels>& pictures, const Estimate& pitch);

/// The same of picture files, read by read_micrograph().
[[nodiscard]] CameraScale camera_scale(const std::vector<std::string>& files, const Estimate& pitch);

}  // namespace setae::imaging
