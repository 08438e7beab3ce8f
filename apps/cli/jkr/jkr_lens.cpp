// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/imaging/lens_outline.hpp"
#include "setae/loops/lens_radius.hpp"
#include "setae/output/json.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::cli::jkr_lens_command {
namespace {

constexpr const char* explanation =
    "circle      least sum of squared distances of the points from it, not of heights; three points: the circle through them\n"
    "error       of R, by the scatter about the circle, with the correlation of neighbouring points\n"
    "conic       c r^2 - 2 s + (1 + k) c s^2 = 0, s the height below the apex, c = 1/R there: k = 0 a sphere, -1 a paraboloid\n"
    "range       --from and --to leave out the rim, where a lens is no sphere: R and its residual tell how far it is one\n"
    "pictures    of the side, against the light: the longest edge, to fractions of a pixel; x from the left, z upwards\n"
    "docs/guides/jkr-laboratory.md\n";

struct Arguments {
    Common common;
    std::vector<std::string> files;
    std::string x, z, from, to, pixel;
};

/// The column of that name, else the given one of those in metres.
const Array1D& length_column(const Table& table, const std::string& file, const std::string& name, std::size_t place) {
    std::vector<const Column*> lengths;
    for (const auto& column : table.columns)
        if (column.unit == "m") lengths.push_back(&column);
    if (name.empty()) {
        if (lengths.size() > place) return lengths[place]->values;
        throw FormatError(file, {},
                          "a profile needs two columns of lengths with their units, such as \"x [mm]\" and "
                          "\"z [um]\"; name them with --x and --z");
    }
    const Column* column = table.find(name);
    if (column == nullptr || column->unit != "m")
        throw InvalidArgument(fmt::format("{}: no column '{}' of lengths", file, name));
    return column->values;
}

struct Lens {
    loops::Circle circle;
    std::optional<loops::Conic> conic;
    std::string no_conic;  ///< why
    std::vector<Alert> alerts;
    Index points = 0;
    double first = 0.0, last = 0.0;  ///< of the range along x [m]
};

/// Points of a lens's section, from a table or from a picture of its side.
imaging::LensOutline outline_of(const std::string& file, const Arguments& arguments) {
    if (imaging::is_picture(file))
        return imaging::lens_outline(file, arguments.pixel.empty()
                                               ? std::nullopt
                                               : std::optional(parse_quantity(arguments.pixel, dimension::length)));
    const Table table = tables::read_table(file);
    return {.x = length_column(table, file, arguments.x, 0), .z = length_column(table, file, arguments.z, 1)};
}

Lens lens_of(const std::string& file, const Arguments& arguments) {
    const auto outline = outline_of(file, arguments);
    const auto &x = outline.x, &z = outline.z;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const auto end = [](const std::string& text, double otherwise) {
        return text.empty() ? otherwise : parse_quantity(text, dimension::length);
    };
    const double from = end(arguments.from, -infinite), to = end(arguments.to, infinite);
    std::vector<Index> kept;
    for (Index i = 0; i < x.size(); ++i)
        if (x[i] >= from && x[i] <= to && std::isfinite(z[i])) kept.push_back(i);
    const Array1D along = x(kept), height = z(kept);
    Lens lens{.circle = kept.size() == 3 ? loops::circle_through(along, height) : loops::fit_circle(along, height),
              .alerts = outline.alerts,
              .points = along.size()};
    try {
        lens.conic = loops::fit_conic(along, height);
    } catch (const UndefinedDataError& error) {
        lens.no_conic = error.what();
    }
    lens.first = along.minCoeff();
    lens.last = along.maxCoeff();
    return lens;
}

output::Json as_json(const std::string& file, const Lens& lens) {
    output::Json json{{"file", file}, {"n", lens.points}};
    json["radius_of_curvature"] =
        output::to_json(output::quantity("radius_of_curvature", "R", lens.circle.radius, "m"));
    json["rms_residual"] = output::to_json(output::quantity("rms_residual", "", lens.circle.rms_residual, "m"));
    json["centre"] = {{"x", lens.circle.centre_x}, {"z", lens.circle.centre_y}, {"unit", "m"}};
    json["range"] = {{"from", lens.first}, {"to", lens.last}, {"unit", "m"}};
    if (const auto& conic = lens.conic) {
        json["conic"] = {{"apex", {{"x", conic->apex_x}, {"z", conic->apex_z}, {"unit", "m"}}},
                         {"probability_of_a_sphere", output::number(conic->probability)}};
        const auto add = [&](const char* name, const char* symbol, const Estimate& value, const char* unit) {
            json["conic"][name] = output::to_json(output::quantity(name, symbol, value, unit));
        };
        add("radius_of_curvature", "R", conic->radius, "m");
        add("conic_constant", "k", conic->conic_constant, "1");
        add("departure_from_the_apex_sphere", "", {.value = conic->departure}, "m");
        add("rms_residual", "", {.value = conic->rms_residual}, "m");
    } else {
        json["conic"] = nullptr;
        json["no_conic"] = lens.no_conic;
    }
    json["alerts"] = output::to_json(lens.alerts);
    return json;
}

std::string as_text(const std::string& file, const Lens& lens) {
    const Estimate& radius = lens.circle.radius;
    std::string text = fmt::format("{}: R = {}", file, format_uncertain(radius, "m"));
    if (const auto interval = interval_of(radius))
        text += fmt::format(" (95 %: {} to {})", format_value(interval->lower, "m", 5),
                            format_value(interval->upper, "m", 5));
    text +=
        fmt::format(", {} points from {} to {}, rms {} about the circle\n", lens.points, format_value(lens.first, "m"),
                    format_value(lens.last, "m"), format_value(lens.circle.rms_residual, "m"));
    if (const auto& conic = lens.conic; conic && conic->conic_constant.uncertain())
        text += fmt::format(
            "  apex: R = {}, conic constant {} (0 is a sphere; p = {}); {} off the apex's sphere at the "
            "farthest point\n",
            format_uncertain(conic->radius, "m"), uncertain_number(conic->conic_constant),
            probability_text(conic->probability), format_value(conic->departure, "m", 3));
    for (const auto& alert : lens.alerts) text += fmt::format("  {}: {}\n", alert.code, alert.message);
    return text;
}

ExitCode run(const Arguments& arguments) {
    if (arguments.files.empty())
        throw InvalidArgument("a profile is wanted: setae jkr lens PROFILE.csv, or a picture of its side");
    output::Json lenses = output::Json::array();
    const ExitCode code = for_each_item(arguments.files, [&](const std::string& file) {
        const Lens lens = lens_of(file, arguments);
        if (arguments.common.json) lenses.push_back(as_json(file, lens));
        else print(as_text(file, lens));
    });
    if (arguments.common.json) print_json(arguments.files.size() == 1 && lenses.size() == 1 ? lenses.front() : lenses);
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options
        .add("files", arguments->files,
             "tables of two lengths with their units, a profilometer's trace, or pictures of the lens's side")
        .of_inputs();
    options.add("--x", arguments->x, "column along the lens; default: the first of lengths");
    options.add("--z", arguments->z, "column of heights; default: the second of lengths");
    options.add("--pixel", arguments->pixel, "of pictures that do not state it, such as \"2.05 um\"")
        .quantity(positive(dimension::length));
    options.add("--from", arguments->from, "points before are left out, such as \"-0.2 mm\"")
        .quantity(dimension::length);
    options.add("--to", arguments->to, "points behind are left out").quantity(dimension::length);
    options.example("setae jkr lens profile.csv", "radius and asphericity from a profile");
    options.example("setae jkr lens side.png --pixel \"2.05 um\"", "from a picture of its side");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::jkr_lens_command
