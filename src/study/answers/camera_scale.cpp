// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/camera_scale.hpp"

#include <nlohmann/json.hpp>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::answers {
namespace {

output::Json ruling_json(const imaging::RulingFit& fit) {
    output::Json json{{"lines", fit.lines}, {"places", fit.places}, {"probability", output::number(fit.probability)}};
    json["pixel_size"] = output::to_json(output::quantity("pixel_size", "s", fit.pixel_size, "m"));
    json["angle"] = output::to_json(output::quantity("angle", "", fit.angle, "rad"));
    json["distortion"] = output::to_json(output::quantity("distortion", "d", fit.distortion, "1"));
    json["rms_residual"] = output::to_json(output::quantity("rms_residual", "", fit.rms_residual, "m"));
    return json;
}

}  // namespace

imaging::CameraScale camera_scale(const std::vector<std::string>& pictures, const RulingRequest& ruling) {
    if (pictures.empty() || ruling.pitch.empty())
        throw InvalidArgument(
            "the scale of a camera takes pictures of a ruling and the distance of the lines; expected pictures and "
            "`pitch = 10 um`");
    return imaging::camera_scale(pictures, parse_uncertain_quantity(ruling.pitch, dimension::length));
}

output::Json to_json(const imaging::CameraScale& scale) {
    output::Json json{{"width", scale.width}, {"height", scale.height}, {"notes", scale.notes}};
    json["pixel_size"] = output::to_json(output::quantity("pixel_size", "s", scale.pixel_size, "m"));
    json["aspect"] =
        scale.aspect ? output::to_json(output::quantity("aspect", "h/w", *scale.aspect, "1")) : output::Json(nullptr);
    json["upright_lines"] = scale.across_x ? ruling_json(*scale.across_x) : output::Json(nullptr);
    json["lying_lines"] = scale.across_y ? ruling_json(*scale.across_y) : output::Json(nullptr);
    return json;
}

}  // namespace setae::answers
