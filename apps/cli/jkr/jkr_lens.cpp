// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/lens.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/output/field_json.hpp"

namespace setae::cli::jkr_lens_command {
namespace {

constexpr const char* explanation =
    "The command fits the radius of curvature of a lens to a profile or to a picture of its side.\n"
    "\n"
    "circle    least sum of squared distances of the points from the circle; three points: the circle through them\n"
    "error     of R, from the scatter about the circle, with the correlation of neighbouring points\n"
    "conic     c r^2 - 2 s + (1 + k) c s^2 = 0; s: height below the apex; c = 1/R at the apex\n"
    "          k = 0: sphere; k = -1: paraboloid\n"
    "range     --from and --to exclude the rim, where a lens is no sphere\n"
    "          R and its residual show the range in which the lens is a sphere.\n"
    "pictures  side of the lens against the light: the longest edge, to fractions of a pixel; x from the left, z upwards\n"
    "\n"
    "The measurement is described in docs/guides/calibration.md.\n";

struct Arguments {
    Common common;
    std::vector<std::string> files;
    answers::LensRequest request;
};

std::string as_text(const answers::Lens& lens) {
    const Estimate& radius = lens.circle.radius;
    std::string text = fmt::format("{}: R = {}", lens.file, format_uncertain(radius, "m"));
    if (const auto interval = interval_of(radius))
        text += fmt::format(" (95 %: {} to {})", format_value(interval->lower, "m", 5),
                            format_value(interval->upper, "m", 5));
    text +=
        fmt::format(", {} points from {} to {}, rms {} about the circle\n", lens.points, format_value(lens.first, "m"),
                    format_value(lens.last, "m"), format_value(lens.circle.rms_residual, "m"));
    if (const auto& conic = lens.conic; conic && conic->conic_constant.uncertain())
        text += fmt::format(
            "  apex: R = {}, conic constant {} (0 is a sphere; p = {}); {} from the sphere of the apex at the "
            "farthest point\n",
            format_uncertain(conic->radius, "m"), uncertain_number(conic->conic_constant),
            probability_text(conic->probability), format_value(conic->departure, "m", 3));
    for (const auto& alert : lens.alerts) text += fmt::format("  {}: {}\n", alert.code, alert.message);
    return text;
}

ExitCode run(const Arguments& arguments) {
    if (arguments.files.empty())
        throw InvalidArgument(
            "no file; expected a profile, such as setae jkr lens PROFILE.csv, or a picture of the side of a lens");
    output::Json lenses = output::Json::array();
    const ExitCode code = for_each_item(arguments.files, [&](const std::string& file) {
        const auto lens = answers::lens_of(file, arguments.request);
        if (arguments.common.json) lenses.push_back(output::described(lens));
        else print(as_text(lens));
    });
    if (arguments.common.json) print_json(arguments.files.size() == 1 && lenses.size() == 1 ? lenses.front() : lenses);
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options
        .add("files", arguments->files,
             "tables of two lengths with units, traces of a profilometer, or pictures of the side of the lens")
        .of_inputs();
    options.ask(arguments->request);
    options.example("setae jkr lens profile.csv", "radius and asphericity from a profile");
    options.example("setae jkr lens side.png --pixel \"2.05 um\"", "radius from a picture of the side of a lens");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::jkr_lens_command
