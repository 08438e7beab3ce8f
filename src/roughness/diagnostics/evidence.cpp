// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "scan_spectrum.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/display_unit.hpp"
#include "setae/numerics/row_blocks.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::diagnostics {
namespace {

using topography::HeightMap;

/// The least number of points along x and in all that spikes and spectra are looked for in.
constexpr Index fewest_points = 16;

/// Undefined points become the straight line between the defined ones beside them along x, and beyond the last of them
/// its height. Lines without a defined point become 0.
void fill_along_lines(Array2D& heights, parallel::Threads threads) {
    constexpr Index together = 16;  // lines lie across memory: those on one cache line are looked at by one thread
    const Index n = heights.rows(), blocks = (heights.cols() + together - 1) / together;
    const auto fill_line = [&](Index j) {
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
    };
    parallel::for_each_index(static_cast<std::size_t>(blocks), threads, [&](std::size_t block) {
        const Index first = static_cast<Index>(block) * together;
        for (Index j = first; j < std::min(heights.cols(), first + together); ++j) fill_line(j);
    });
}

/// How many heights are defined.
Index defined_of(const Array2D& heights, parallel::Threads threads) {
    const Index columns = heights.cols();
    const auto counts = numerics::by_row_blocks(numerics::RowBlocks(heights.rows(), columns), threads, Index{0},
                                                [&](Index first, Index last, Index& count) {
                                                    const double* const values = heights.data();
                                                    for (Index k = first * columns; k < last * columns; ++k)
                                                        count += values[k] == values[k];
                                                });
    return std::accumulate(counts.begin(), counts.end(), Index{0});
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
    auto spikes = evidence.is_line ? processing::find_spikes(as_line(*evidence.clean), {}, threads)
                                   : processing::find_spikes(*evidence.clean, {}, threads);
    if (spikes.count == 0) return;
    auto without = despiked(*evidence.clean, evidence.is_line, threads);
    const double step = evidence.clean->pixel_size()[0];
    if (!(rms_slope_along_x(without.heights, step) < rms_slope_along_x(evidence.clean->heights, step))) return;
    evidence.spikes = std::move(spikes);
    evidence.clean = std::make_shared<const HeightMap>(std::move(without));
}

SharedMap without_tilt(const SharedMap& map, bool is_line, parallel::Threads threads) {
    if (!is_line)
        return std::make_shared<const HeightMap>(topography::detrended(*map, topography::Trend::tilt, threads));
    return std::make_shared<const HeightMap>(as_map(topography::detrended(as_line(*map), topography::Trend::tilt)));
}

/// Scars, then spikes are taken out, and what is undefined is filled.
void clean(Evidence& evidence, parallel::Threads threads) {
    const auto [nx, ny] = evidence.map->shape();
    evidence.clean = evidence.level;
    if (!evidence.flat && !evidence.is_line) evidence.scars = scar_points(*evidence.level, threads);
    if (evidence.scars) {
        HeightMap bridged = *evidence.level;
        bridge_lines(bridged.heights, *evidence.scars);
        evidence.clean = std::make_shared<const HeightMap>(std::move(bridged));
    }
    if (!evidence.flat && nx >= fewest_points && (evidence.is_line || ny >= fewest_points))
        take_out_spikes(evidence, threads);
    if (defined_of(evidence.clean->heights, threads) == nx * ny) return;
    HeightMap filled = *evidence.clean;
    fill_along_lines(filled.heights, threads);
    evidence.clean = std::make_shared<const HeightMap>(std::move(filled));
}

Evidence evidence(SharedMap map, bool is_line, parallel::Threads threads) {
    Evidence result;
    result.subject = topography::label(map->metadata);
    result.is_line = is_line;
    result.defined = defined_of(map->heights, threads);
    result.flat = constant(map->heights);
    const Index coefficients = is_line ? 2 : 3;
    result.level = result.flat || result.defined <= coefficients ? map : without_tilt(map, is_line, threads);
    result.map = std::move(map);
    std::array<double, 2> rms{};
    parallel::for_each_index(2, threads, [&](std::size_t task) {
        if (task == 0) clean(result, threads);
        else rms = rms_heights(result.map->heights, result.level->heights);
    });
    result.rms_map = rms[0], result.rms_level = rms[1];
    if (!result.flat && result.map->heights.rows() >= fewest_points)
        result.scan_spectrum = scan_spectrum(*result.clean, threads);
    return result;
}

}  // namespace

Evidence evidence_of(const HeightMap& map, parallel::Threads threads) {
    return evidence(SharedMap(SharedMap{}, &map), false, threads);
}

Evidence evidence_of(const topography::LineScan& scan, parallel::Threads threads) {
    return evidence(std::make_shared<const HeightMap>(as_map(scan)), true, threads);
}

namespace {

/// Sums in the order of the points, of several maps in turn, so that none waits for the last sum.
template <std::size_t count>
std::array<double, count> rms_side_by_side(const std::array<const Array2D*, count>& maps) {
    std::array<const double*, count> heights;
    std::array<double, count> sum{}, mean, squares{}, rms;
    std::array<Index, count> n{};
    for (std::size_t m = 0; m < count; ++m) heights[m] = maps[m]->data();
    const Index points = maps[0]->size();
    for (Index k = 0; k < points; ++k)
        for (std::size_t m = 0; m < count; ++m) {
            const double height = heights[m][k];
            const bool defined = height == height;
            sum[m] += defined ? height : 0.0;
            n[m] += defined;
        }
    for (std::size_t m = 0; m < count; ++m) mean[m] = sum[m] / static_cast<double>(n[m]);
    for (Index k = 0; k < points; ++k)
        for (std::size_t m = 0; m < count; ++m) {
            const double height = heights[m][k], rest = height - mean[m];
            squares[m] += height == height ? rest * rest : 0.0;
        }
    for (std::size_t m = 0; m < count; ++m) rms[m] = std::sqrt(squares[m] / static_cast<double>(n[m]));
    return rms;
}

}  // namespace

double rms_height(const Array2D& heights) { return rms_side_by_side<1>({&heights})[0]; }

std::array<double, 2> rms_heights(const Array2D& first, const Array2D& second) {
    return rms_side_by_side<2>({&first, &second});
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
