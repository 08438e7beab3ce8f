// SPDX-License-Identifier: GPL-3.0-or-later
// sdrp, acf and vbw: functions of a distance, of one measurement or combined from several.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "psd/surface_options.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/file_figures/scale_figure.hpp"
#include "setae/scales/autocorrelation.hpp"
#include "setae/scales/scale_dependent.hpp"
#include "setae/scales/variable_bandwidth.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::cli {
namespace {

constexpr const char* sdrp_explanation =
    "order 1: [h(x + s) - h(x)]/s, d = s; order 2: [h(x - s) - 2h(x) + h(x + s)]/s^2, d = 2s; order 3: d = 3s\n"
    "d: length of the whole stencil; reliable from d = order/2 of the shortest wavelength     10.1016/j.apsadv.2021.100190\n"
    "both directions of a map: |grad h| (order 1), half the Laplacian (order 2)\n";
constexpr const char* acf_explanation =
    "A(d) = <[h(x + d) - h(x)]^2>/2 [m2] over all pairs of defined points; reliable from half the shortest wavelength\n"
    "--area: mean over all vectors of a length, the full circle; --slope: sqrt(2A)/d              Wang, Mueser 2018\n";
constexpr const char* vbw_explanation =
    "rms of all residuals of the best line (--area: plane) in each of m cells, m = 1, 2, 4, ... while n/m >= 4\n"
    "distance: size/m; reliable from the shortest wavelength                                     10.1088/2051-672X/aa51f8\n";

/// "10nm,100nm".
std::vector<double> distances_of(const std::string& text) {
    std::vector<double> distances;
    std::istringstream list(text);
    for (std::string one; std::getline(list, one, ',');) distances.push_back(parse_quantity(one, dimension::length));
    return distances;
}

/// Options of all three verbs.
struct ScaleArguments {
    Common common;
    SurfaceOptions surface;
    bool area = false, slope = false, all = false, binned = false;
    int order = 1, bins_per_decade = 10;
    std::string distance, longest, statistic = "rms", along = "x", weighting = "equal", output;
    FigureOption figure;

    void add_to(Options& options) {
        surface.add_measurements_to(options, "measurements of one surface: files or containers");
        options.flag("--all", all, "also distances that sampling, tip or resolution make unreliable");
        options.flag("--binned", binned, "one measurement in the bins of combined ones too");
        options.add("--bins-per-decade", bins_per_decade, "bins of combined functions").between(1, 1000);
        options.add("--weighting", weighting, "equal, per_instrument or by_count")
            .one_of({"equal", "per_instrument", "by_count"});
        options.add("-o,--output,--csv", output, "table OUT.csv or OUT.nc; figure OUT.svg, .pdf or .png");
        figure.add_to(options);
    }
    [[nodiscard]] spectra::LogGrid grid() const { return {bins_per_decade}; }
};

using Function = scales::FunctionOfScale (*)(const topography::Measurement&, const ScaleArguments&);
using FunctionOfTiledMap = scales::FunctionOfScale (*)(const topography::TiledMap&, const ScaleArguments&);

/// What a verb computes; `of_tiled_map` is null where a map has to be held as a whole.
struct Verb {
    Function of_measurement;
    FunctionOfTiledMap of_tiled_map;
};

const topography::HeightMap& map_of(const topography::Measurement& measurement) {
    const auto* map = std::get_if<topography::HeightMap>(&measurement);
    if (!map)
        throw InvalidArgument(topography::label(topography::metadata(measurement)) +
                              ": a line has no area; leave out --area");
    return *map;
}

scales::FunctionOfScale slope_or_curvature(const topography::Measurement& measurement,
                                           const ScaleArguments& arguments) {
    scales::DifferenceOptions options{
        .order = arguments.order, .along = scales::along_from_name(arguments.along), .grid = arguments.grid()};
    options.threads = arguments.common.workers();
    if (!arguments.distance.empty()) {
        auto distances = distances_of(arguments.distance);
        std::sort(distances.begin(), distances.end());
        options.distances = Eigen::Map<const Array1D>(distances.data(), static_cast<Index>(distances.size()));
    }
    return scales::function_of(scales::difference_statistics(measurement, options),
                               scales::statistic_from_name(arguments.statistic));
}

scales::FunctionOfScale autocorrelation_or_slope(const topography::Measurement& measurement,
                                                 const ScaleArguments& arguments) {
    const scales::AutocorrelationOptions options{.threads = arguments.common.workers()};
    if (arguments.area && arguments.slope)
        throw InvalidArgument("--slope of an area; take the slope of lines, or leave it out");
    if (arguments.area && !arguments.longest.empty())
        return scales::autocorrelation_of_area(topography::tiled(map_of(measurement)),
                                               parse_quantity(arguments.longest, dimension::length), arguments.grid(),
                                               std::size_t{1} << 28, options);
    if (arguments.area) return scales::autocorrelation_of_area(map_of(measurement), arguments.grid(), options);
    const auto lines = scales::autocorrelation_along_lines(measurement, options);
    return arguments.slope ? scales::slope_from_autocorrelation(lines) : lines;
}

scales::FunctionOfScale autocorrelation_of_tiled_map(const topography::TiledMap& map, const ScaleArguments& arguments) {
    const scales::AutocorrelationOptions options{.threads = arguments.common.workers()};
    const auto bytes = static_cast<std::size_t>(arguments.surface.analysis().largest_map);
    if (!arguments.area) {
        const auto lines = scales::autocorrelation_of_lines(map, bytes, options);
        return arguments.slope ? scales::slope_from_autocorrelation(lines) : lines;
    }
    if (arguments.longest.empty())
        throw InvalidArgument(
            topography::label(map.metadata) +
            ": the area of a map that is read by bands; expected --longest, the longest distance looked at");
    return scales::autocorrelation_of_area(map, parse_quantity(arguments.longest, dimension::length), arguments.grid(),
                                           bytes, options);
}

scales::FunctionOfScale bandwidth(const topography::Measurement& measurement, const ScaleArguments& arguments) {
    const scales::VariableBandwidthOptions options{.threads = arguments.common.workers()};
    return arguments.area ? scales::variable_bandwidth_of_area(map_of(measurement), options)
                          : scales::variable_bandwidth_along_lines(measurement, options);
}

/// What was found, and of which measurement.
struct Found {
    std::vector<scales::FunctionOfScale> functions;
    std::optional<scales::CombinedFunction> combined;  ///< of several, or where bins are asked for
    std::vector<Alert> alerts;
    bool some_failed = false;
};

scales::FunctionOfScale tiled_map_function(const study::TiledMeasurement& large, const ScaleArguments& arguments,
                                           FunctionOfTiledMap function) {
    if (!function)
        throw InvalidArgument(
            topography::label(large.map.metadata) +
            ": this function needs the map as a whole, which is larger than --memory allows; allow more or crop it");
    const auto lines_together =
        topography::lines_in(large.map, static_cast<std::size_t>(arguments.surface.analysis().largest_map));
    return function(topography::detrended(large.map, large.trend, lines_together, arguments.common.workers()),
                    arguments);
}

/// One measurement at a time, so that maps need not all fit into memory. What fails is printed, and the others go on.
Found functions_of(const ScaleArguments& arguments, const Verb& verb) {
    Found found;
    const auto take = [&](scales::FunctionOfScale result, const std::vector<Alert>& alerts) {
        if (arguments.all) result.reliable_from = 0.0;
        found.alerts.insert(found.alerts.end(), alerts.begin(), alerts.end());
        found.alerts.insert(found.alerts.end(), result.alerts.begin(), result.alerts.end());
        found.functions.push_back(std::move(result));
    };
    const auto attempt = [&](const auto& body) {
        try {
            body();
        } catch (const std::exception& error) {
            complain(reason_of(error));
            found.some_failed = true;
        }
    };
    const auto options = arguments.surface.analysis();
    const auto surface = arguments.surface.surface();
    if (surface.power_spectrum)
        throw InvalidArgument(
            fmt::format("{}: a table of a spectrum holds no heights; setae psd, params and adhesion "
                        "take it",
                        *surface.power_spectrum));
    for (const auto& input : surface.measurements)
        attempt([&] {
            for (const auto& source : study::measurement_sources(input))
                attempt([&] {
                    if (study::too_large(source, options)) {
                        take(tiled_map_function(*source.tiled, arguments, verb.of_tiled_map), source.tiled->alerts);
                        return;
                    }
                    const auto prepared = source.prepare();
                    take(verb.of_measurement(prepared.measurement, arguments), prepared.alerts);
                });
        });
    return found;
}

/// Combines what was found.
void combine(Found& found, const ScaleArguments& arguments) {
    const scales::CombinationOptions options{arguments.grid(), scales::weighting_from_name(arguments.weighting)};
    auto combined = scales::combine(found.functions, options);
    found.alerts.insert(found.alerts.end(), combined.alerts.begin(), combined.alerts.end());
    if (found.functions.size() > 1 || arguments.binned) found.combined = std::move(combined);
}

Table table_of(const Found& found, const ScaleArguments& arguments) {
    Table table;
    if (!found.combined) {
        const auto only = scales::within_limit(found.functions.front());
        table.columns = {{"distance", "m", only.distance},
                         {only.quantity, only.unit, only.value},
                         {"count", only.count_unit, only.count}};
        return table;
    }
    table.metadata["weighting"] = arguments.weighting;
    const auto& combined = *found.combined;
    table.columns = {{"distance", "m", combined.distance},
                     {combined.quantity, combined.unit, combined.value},
                     {"standard_error", combined.unit, combined.standard_error},
                     {"count", "1", combined.count},
                     {"instrument_count", "1", combined.instrument_count}};
    return table;
}

output::Json as_json(const Table& table, const Found& found) {
    output::Json json, units;
    for (const auto& column : table.columns) {
        json[column.name] = output::numbers(column.values);
        units[column.name] = column.unit;
    }
    json["units"] = units;
    json["measurements"] = output::Json::array();
    for (const auto& function : found.functions)
        json["measurements"].push_back({{"file", function.metadata.file},
                                        {"name", function.metadata.name},
                                        {"reliable_from", output::number(function.reliable_from)}});
    if (found.combined) json["contributors"] = found.combined->contributors;
    json["alerts"] = output::to_json(found.alerts);
    return json;
}

ExitCode run(const ScaleArguments& arguments, const Verb& verb) {
    require_table_or_figure(arguments.output);
    auto found = functions_of(arguments, verb);
    if (found.functions.empty()) return ExitCode::nothing_done;
    combine(found, arguments);
    const auto table = table_of(found, arguments);
    write_table_or_figure(
        arguments.output, table,
        [&] {
            return file_figures::scale_figure(found.functions, found.combined ? &*found.combined : nullptr,
                                              arguments.figure.look());
        },
        arguments.common.json);
    if (arguments.common.json) print_json(as_json(table, found));
    else if (arguments.output.empty()) print(tables::as_csv(table));
    if (!arguments.common.json) show(found.alerts);
    return found.some_failed ? ExitCode::some_failed : ExitCode::done;
}

ExitCode run_sdrp(const ScaleArguments& arguments) { return run(arguments, {slope_or_curvature, nullptr}); }
ExitCode run_acf(const ScaleArguments& arguments) {
    return run(arguments, {autocorrelation_or_slope, autocorrelation_of_tiled_map});
}
ExitCode run_vbw(const ScaleArguments& arguments) { return run(arguments, {bandwidth, nullptr}); }

}  // namespace

Action sdrp_command(Options& options) {
    auto arguments = std::make_shared<ScaleArguments>();
    arguments->add_to(options);
    options
        .add("--distance", arguments->distance,
             "length of the stencil, such as 100nm, or several: 10nm,100nm; default ten a decade")
        .read_by([](const std::string& text) { (void)distances_of(text); });
    options.add("--order", arguments->order, "of the derivative: 1 slope, 2 curvature, 3").between(1, 3);
    options.add("--statistic", arguments->statistic, "rms, variance, mean, skewness, kurtosis, minimum, maximum")
        .one_of_unlisted({"rms", "variance", "mean", "skewness", "kurtosis", "minimum", "maximum"});
    options.add("--along", arguments->along, "x, y or both").one_of({"x", "y", "both"});
    options.example("setae sdrp afm.ibw --tip-radius \"10 nm\" -o slope.svg", "rms slope at every scale, as a figure");
    options.example("setae sdrp stylus.csv afm.ibw --order 2 --distance 100nm,1um",
                    "curvature at two scales, of two measurements combined");
    return action(options, arguments, sdrp_explanation, run_sdrp);
}

Action acf_command(Options& options) {
    auto arguments = std::make_shared<ScaleArguments>();
    arguments->add_to(options);
    options.flag("--area", arguments->area, "maps over all directions, not along their lines");
    options.add("--longest", arguments->longest, "longest distance of --area, which maps read by bands need")
        .quantity(positive(dimension::length));
    options.flag("--slope", arguments->slope, "the rms slope between points, sqrt(2A)/d");
    options.example("setae acf afm.ibw -o acf.csv", "along the scan lines, as a table");
    options.example("setae acf map.x3p --area -o acf.svg", "over all directions, as a figure");
    return action(options, arguments, acf_explanation, run_acf);
}

Action vbw_command(Options& options) {
    auto arguments = std::make_shared<ScaleArguments>();
    arguments->add_to(options);
    options.flag("--area", arguments->area, "planes in rectangles of maps, not lines in pieces of their scan lines");
    options.example("setae vbw stylus.csv -o vbw.svg", "rms height left in pieces of every length, as a figure");
    return action(options, arguments, vbw_explanation, run_vbw);
}

}  // namespace setae::cli
