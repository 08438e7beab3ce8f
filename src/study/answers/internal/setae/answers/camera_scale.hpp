// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/fields/option.hpp"
#include "setae/imaging/stage_micrometer.hpp"

namespace setae::answers {

/// The ruling that a camera looked at.
struct RulingRequest {
    std::string pitch;
};

/// Size of a pixel and distortion from pictures of a ruling.
/// @throws InvalidArgument where there is no picture or no pitch; as imaging::camera_scale().
[[nodiscard]] imaging::CameraScale camera_scale(const std::vector<std::string>& pictures, const RulingRequest& ruling);

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::imaging::RulingFit> {
    using T = imaging::RulingFit;
    static constexpr std::array rows{
        field<&T::lines>("lines", "number of lines of the ruling"),
        field<&T::places>("places", "number of positions that were found on lines"),
        field<&T::probability>("probability", "probability of a distortion at least as large by chance"),
        quantity<&T::pixel_size>("pixel_size", "s", "m", "size of a pixel across the lines"),
        quantity<&T::angle>("angle", "", "rad", "angle between the normal to the lines and the x axis"),
        quantity<&T::distortion>("distortion", "d", "1", "distortion of the camera lens at the corners"),
        quantity<&T::rms_residual>("rms_residual", "rms", "m", "root mean square residual of the positions")
            .as("rms_residual_of_lengths"),
    };
    static constexpr Description description{"ruling", "ruling in one direction", rows};
};
static_assert(setae::fields::complete<setae::imaging::RulingFit>);

template <>
struct setae::fields::Described<setae::imaging::CameraScale> {
    using T = imaging::CameraScale;
    static constexpr std::array rows{
        field<&T::width>("width", "width of the pictures in pixels"),
        field<&T::height>("height", "height of the pictures in pixels"),
        field<&T::notes>("notes", "notes"),
        quantity<&T::pixel_size>("pixel_size", "s", "m", "size of a pixel at the centre of the picture"),
        quantity<&T::aspect>("aspect", "h/w", "1",
                             "height of a pixel divided by its width; null where only one direction is known")
            .or_null(),
        field<&T::across_x>("upright_lines", "ruling across x; null without lines").or_null(),
        field<&T::across_y>("lying_lines", "ruling across y; null without lines").or_null(),
    };
    static constexpr Description description{"", "scale of a camera", rows};
};
static_assert(setae::fields::complete<setae::imaging::CameraScale>);

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
