// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jkr/recording_options.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/radius_fields.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/output/field_json.hpp"

namespace setae::cli::jkr_radius_command {
namespace {

constexpr const char* explanation =
    "The command measures the contact radius in every frame of a recording.\n"
    "\n"
    "ray of the edge  I(d) = level + contrast/2 erf((d - place)/(sqrt(2) w)), for the pixels of one sector\n"
    "                 d is the distance along the normal of the ellipse.\n"
    "a                sqrt(semi_major semi_minor) + w^2/(2 a); a circle where the contact is partly visible\n"
    "                 The second term corrects the blur, which moves a convex edge inwards.\n"
    "standard error   scatter of places about the ellipse, with the correlation of neighbouring rays\n"
    "                 The error of the pixel size is not included.\n"
    "confidence       agreeing_rays min(1, 2 visible_share) min(1, z/5); z: contrast of the median ray over its deviation\n"
    "no contact       a = 0: no disc above noise and illumination\n"
    "not found        a undefined: a structure is visible, but no disc on whose edge the rays agree\n"
    "time             (number - first number)/frame rate; numbers from the names of files, else 1, 2, 3 ...\n";

struct Arguments : answers::RadiusRequest {
    Common common;
    std::vector<std::string> frames;
    std::string output, overlay;
    std::vector<long> overlay_frames;
};

void write_overlays(const Arguments& a, const imaging::FrameSource& source, const imaging::ContactRadii& radii) {
    std::error_code error;
    std::filesystem::create_directories(a.overlay, error);
    if (error) throw FileError(a.overlay + ": cannot make the folder: " + error.message());
    for (const long number : a.overlay_frames)
        if (std::none_of(radii.frames.begin(), radii.frames.end(), [&](const auto& f) { return f.number == number; }))
            throw InvalidArgument(fmt::format("--overlay-frames: no frame {}", number));
    parallel::for_each_index(source.size(), a.common.workers(), [&](std::size_t i) {
        const auto& frame = radii.frames[i];
        if (!a.overlay_frames.empty() &&
            std::find(a.overlay_frames.begin(), a.overlay_frames.end(), frame.number) == a.overlay_frames.end())
            return;
        imaging::write_overlay(
            (std::filesystem::path(a.overlay) / fmt::format("frame_{:06}.png", frame.number)).string(), source, i,
            frame);
    });
}

ExitCode run(const Arguments& arguments) {
    if (!arguments.overlay_frames.empty() && arguments.overlay.empty())
        throw InvalidArgument("--overlay-frames without --overlay; expected --overlay FOLDER for the pictures");
    const auto options = arguments.radius_options(arguments.common.workers());
    const imaging::FrameSource source(arguments.frames, arguments.frame_options());
    const auto radii = imaging::measure_contact_radii(source, options);
    if (!arguments.output.empty()) bytes::write_whole_file(arguments.output, imaging::as_csv(radii));
    if (!arguments.overlay.empty()) write_overlays(arguments, source, radii);
    if (arguments.common.json) print_json(output::described(radii));
    else if (arguments.output.empty()) print(imaging::as_csv(radii));
    report_frames(radii);
    const auto& s = radii.summary;
    if (s.measured + s.no_contact == 0) return ExitCode::nothing_done;
    return s.not_found + s.bad > 0 ? ExitCode::some_failed : ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options
        .add("frames", arguments->frames,
             "a TIFF stack, an AVI, a folder of pictures, or pictures (PNG, JPEG, TIFF, BMP)")
        .of_inputs();
    options.ask<answers::CameraPictures>(*arguments);
    options.ask<answers::RadiusRequest>(*arguments);
    options.output("-o,--output", arguments->output, "write OUT.csv");
    options.output("--overlay", arguments->overlay, "folder for pictures of the frames with the edge drawn in");
    options.output("--overlay-frames", arguments->overlay_frames, "numbers of frames that are drawn; default: all")
        .separated_by(',');
    options.example("setae jkr radius recording.avi --pixel \"1.82 um\" --fps 10 -o radius.csv",
                    "contact radius in every frame");
    options.example("setae jkr radius stack.tif --um-per-px 1.82 --overlay edges",
                    "contact radius, and pictures with the edge drawn in");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::jkr_radius_command
