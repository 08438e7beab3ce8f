// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr/recording_options.hpp"

#include <fmt/format.h>

#include "program/messages.hpp"

namespace setae::cli {

void report_frames(const imaging::ContactRadii& radii) {
    constexpr int max_lines = 20;
    int lines = 0;
    for (const auto& note : radii.notes) print_message(note);
    for (const auto& f : radii.frames) {
        const auto state = f.contact.state;
        if (state != imaging::FrameState::bad_frame && state != imaging::FrameState::not_found) continue;
        if (++lines <= max_lines)
            print_message(fmt::format("frame {}: {}: {}", f.number, to_string(state), f.contact.reason));
    }
    if (lines > max_lines)
        print_message(
            fmt::format("{} more frames without a radius; the table contains the reasons", lines - max_lines));
    const auto& s = radii.summary;
    print_message(fmt::format(
        "{} frames: {} measured ({} partial), {} without contact, {} not found, {} bad, {} excluded, {} missing",
        s.frames, s.measured, s.partial, s.no_contact, s.not_found, s.bad, s.excluded, s.missing));
}

}  // namespace setae::cli
