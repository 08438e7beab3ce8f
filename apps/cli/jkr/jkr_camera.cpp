// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/camera_scale.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/output/field_json.hpp"

namespace setae::cli::jkr_camera_command {
namespace {

constexpr const char* explanation =
    "The command determines the pixel size and the distortion of a camera from pictures of a ruling.\n"
    "\n"
    "lines       n p = c + (a.X)(1 + d r^2/r_c^2)\n"
    "            X: pixels from the centre of the picture; r_c: its corners; p: distance of the lines of the ruling\n"
    "pixel size  |a| at the centre\n"
    "            Lines in both directions give width and height of a pixel: (a_x/w)^2 + (a_y/h)^2 = 1 for each.\n"
    "distortion  d: relative stretch of the corners; a radius of r pixels about the centre has the error d r^2/r_c^2\n"
    "errors      from the number of lines, not of points along lines; the error of the ruling is that given by --pitch\n"
    "\n"
    "The measurement is described in docs/guides/calibration.md.\n";

struct Arguments {
    Common common;
    std::vector<std::string> files;
    answers::RulingRequest ruling;
};

std::string as_text(const imaging::CameraScale& scale) {
    std::string text = fmt::format("pixel size {}\n", format_uncertain(scale.pixel_size, "m"));
    const auto add = [&](const char* which, const std::optional<imaging::RulingFit>& fit) {
        if (!fit) return;
        text += fmt::format(
            "  {} lines: {} per pixel, {} lines at {} places, rms {}, turned by {:.2f}°; corners stretched by "
            "{} % (p = {})\n",
            which, format_uncertain(fit->pixel_size, "m"), fit->lines, fit->places,
            format_value(fit->rms_residual, "m", 2), fit->angle * 180.0 / pi, uncertain_number(fit->distortion, 0.01),
            probability_text(fit->probability));
    };
    add("upright", scale.across_x);
    add("lying", scale.across_y);
    if (scale.aspect) text += fmt::format("  height of a pixel over its width {}\n", uncertain_number(*scale.aspect));
    for (const auto& note : scale.notes) text += "  " + note + "\n";
    return text;
}

ExitCode run(const Arguments& arguments) {
    const auto scale = answers::camera_scale(arguments.files, arguments.ruling);
    if (arguments.common.json) print_json(output::described(scale));
    else print(as_text(scale));
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("files", arguments->files, "pictures of a ruling or a grid, all by one camera at one magnification")
        .of_inputs();
    options.ask(arguments->ruling);
    options.example("setae jkr camera ruling.tif --pitch \"10 um\"",
                    "pixel size from a ruling with lines at a distance of 10 um");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::jkr_camera_command
