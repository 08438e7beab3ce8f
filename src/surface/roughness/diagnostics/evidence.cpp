// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "rms_heights.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/display_unit.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::diagnostics {
namespace {

using topography::HeightMap;

/// The points of a scan as a map of one line.
HeightMap as_map(const topography::LineScan& scan) {
    return {Eigen::Map<const Array2D>(scan.heights.data(), scan.heights.size(), 1),
            {scan.size, scan.pixel_size()},
            scan.periodic,
            scan.metadata};
}

/// Number and range of the defined heights.
void count(Evidence& evidence, parallel::Threads threads) {
    struct Part {
        Index defined = 0;
        double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    };
    const auto& heights = evidence.map->heights;
    const Index columns = heights.cols();
    for (const auto& part : numerics::by_row_blocks(numerics::RowBlocks(heights.rows(), columns), threads, Part{},
                                                    [&](Index first, Index last, Part& result) {
                                                        auto [defined, lowest, highest] = result;
                                                        const double* const values = heights.data();
                                                        for (Index k = first * columns; k < last * columns; ++k) {
                                                            const double h = values[k];
                                                            defined += !std::isnan(h);
                                                            lowest = h < lowest ? h : lowest;
                                                            highest = h > highest ? h : highest;
                                                        }
                                                        result = {defined, lowest, highest};
                                                    })) {
        evidence.defined += part.defined;
        evidence.lowest = std::min(evidence.lowest, part.lowest);
        evidence.highest = std::max(evidence.highest, part.highest);
    }
    evidence.flat = !(evidence.lowest < evidence.highest);
}

/// A copy of the map without its tilt, and without the instrument: the bands of its spectra are not needed.
void level(Evidence& evidence, parallel::Threads threads) {
    const auto& map = *evidence.map;
    evidence.heights = {Array2D(map.heights.rows(), map.heights.cols()), map.size, map.periodic, map.metadata};
    evidence.heights.metadata.instrument = {};
    auto& heights = evidence.heights.heights;
    const Index coefficients = evidence.is_line ? 2 : 3;
    if (evidence.defined <= coefficients) {
        heights = map.heights;
    } else if (evidence.is_line) {
        heights.col(0) = topography::detrended(topography::LineScan{map.heights.col(0), map.size[0], map.periodic, {}},
                                               topography::Trend::tilt)
                             .heights;
    } else {
        evidence.tilt.emplace(map.heights, topography::Trend::tilt, threads);
        numerics::for_each_row(heights.rows(), heights.cols(), threads, [&](Index i) {
            evidence.tilt->take_from(i, map.heights.row(i).data(), heights.row(i).data());
        });
    }
}

Evidence evidence(SharedMap map, bool is_line, parallel::Threads threads) {
    Evidence result;
    result.subject = topography::label(map->metadata);
    result.is_line = is_line;
    result.map = std::move(map);
    count(result, threads);
    if (!result.flat) level(result, threads);
    return result;
}

}  // namespace

Evidence evidence_of(const HeightMap& map, parallel::Threads threads) {
    return evidence(SharedMap(SharedMap{}, &map), false, threads);
}

Evidence evidence_of(const topography::LineScan& scan, parallel::Threads threads) {
    return evidence(std::make_shared<const HeightMap>(as_map(scan)), true, threads);
}

double rms_height(const Array2D& heights) {
    return rms_heights<1>(heights.rows(), heights.cols(),
                          [&](Index i) { return std::array{heights.row(i).data()}; })[0];
}

double rms_height_without(const Array2D& heights, const topography::Mask& chosen) {
    Array1D rest(heights.cols());
    return rms_heights<1>(heights.rows(), heights.cols(), [&](Index i) {
        rest = (chosen.row(i) > 0).select(undefined, heights.row(i)).transpose();
        return std::array<const double*, 1>{rest.data()};
    })[0];
}

double rms_slope_along_x(const Array2D& heights, double step) {
    double squares = 0.0;
    Index n = 0;
    for (Index i = 0; i + 1 < heights.rows(); ++i) {
        const double *const lower = heights.row(i).data(), *const upper = heights.row(i + 1).data();
        for (Index j = 0; j < heights.cols(); ++j) {
            const double rise = upper[j] - lower[j];
            const bool defined = !std::isnan(rise);
            squares += defined ? rise * rise : 0.0;
            n += defined;
        }
    }
    return std::sqrt(squares / static_cast<double>(n)) / step;
}

Quantity effect(std::string name, std::string symbol, double value, std::string unit, double standard_error) {
    Quantity quantity;
    quantity.quantity = std::move(name);
    quantity.symbol = std::move(symbol);
    quantity.estimate.value = value;
    quantity.estimate.standard_error = standard_error;
    if (standard_error > 0.0) quantity.estimate.method = "delta";
    quantity.unit = std::move(unit);
    return quantity;
}

Quantity effect_count(std::string name, Index count) {
    return effect(std::move(name), "n", static_cast<double>(count), "1");
}

std::string length_text(double length) {
    const auto unit = display_unit(length, "m");
    return fmt::format("{:.4g} {}", length / unit.factor, unit.name);
}

}  // namespace setae::diagnostics
