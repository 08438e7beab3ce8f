// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr/recording_options.hpp"

#include <fmt/format.h>

#include "program/messages.hpp"
#include "setae/core/units.hpp"

namespace setae::cli {

void add_recording_options(Options& options, answers::RadiusRequest& request) {
    options.add("--um-per-px", request.micrometres_a_pixel, "size of a pixel in micrometres, such as 1.82");
    options.add("--pixel", request.pixel, "the same with its unit, such as \"1.82 um\"")
        .quantity(positive(dimension::length));
    options.flag("--ignore-stated-pixel-size", request.ignore_stated_pixel_size,
                 "take --pixel even where a file contradicts it");
    options.add("--fps", request.frame_rate, "frames a second");
    options.add("--first", request.first, "number of the first frame looked at");
    options.add("--last", request.last, "number of the last one");
    options.add("--region", request.region, "x,y,width,height: the part of the frames looked at, in pixels");
    options.add("--polarity", request.polarity, "whether the contact is dark or bright")
        .one_of({"automatic", "dark", "bright"});
    options.flag("--fringes", request.fringes, "rings around the contact: its edge is the innermost one");
    options.add("--smallest-radius", request.smallest_radius, "smaller contacts count as none [px]");
    options.add("--least-confidence", request.least_confidence, "of a contact that is reported, 0 to 1");
    options.add("--exclude", request.exclude, "numbers of frames left out, such as 12,17").separated_by(',');
    options.add("--reason", request.reason, "why they are left out");
}

void tell(const imaging::ContactRadii& radii) {
    constexpr int most_lines = 20;
    int lines = 0;
    for (const auto& note : radii.notes) complain(note);
    for (const auto& f : radii.frames) {
        const auto state = f.contact.state;
        if (state != imaging::FrameState::bad_frame && state != imaging::FrameState::not_found) continue;
        if (++lines <= most_lines)
            complain(fmt::format("frame {}: {}: {}", f.number, to_string(state), f.contact.reason));
    }
    if (lines > most_lines)
        complain(fmt::format("{} more frames without a radius; the table says why", lines - most_lines));
    const auto& s = radii.summary;
    complain(fmt::format(
        "{} frames: {} measured ({} partial), {} without contact, {} not found, {} bad, {} excluded, {} missing",
        s.frames, s.measured, s.partial, s.no_contact, s.not_found, s.bad, s.excluded, s.missing));
}

}  // namespace setae::cli
