// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/contour.hpp"

#include <fmt/format.h>

#include "setae/answers/picture_region.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/imaging/calibration_file.hpp"
#include "setae/output/contour_file.hpp"

namespace setae::answers {

/// "0.05 nm" or "0.05 nm x 0.1 nm".
imaging::PixelSize pixel_size_of(const std::string& text) {
    const auto cross = text.find(" x ");
    const double x = parse_quantity(text.substr(0, cross), dimension::length);
    return {x, cross == std::string::npos ? x : parse_quantity(text.substr(cross + 3), dimension::length)};
}

study::ContourOptions ContourRequest::options() const {
    study::ContourOptions options;
    options.micrograph.image = image;
    options.trace.vacuum = output::vacuum_from_name(vacuum);
    options.trace.smoothing_length = smoothing;
    options.trace.denoise = denoise;
    options.trace.min_length = min_length;
    for (const auto& text : hidden) options.trace.hidden.push_back(parse_region("`hide`", text));
    options.hide_annotations = !whole_picture;
    options.shape = output::shape_from_name(shape);
    if (!foil_thickness.empty()) options.foil_thickness = parse_quantity(foil_thickness, dimension::length);
    if (!pixel.empty()) options.calibration.pixel_size = pixel_size_of(pixel);
    if (!scale_bar.empty()) options.calibration.scale_bar_length = parse_quantity(scale_bar, dimension::length);
    options.calibration.ignore_stated_pixel_size = ignore_stated;
    if (!calibration.empty()) {
        if (!pixel.empty() || !scale_bar.empty())
            throw InvalidArgument("`calibration` with `pixel` or `scale_bar`; give one");
        options.shared_calibration = imaging::read_calibration(calibration).calibration;
    }
    return options;
}

void RepeatedTrace::require_picture(const study::TracedPicture& picture, const std::string& stored) const {
    if (!digest || *digest == picture.digest) return;
    throw InvalidArgument(fmt::format(
        "{}: {} is the trace of another picture (SHA-256 {}…, this one has {}…); keep only its anchors to use them here",
        picture.micrograph.file, stored, digest->substr(0, 8), picture.digest.substr(0, 8)));
}

RepeatedTrace ContourRequest::with_anchors(const std::string& file) const {
    RepeatedTrace repeated{.options = options()};
    if (file.empty()) return repeated;
    const auto stored = output::read_trace(file);
    if (!stored.options) {
        repeated.options.trace.anchors = stored.anchors;
        return repeated;
    }
    const bool is_plain = pixel.empty() && scale_bar.empty() && calibration.empty() && hidden.empty() && !smoothing &&
                          !min_length && denoise == 0 && vacuum == "automatic" && shape == "envelope" &&
                          foil_thickness.empty() && !whole_picture && image.empty();
    if (!is_plain)
        throw InvalidArgument(
            file +
            " is a whole trace with its own options; give no other options, or a file with only anchors: {\"anchors\": [[x, y], …]}");
    return {.options = *stored.options, .is_whole = true, .digest = stored.digest};
}

}  // namespace setae::answers
