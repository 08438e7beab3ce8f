// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "setae/fields/option.hpp"

namespace setae::answers {

/// The pictures of a camera that looks at a contact.
struct CameraPictures {
    std::string pixel;
    std::optional<double> frame_rate;  ///< [1/s]
    bool fringes = false;
};

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::CameraPictures> {
    using R = answers::CameraPictures;
    static constexpr std::array options{
        option<&R::pixel>("pixel", "size of a pixel in the camera's pictures")
            .of(positive(dimension::length))
            .such_as("1.82 um"),
        option<&R::frame_rate>("fps", "frames per second of the camera")
            .within(domain::positive)
            .in_python("frame_rate"),
        option<&R::fringes>("fringes",
                            "pictures show Newton's rings around the contact; the innermost ring is the edge"),
    };
};
