// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "setae/fields/option.hpp"
#include "setae/imaging/stage_micrometer.hpp"
#include "setae/output/json.hpp"

namespace setae::answers {

/// The ruling that a camera looked at.
struct RulingRequest {
    std::string pitch;
};

/// Size of a pixel and distortion from pictures of a ruling.
/// @throws InvalidArgument where there is no picture or no pitch; as imaging::camera_scale().
[[nodiscard]] imaging::CameraScale camera_scale(const std::vector<std::string>& pictures, const RulingRequest& ruling);

/// "width", "height", "notes", "pixel_size", "aspect", "upright_lines" and "lying_lines", as `setae jkr camera`.
[[nodiscard]] output::Json to_json(const imaging::CameraScale& scale);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::RulingRequest> {
    using R = answers::RulingRequest;
    static constexpr std::array options{
        option<&R::pitch>("pitch", "distance of neighbouring lines of the ruling")
            .of(positive(dimension::length))
            .such_as("10 ± 0.02 um")
            .required(),
    };
};
