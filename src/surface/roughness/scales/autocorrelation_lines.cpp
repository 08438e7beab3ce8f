// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/autocorrelation.hpp"

#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "autocorrelation_result.hpp"
#include "line_pairs.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::scales {
namespace {

FunctionOfScale result_of(const LinePairs& lines, double step, const topography::Metadata& metadata) {
    const auto sums = lines.sums();
    if (!(sums.pairs[0] > 0.0))
        throw UndefinedDataError(
            fmt::format("{}: no height is defined, so that there is no autocorrelation", topography::label(metadata)));
    std::vector<Index> kept;
    for (Index k = 1; k < sums.pairs.size(); ++k)
        if (sums.pairs[k] > 0.5) kept.push_back(k);
    auto result = empty_autocorrelation(static_cast<Index>(kept.size()), metadata);
    for (Index k = 0; k < result.distance.size(); ++k) {
        const Index lag = kept[static_cast<std::size_t>(k)];
        result.distance[k] = static_cast<double>(lag) * step;
        result.value[k] = sums.squares[lag] / sums.pairs[lag];
        result.count[k] = sums.pairs[lag];
    }
    return result;
}

/// Pairs of lines of this many points.
LinePairs pairs_of(Index points, bool periodic, const topography::Metadata& metadata) {
    if (points < 2)
        throw InvalidArgument(fmt::format("{}: {} points along x form no pair; expected at least 2",
                                          topography::label(metadata), points));
    return {points, periodic};
}

}  // namespace

FunctionOfScale autocorrelation(const topography::LineScan& scan, const AutocorrelationOptions& options) {
    auto lines = pairs_of(scan.heights.size(), scan.periodic, scan.metadata);
    lines.add(Eigen::Map<const Array2D>(scan.heights.data(), scan.heights.size(), 1), options.threads);
    auto result = result_of(lines, scan.pixel_size(), scan.metadata);
    result.reliable_from = 0.5 * shortest_reliable_wavelength(scan, options.reliability, options.threads);
    return result;
}

FunctionOfScale autocorrelation_of_lines(const topography::HeightMap& map, const AutocorrelationOptions& options) {
    auto lines = pairs_of(map.heights.rows(), map.periodic, map.metadata);
    lines.add(map.heights, options.threads);
    auto result = result_of(lines, map.pixel_size()[0], map.metadata);
    result.reliable_from = 0.5 * shortest_reliable_wavelength(map, options.reliability, options.threads);
    return result;
}

FunctionOfScale autocorrelation_of_lines(const topography::TiledMap& map, std::size_t band_bytes,
                                         const AutocorrelationOptions& options) {
    auto lines = pairs_of(map.nx, map.periodic, map.metadata);
    const Index band = topography::lines_in(map, band_bytes);
    for (Index first = 0; first < map.ny; first += band)
        lines.add(map.lines(first, std::min(band, map.ny - first)), options.threads);
    auto result = result_of(lines, map.pixel_size()[0], map.metadata);
    result.reliable_from = 0.5 * shortest_reliable_wavelength(map, band, options.reliability, options.threads);
    return result;
}

FunctionOfScale autocorrelation_along_lines(const topography::Measurement& measurement,
                                            const AutocorrelationOptions& options) {
    struct Visitor {
        const AutocorrelationOptions& options;
        FunctionOfScale operator()(const topography::HeightMap& map) const {
            return autocorrelation_of_lines(map, options);
        }
        FunctionOfScale operator()(const topography::LineScan& scan) const { return autocorrelation(scan, options); }
        FunctionOfScale operator()(const topography::Profile& profile) const {
            return autocorrelation(profile, {}, options);
        }
    };
    return std::visit(Visitor{options}, measurement);
}

FunctionOfScale slope_from_autocorrelation(const FunctionOfScale& autocorrelation) {
    if (autocorrelation.quantity != "autocorrelation")
        throw InvalidArgument(
            fmt::format("a slope follows only from an autocorrelation; got {}", autocorrelation.quantity));
    FunctionOfScale slope = autocorrelation;
    slope.quantity = "rms_slope";
    slope.unit = "1";
    slope.value = (2.0 * autocorrelation.value).sqrt() / autocorrelation.distance;
    slope.standard_error =
        autocorrelation.standard_error / (autocorrelation.distance * (2.0 * autocorrelation.value).sqrt());
    return slope;
}

}  // namespace setae::scales
