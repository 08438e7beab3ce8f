// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/camera_scale.hpp"

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::answers {

imaging::CameraScale camera_scale(const std::vector<std::string>& pictures, const RulingRequest& ruling) {
    if (pictures.empty() || ruling.pitch.empty())
        throw InvalidArgument(
            "the scale of a camera takes pictures of a ruling and the distance of the lines; expected pictures and "
            "`pitch = 10 um`");
    return imaging::camera_scale(pictures, parse_uncertain_quantity(ruling.pitch, dimension::length));
}

}  // namespace setae::answers
