// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/contact_radii.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "setae/answers/picture_region.hpp"
#include "setae/answers/words.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::answers {

imaging::FrameOptions RadiusRequest::frame_options() const {
    imaging::FrameOptions options;
    if (micrometres_per_pixel && !pixel.empty())
        throw InvalidArgument("`um_per_px` and `pixel` both state the scale; expected one of them");
    if (micrometres_per_pixel) options.pixel_size = 1e-6 * *micrometres_per_pixel;
    if (!pixel.empty()) options.pixel_size = parse_quantity(pixel, dimension::length);
    options.frame_rate = frame_rate;
    options.ignore_stated_pixel_size = ignore_stated_pixel_size;
    if (!region.empty()) options.region = parse_region("`region`", region);
    options.first = first;
    options.last = last;
    return options;
}

imaging::RadiusOptions RadiusRequest::radius_options(parallel::Threads threads) const {
    imaging::RadiusOptions options;
    require_word("polarity", polarity, fields::Asked<RadiusRequest>::polarities);
    options.frame.polarity = polarity == "dark"     ? imaging::Polarity::dark
                             : polarity == "bright" ? imaging::Polarity::bright
                                                    : imaging::Polarity::automatic;
    options.frame.fringes = fringes;
    options.frame.smallest_radius = smallest_radius;
    options.frame.min_confidence = min_confidence;
    options.threads = threads;
    if (!exclude.empty() && reason.empty())
        throw InvalidArgument(
            "`exclude` without `reason`; say why these frames are left out, such as `reason = glare`");
    for (const long number : exclude) options.excluded.push_back({number, reason});
    return options;
}

output::Json to_json(const imaging::ContactRadii& radii) {
    const auto quantity = [](const char* name, const char* symbol, double value, double standard_error,
                             const char* unit) {
        output::Json json{{"quantity", name}, {"symbol", symbol}, {"value", value}, {"unit", unit}};
        json["standard_error"] = standard_error;
        return json;
    };
    const auto& s = radii.summary;
    output::Json json;
    json["pixel_size"] = {{"value", radii.pixel_size}, {"unit", "m"}};
    json["frame_rate"] = {{"value", radii.frame_rate}, {"unit", "1/s"}};
    json["polarity"] = to_string(radii.polarity);
    json["summary"] = {{"frames", s.frames},       {"measured", s.measured}, {"no_contact", s.no_contact},
                       {"not_found", s.not_found}, {"bad", s.bad},           {"excluded", s.excluded},
                       {"partial", s.partial},     {"missing", s.missing}};
    json["notes"] = radii.notes;
    json["frames"] = output::Json::array();
    for (const auto& f : radii.frames) {
        const auto& c = f.contact;
        output::Json frame{{"frame", f.number},
                           {"name", f.name},
                           {"time", f.time},
                           {"state", to_string(c.state)},
                           {"remark", c.reason}};
        frame["contact_radius"] = quantity("contact radius", "a", f.radius, f.standard_error, "m");
        if (c.state == imaging::FrameState::measured) {
            const double pixel = radii.pixel_size;
            frame["semi_major"] = quantity("semi-major axis", "a1", pixel * c.ellipse.semi_major,
                                           pixel * c.ellipse.semi_major_standard_error, "m");
            frame["semi_minor"] = quantity("semi-minor axis", "a2", pixel * c.ellipse.semi_minor,
                                           pixel * c.ellipse.semi_minor_standard_error, "m");
            frame["angle"] = {{"value", c.ellipse.angle}, {"unit", "rad"}};
            frame["roundness"] = quantity("roundness", "a2/a1", c.roundness, c.roundness_standard_error, "1");
            frame["centre"] = {{"x", pixel * c.ellipse.centre_x},
                               {"y", pixel * c.ellipse.centre_y},
                               {"standard_error", pixel * c.ellipse.centre_standard_error},
                               {"unit", "m"}};
            frame["confidence"] = c.confidence;
            frame["agreeing_rays"] = c.agreeing_rays;
            frame["visible_share"] = c.visible_share;
            frame["contrast_to_noise"] = c.contrast_to_noise;
            frame["edge_width"] = {{"value", pixel * c.edge_width}, {"unit", "m"}};
            frame["polarity"] = to_string(c.polarity);
            frame["partial"] = c.partial;
        }
        json["frames"].push_back(std::move(frame));
    }
    return json;
}

}  // namespace setae::answers
