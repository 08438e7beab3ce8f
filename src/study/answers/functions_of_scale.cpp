// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/functions_of_scale.hpp"

#include <algorithm>
#include <sstream>
#include <variant>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/scales/autocorrelation.hpp"
#include "setae/scales/scale_dependent.hpp"
#include "setae/scales/variable_bandwidth.hpp"

namespace setae::answers {
namespace {

using Function = scales::FunctionOfScale (*)(const topography::Measurement&, const ScaleRequest&, parallel::Threads);
using FunctionOfTiledMap = scales::FunctionOfScale (*)(const topography::TiledMap&, const ScaleRequest&,
                                                       parallel::Threads);

/// Functions of a command; `of_tiled_map` is null where a map must be in memory as a whole.
struct ScaleCommand {
    Function of_measurement;
    FunctionOfTiledMap of_tiled_map;
};

const topography::HeightMap& map_of(const topography::Measurement& measurement) {
    const auto* map = std::get_if<topography::HeightMap>(&measurement);
    if (!map)
        throw InvalidArgument(topography::label(topography::metadata(measurement)) +
                              ": a line has no area; leave out `area`");
    return *map;
}

scales::FunctionOfScale slope_or_curvature(const topography::Measurement& measurement, const ScaleRequest& request,
                                           parallel::Threads threads) {
    scales::DifferenceOptions options{.order = request.order,
                                      .along = scales::along_from_name(request.along),
                                      .grid = spectra::LogGrid{request.bins_per_decade}};
    options.threads = threads;
    if (!request.distance.empty()) {
        auto distances = distances_of(request.distance);
        std::sort(distances.begin(), distances.end());
        options.distances = Eigen::Map<const Array1D>(distances.data(), static_cast<Index>(distances.size()));
    }
    return scales::function_of(scales::difference_statistics(measurement, options),
                               scales::statistic_from_name(request.statistic));
}

scales::FunctionOfScale autocorrelation_or_slope(const topography::Measurement& measurement,
                                                 const ScaleRequest& request, parallel::Threads threads) {
    const scales::AutocorrelationOptions options{.threads = threads};
    if (request.area && request.slope)
        throw InvalidArgument("`slope` of an area; take the slope of lines, or leave it out");
    if (request.area && !request.longest.empty())
        return scales::autocorrelation_of_area(
            topography::tiled(map_of(measurement)), parse_quantity(request.longest, dimension::length),
            spectra::LogGrid{request.bins_per_decade}, std::size_t{1} << 28, options);
    if (request.area)
        return scales::autocorrelation_of_area(map_of(measurement), spectra::LogGrid{request.bins_per_decade}, options);
    const auto lines = scales::autocorrelation_along_lines(measurement, options);
    return request.slope ? scales::slope_from_autocorrelation(lines) : lines;
}

scales::FunctionOfScale autocorrelation_of_tiled_map(const topography::TiledMap& map, const ScaleRequest& request,
                                                     parallel::Threads threads) {
    const scales::AutocorrelationOptions options{.threads = threads};
    const auto bytes = static_cast<std::size_t>(request.largest_map);
    if (!request.area) {
        const auto lines = scales::autocorrelation_of_lines(map, bytes, options);
        return request.slope ? scales::slope_from_autocorrelation(lines) : lines;
    }
    if (request.longest.empty())
        throw InvalidArgument(
            topography::label(map.metadata) +
            ": the area of a map that is read by bands; expected `longest`, the longest distance looked at");
    return scales::autocorrelation_of_area(map, parse_quantity(request.longest, dimension::length),
                                           spectra::LogGrid{request.bins_per_decade}, bytes, options);
}

scales::FunctionOfScale bandwidth(const topography::Measurement& measurement, const ScaleRequest& request,
                                  parallel::Threads threads) {
    const scales::VariableBandwidthOptions options{.threads = threads};
    return request.area ? scales::variable_bandwidth_of_area(map_of(measurement), options)
                        : scales::variable_bandwidth_along_lines(measurement, options);
}

scales::FunctionOfScale tiled_map_function(const study::TiledMeasurement& large, const ScaleRequest& request,
                                           parallel::Threads threads, FunctionOfTiledMap function) {
    if (!function)
        throw InvalidArgument(
            topography::label(large.map.metadata) +
            ": this function needs the map as a whole, which is larger than `memory` allows; allow more or crop it");
    const auto lines_together = topography::lines_in(large.map, static_cast<std::size_t>(request.largest_map));
    return function(topography::detrended(large.map, large.trend, lines_together, threads), request, threads);
}

/// One measurement at a time, so that maps need not all fit into memory. Failures are noted, and the others continue.
FunctionsOfScale functions_of(const ScaleRequest& request, parallel::Threads threads, const ScaleCommand& command) {
    FunctionsOfScale found;
    const auto take = [&](scales::FunctionOfScale result, const std::vector<Alert>& alerts) {
        if (request.all) result.reliable_from = 0.0;
        found.alerts.insert(found.alerts.end(), alerts.begin(), alerts.end());
        found.alerts.insert(found.alerts.end(), result.alerts.begin(), result.alerts.end());
        found.functions.push_back(std::move(result));
    };
    const auto attempt = [&](const auto& body) {
        try {
            body();
        } catch (const std::exception& error) {
            if (request.every_measurement) throw;
            found.failures.push_back(reason_of(error));
        }
    };
    const study::SurfaceAnalysisOptions options{.largest_map = request.largest_map};
    const auto& surface = request.surface;
    if (request.order < 1 || request.order > 3)
        throw InvalidArgument(fmt::format("order {}; expected 1, 2 or 3", request.order));
    if (request.bins_per_decade < 1)
        throw InvalidArgument(fmt::format("{} bins a decade; expected 1 or more", request.bins_per_decade));
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
                        take(tiled_map_function(*source.tiled, request, threads, command.of_tiled_map),
                             source.tiled->alerts);
                        return;
                    }
                    const auto prepared = source.prepare();
                    take(command.of_measurement(prepared.measurement, request, threads), prepared.alerts);
                });
        });
    return found;
}

/// Combines the results.
void combine(FunctionsOfScale& found, const ScaleRequest& request) {
    const scales::CombinationOptions options{spectra::LogGrid{request.bins_per_decade},
                                             scales::weighting_from_name(request.weighting)};
    auto combined = scales::combine(found.functions, options);
    found.alerts.insert(found.alerts.end(), combined.alerts.begin(), combined.alerts.end());
    if (found.functions.size() > 1 || request.binned) found.combined = std::move(combined);
}

Table table_of(const FunctionsOfScale& found, const ScaleRequest& request) {
    Table table;
    if (!found.combined) {
        const auto only = scales::within_limit(found.functions.front());
        table.columns = {{"distance", "m", only.distance},
                         {only.quantity, only.unit, only.value},
                         {"count", only.count_unit, only.count}};
        return table;
    }
    table.metadata["weighting"] = request.weighting;
    const auto& combined = *found.combined;
    table.columns = {{"distance", "m", combined.distance},
                     {combined.quantity, combined.unit, combined.value},
                     {"standard_error", combined.unit, combined.standard_error},
                     {"count", "1", combined.count},
                     {"instrument_count", "1", combined.instrument_count}};
    return table;
}

ScaleCommand scale_command(ScaleFunction function) {
    switch (function) {
        case ScaleFunction::differences: return {slope_or_curvature, nullptr};
        case ScaleFunction::autocorrelation: return {autocorrelation_or_slope, autocorrelation_of_tiled_map};
        case ScaleFunction::variable_bandwidth: return {bandwidth, nullptr};
    }
    throw InternalError("a function of scale without a command");
}

}  // namespace

std::vector<double> distances_of(const std::string& text) {
    std::vector<double> distances;
    std::istringstream list(text);
    for (std::string one; std::getline(list, one, ',');) distances.push_back(parse_quantity(one, dimension::length));
    return distances;
}

FunctionsOfScale functions_of_scale(ScaleFunction function, const ScaleRequest& request, parallel::Threads threads) {
    auto found = functions_of(request, threads, scale_command(function));
    found.function = function;
    if (found.functions.empty()) return found;
    combine(found, request);
    found.table = table_of(found, request);
    return found;
}

}  // namespace setae::answers
