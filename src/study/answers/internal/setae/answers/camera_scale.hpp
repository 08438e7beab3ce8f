// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/imaging/stage_micrometer.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {

/// Size of a pixel and distortion from pictures of a ruling whose lines are `pitch` apart, "10 um" or "10 ± 0.02 um".
/// @throws InvalidArgument where there is no picture or no pitch; as imaging::camera_scale().
[[nodiscard]] imaging::CameraScale camera_scale(const std::vector<std::string>& pictures, const std::string& pitch);

/// "width", "height", "notes", "pixel_size", "aspect", "upright_lines" and "lying_lines", as `setae jkr camera`.
[[nodiscard]] output::Json to_json(const imaging::CameraScale& scale);

}  // namespace setae::answers
