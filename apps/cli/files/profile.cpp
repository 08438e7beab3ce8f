// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "setae/answers/diagnosis.hpp"
#include "setae/answers/profile_fields.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/table.hpp"
#include "setae/core/units.hpp"
#include "setae/output/field_json.hpp"
#include "setae/processing/line_profile.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::cli::profile_command {
namespace {

constexpr const char* explanation =
    "The command writes the heights of a map along a straight line.\n"
    "Heights are interpolated linearly. Along a line of the grid they are the stored heights.\n"
    "\n"
    "x, y     from the first point of the map, y downwards as in its picture; point (i, j) is at (i Dx, j Dy)\n"
    "         The last point is one pixel before the edge of the map. A line to the edge ends at the last point.\n"
    "--width  mean over parallel lines, one pixel apart\n";

struct Arguments {
    Common common;
    answers::FileRequest file;
    std::string path, from, to, unit, width, output;
    std::optional<Index> points;
};

/// Length of the unit of a coordinate along x and y in metres; "px" is the pixel.
std::array<double, 2> unit_lengths(const std::string& unit, const topography::HeightMap& map) {
    if (unit == "px") return map.pixel_size();
    if (unit.empty()) throw InvalidArgument("no unit of --from and --to; expected --unit-xy um, another length, or px");
    const double length = parse_quantity("1 " + unit, dimension::length);
    return {length, length};
}

/// "1,2".
std::array<double, 2> parsed_point(const std::string& text, const char* option, const std::array<double, 2>& unit) {
    const auto point = spelled_list<double, 2>(text, ',');
    if (!point) throw InvalidArgument(fmt::format("{} '{}'; expected two numbers, such as 1.5,2", option, text));
    return {(*point)[0] * unit[0], (*point)[1] * unit[1]};
}

/// "5px" or "300 nm"; the pixel is measured across the line.
double parsed_width(const std::string& text, const topography::HeightMap& map, const processing::ProfileLine& line) {
    if (text.empty()) return 0.0;
    if (!text.ends_with("px")) return parse_quantity(text, dimension::length);
    const auto pixel = map.pixel_size();
    const double x = line.to[0] - line.from[0], y = line.to[1] - line.from[1], length = std::hypot(x, y);
    const double pixels = parse_quantity(text.substr(0, text.size() - 2), dimension::none);
    return length > 0.0 ? pixels / std::hypot(y / length / pixel[0], x / length / pixel[1]) : 0.0;
}

ExitCode run(const Arguments& arguments) {
    if (arguments.path.empty()) throw InvalidArgument("no file; expected a map");
    const auto measurement = answers::measurements_of(arguments.path, arguments.file).front();
    const auto* map = std::get_if<topography::HeightMap>(&measurement);
    if (!map) throw InvalidArgument(fmt::format("{}: contains a line; expected a map", arguments.path));
    show(map->metadata.alerts);
    const auto unit = unit_lengths(arguments.unit, *map);
    processing::ProfileLine line{parsed_point(arguments.from, "--from", unit), parsed_point(arguments.to, "--to", unit),
                                 0.0, arguments.points};
    line.width = parsed_width(arguments.width, *map, line);
    const auto profile = processing::line_profile(*map, line);
    Table table;
    const Index n = profile.x.size();
    table.columns = {
        {"distance", "m", profile.scan.pixel_size() * Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1))},
        {"x", "m", profile.x},
        {"y", "m", profile.y},
        {"height", "m", profile.scan.heights}};
    table.metadata["lines_averaged"] = std::to_string(profile.tracks);
    if (!arguments.output.empty()) tables::write_csv(arguments.output, table);
    if (arguments.common.json) {
        print_json(output::described(answers::ProfileEntry{table, profile.tracks, arguments.path}));
    } else if (arguments.output.empty()) {
        print(tables::as_csv(table));
    }
    return ExitCode::done;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    options.add("file", arguments->path, "map, or container with a map").of_inputs();
    options.ask(arguments->file, OptionGroup::height_files);
    options.add("--from", arguments->from, "x,y of the first point of the line, such as 0,0");
    options.add("--to", arguments->to, "x,y of the last point of the line, such as 5,2.5");
    options.add("--unit-xy", arguments->unit,
                "unit of x and y of both points: um, nm, mm …, or px for points of the map");
    options.add("--width", arguments->width, "width of the mean across the line, such as 5px or \"300 nm\"");
    options.add("--points", arguments->points, "number of points along the line; default: about one per pixel");
    options.output("-o,--output", arguments->output, "write OUT.csv");
    options.example("setae profile map.ibw --from 0,0 --to 5,2.5 --unit-xy um -o line.csv",
                    "heights between two points");
    options.example("setae profile map.ibw --from 10,10 --to 200,10 --unit-xy px --width 5px",
                    "mean of five parallel lines");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::profile_command
