// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/display_unit.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::diagnostics {
namespace {

using topography::HeightMap;

/// The least number of points along x and in all that spikes are looked for in.
constexpr Index fewest_points = 16;

/// Undefined points become the straight line between the defined ones beside them along x, and beyond the last of them
/// its height. Lines without a defined point become 0.
void fill_along_lines(Array2D& heights) {
    const Index n = heights.rows();
    for (Index j = 0; j < heights.cols(); ++j) {
        Index before = -1;
        for (Index i = 0; i <= n; ++i) {
            if (i < n && std::isnan(heights(i, j))) continue;
            for (Index k = before + 1; k < i; ++k) {
                if (before < 0 && i == n) heights(k, j) = 0.0;
                else if (before < 0) heights(k, j) = heights(i, j);
                else if (i == n) heights(k, j) = heights(before, j);
                else {
                    const double t = static_cast<double>(k - before) / static_cast<double>(i - before);
                    heights(k, j) = (1.0 - t) * heights(before, j) + t * heights(i, j);
                }
            }
            before = i;
        }
    }
}

/// Chosen points become the straight line along y between those beside them that are not chosen; at a border the height
/// of the last one.
void bridge_lines(Array2D& heights, const topography::Mask& chosen) {
    const Index ny = heights.cols();
    for (Index i = 0; i < heights.rows(); ++i) {
        Index before = -1;
        for (Index j = 0; j <= ny; ++j) {
            if (j < ny && chosen(i, j) != 0) continue;
            for (Index k = before + 1; k < j; ++k) {
                if (before < 0 && j == ny) continue;
                const double left = before < 0 ? heights(i, j) : heights(i, before),
                             right = j == ny ? left : heights(i, j);
                heights(i, k) =
                    left + (right - left) * static_cast<double>(k - before) / static_cast<double>(j - before);
            }
            before = j;
        }
    }
}

/// The points of a scan as a map of one line.
HeightMap as_map(const topography::LineScan& scan) {
    return {Eigen::Map<const Array2D>(scan.heights.data(), scan.heights.size(), 1),
            {scan.size, scan.pixel_size()},
            scan.periodic,
            scan.metadata};
}

topography::LineScan as_line(const HeightMap& map) {
    return {map.heights.col(0), map.size[0], map.periodic, map.metadata};
}

bool constant(const Array2D& heights) {
    double first = undefined;
    for (Index k = 0; k < heights.size(); ++k) {
        const double h = heights.data()[k];
        if (std::isnan(h)) continue;
        if (std::isnan(first)) first = h;
        if (h != first) return false;
    }
    return true;
}

/// A map or line without its spikes.
HeightMap despiked(const HeightMap& map, bool is_line, parallel::Threads threads) {
    const processing::Despike despike;
    if (!is_line) return std::get<HeightMap>(processing::apply(despike, map, threads).measurement);
    HeightMap result = map;
    result.heights.col(0) =
        std::get<topography::LineScan>(processing::apply(despike, as_line(map), threads).measurement).heights;
    return result;
}

/// What does not lower the slopes when it is taken out belongs to the surface, such as steps and grains.
void take_out_spikes(Evidence& evidence, parallel::Threads threads) {
    auto spikes = evidence.is_line ? processing::find_spikes(as_line(evidence.clean), {}, threads)
                                   : processing::find_spikes(evidence.clean, {}, threads);
    if (spikes.count == 0) return;
    auto without = despiked(evidence.clean, evidence.is_line, threads);
    const double step = evidence.clean.pixel_size()[0];
    if (!(rms_slope_along_x(without.heights, step) < rms_slope_along_x(evidence.clean.heights, step))) return;
    evidence.spikes = std::move(spikes);
    evidence.clean = std::move(without);
}

Evidence evidence(HeightMap map, bool is_line, parallel::Threads threads) {
    Evidence result;
    result.subject = topography::label(map.metadata);
    result.is_line = is_line;
    result.defined = map.heights.size() - map.heights.isNaN().count();
    const bool flat = result.flat = constant(map.heights);
    const Index coefficients = is_line ? 2 : 3;
    if (flat || result.defined <= coefficients) {
        result.level = map;
    } else if (is_line) {
        result.level = map;
        result.level.heights.col(0) = topography::detrended(as_line(map), topography::Trend::tilt).heights;
    } else {
        result.level = topography::detrended(map, topography::Trend::tilt);
    }
    result.clean = result.level;
    if (!flat && !is_line) result.scars = scar_points(result.level, threads);
    if (result.scars) bridge_lines(result.clean.heights, *result.scars);
    if (!flat && map.heights.rows() >= fewest_points && (is_line || map.heights.cols() >= fewest_points))
        take_out_spikes(result, threads);
    fill_along_lines(result.clean.heights);
    result.map = std::move(map);
    return result;
}

}  // namespace

Evidence evidence_of(const HeightMap& map, parallel::Threads threads) { return evidence(map, false, threads); }

Evidence evidence_of(const topography::LineScan& scan, parallel::Threads threads) {
    return evidence(as_map(scan), true, threads);
}

double rms_height(const Array2D& heights) {
    double sum = 0.0, squares = 0.0;
    Index n = 0;
    for (Index k = 0; k < heights.size(); ++k)
        if (!std::isnan(heights.data()[k])) sum += heights.data()[k], ++n;
    const double mean = sum / static_cast<double>(n);
    for (Index k = 0; k < heights.size(); ++k)
        if (!std::isnan(heights.data()[k])) squares += (heights.data()[k] - mean) * (heights.data()[k] - mean);
    return std::sqrt(squares / static_cast<double>(n));
}

double rms_slope_along_x(const Array2D& heights, double step) {
    double squares = 0.0;
    Index n = 0;
    for (Index i = 0; i + 1 < heights.rows(); ++i)
        for (Index j = 0; j < heights.cols(); ++j) {
            const double rise = heights(i + 1, j) - heights(i, j);
            if (!std::isnan(rise)) squares += rise * rise, ++n;
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
