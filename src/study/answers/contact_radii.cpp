// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/contact_radii.hpp"

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

}  // namespace setae::answers
