// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"

namespace setae::imaging {

/// The outline of a lens in a picture from the side, against the light.
struct LensOutline {
    Array1D x, z;             ///< [m] from the lower left corner of the picture: x to the right, z upwards
    double pixel_size = 0.0;  ///< [m]
    double edge_width = 0.0;  ///< standard deviation of the blur across the edge [m]
    std::vector<Alert> alerts;
};

/// The longest edge of a picture, to fractions of a pixel, not smoothed: trace_contour(). pixel_size [m]: replaces the
/// size stated by the file.
/// @throws FileError; FormatError for a file that is no picture; UndefinedDataError if no pixel size is known or no
/// edge is found.
[[nodiscard]] LensOutline lens_outline(const std::string& picture, std::optional<double> pixel_size = std::nullopt);

/// Whether a file is a picture that lens_outline() reads, by its first bytes.
[[nodiscard]] bool is_picture(const std::string& path);

}  // namespace setae::imaging
