// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "contour/region_argument.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/imaging/contact_radius.hpp"

namespace setae::cli::jkr_radius_command {
namespace {

constexpr const char* explanation =
    "a ray of the edge   I(d) = level + contrast/2 erf((d - place)/(sqrt(2) w)), pixels of one sector, d along the ellipse's normal\n"
    "a                   sqrt(semi_major semi_minor) + w^2/(2a): a blurred convex edge lies inside the true one; circle where partial\n"
    "standard error      scatter of places about the ellipse, with the correlation of neighbouring rays; the pixel size is exact\n"
    "confidence          agreeing_rays min(1, 2 visible_share) min(1, z/5), z: contrast of the median ray over its deviation\n"
    "no contact          a = 0: nothing stands out of noise and illumination\n"
    "not found           a undefined: something is there, but no disc whose rays agree\n"
    "time                (number - first number)/frame rate; numbers of files' names, else 1, 2, 3 ...\n";

struct Arguments {
    Common common;
    std::vector<std::string> frames;
    std::string pixel, region, polarity = "automatic", reason, output, overlay;
    std::optional<double> micrometres_a_pixel, frame_rate;
    std::optional<long> first, last;
    std::vector<long> exclude, overlay_frames;
    double smallest_radius = imaging::ContactFrameOptions{}.smallest_radius,
           least_confidence = imaging::ContactFrameOptions{}.least_confidence;
    bool fringes = false, ignore_stated_pixel_size = false;
};

imaging::FrameOptions frame_options(const Arguments& a) {
    imaging::FrameOptions options;
    if (a.micrometres_a_pixel && !a.pixel.empty())
        throw InvalidArgument("--um-per-px and --pixel say the same; give one");
    if (a.micrometres_a_pixel) options.pixel_size = 1e-6 * *a.micrometres_a_pixel;
    if (!a.pixel.empty()) options.pixel_size = parse_quantity(a.pixel, dimension::length);
    options.frame_rate = a.frame_rate;
    options.ignore_stated_pixel_size = a.ignore_stated_pixel_size;
    if (!a.region.empty()) options.region = parse_region("--region", a.region);
    options.first = a.first;
    options.last = a.last;
    return options;
}

imaging::RadiusOptions radius_options(const Arguments& a) {
    imaging::RadiusOptions options;
    options.frame.polarity = a.polarity == "dark"     ? imaging::Polarity::dark
                             : a.polarity == "bright" ? imaging::Polarity::bright
                                                      : imaging::Polarity::automatic;
    options.frame.fringes = a.fringes;
    options.frame.smallest_radius = a.smallest_radius;
    options.frame.least_confidence = a.least_confidence;
    options.threads = a.common.workers();
    if (!a.exclude.empty() && a.reason.empty())
        throw InvalidArgument("--exclude without --reason; say why these frames are left out, such as --reason glare");
    for (const long number : a.exclude) options.excluded.push_back({number, a.reason});
    return options;
}

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

output::Json as_json(const imaging::ContactRadii& radii) {
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

/// Frames without a radius, and what the whole gave, for the user.
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

ExitCode run(const Arguments& arguments) {
    if (!arguments.overlay_frames.empty() && arguments.overlay.empty())
        throw InvalidArgument("--overlay-frames without --overlay, the folder the pictures go to");
    const auto options = radius_options(arguments);
    const imaging::FrameSource source(arguments.frames, frame_options(arguments));
    const auto radii = imaging::measure_contact_radii(source, options);
    if (!arguments.output.empty()) bytes::write_whole_file(arguments.output, imaging::as_csv(radii));
    if (!arguments.overlay.empty()) write_overlays(arguments, source, radii);
    if (arguments.common.json) print_json(as_json(radii));
    else if (arguments.output.empty()) print(imaging::as_csv(radii));
    tell(radii);
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
    options.add("--um-per-px", arguments->micrometres_a_pixel, "size of a pixel in micrometres, such as 1.82");
    options.add("--pixel", arguments->pixel, "the same with its unit, such as \"1.82 um\"")
        .quantity(positive(dimension::length));
    options.flag("--ignore-stated-pixel-size", arguments->ignore_stated_pixel_size,
                 "take --pixel even where a file contradicts it");
    options.add("--fps", arguments->frame_rate, "frames a second");
    options.add("--first", arguments->first, "number of the first frame looked at");
    options.add("--last", arguments->last, "number of the last one");
    options.add("--region", arguments->region, "x,y,width,height: the part of the frames looked at, in pixels");
    options.add("--polarity", arguments->polarity, "whether the contact is dark or bright")
        .one_of({"automatic", "dark", "bright"});
    options.flag("--fringes", arguments->fringes, "rings around the contact: its edge is the innermost one");
    options.add("--smallest-radius", arguments->smallest_radius, "smaller contacts count as none [px]");
    options.add("--least-confidence", arguments->least_confidence, "of a contact that is reported, 0 to 1");
    options.add("--exclude", arguments->exclude, "numbers of frames left out, such as 12,17").separated_by(',');
    options.add("--reason", arguments->reason, "why they are left out");
    options.add("-o,--output", arguments->output, "write OUT.csv");
    options.add("--overlay", arguments->overlay, "folder for pictures of the frames with the edge drawn");
    options.add("--overlay-frames", arguments->overlay_frames, "numbers of frames drawn; default all")
        .separated_by(',');
    options.example("setae jkr radius recording.avi --pixel \"1.82 um\" --fps 10 -o radius.csv",
                    "contact radius in every frame");
    options.example("setae jkr radius stack.tif --um-per-px 1.82 --overlay edges",
                    "with pictures that show the edge found");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::jkr_radius_command
