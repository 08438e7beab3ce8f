// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "evidence.hpp"
#include "scan_spectrum.hpp"
#include "setae/core/constants.hpp"

namespace setae::diagnostics {
namespace {

using processing::NewHeight;

/// Minimum number of points along x and in total for the search for spikes and for spectra.
constexpr Index min_points = 16;

/// Undefined points are interpolated linearly between the defined ones next to them along x, and constant beyond the
/// last of them. Lines without a defined point become 0.
void fill_along_lines(Array2D& heights, parallel::Threads threads) {
    constexpr Index together = 16;  // lines are not contiguous: those on one cache line are processed by one thread
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

/// Selected points are interpolated linearly along y between those next to them that are not selected; constant at a
/// border.
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

topography::LineScan as_line(const topography::HeightMap& map) {
    return {map.heights.col(0), map.size[0], map.periodic, map.metadata};
}

processing::Spikes found_spikes(const Evidence& evidence, parallel::Threads threads) {
    if (evidence.is_line) return processing::find_spikes(as_line(evidence.heights), {}, threads);
    return processing::find_spikes(evidence.heights, {}, threads);
}

std::vector<NewHeight> heights_without(const processing::Spikes& spikes, const Evidence& evidence) {
    if (evidence.is_line) return processing::heights_without(spikes, {}, as_line(evidence.heights));
    return processing::heights_without(spikes, {}, evidence.heights);
}

/// Exchanges heights with those of a list.
void exchange(Array2D& heights, std::vector<NewHeight>& others) {
    for (auto& [point, height] : others) std::swap(heights.data()[point], height);
}

/// If a spike is on a scar, its height was removed with the scar.
void recall_scars(std::vector<NewHeight>& at_spikes, const Evidence& evidence) {
    const Index ny = evidence.heights.heights.cols();
    Array1D row(ny);
    Index in_row = -1;
    for (auto& [point, height] : at_spikes) {
        if (evidence.scars->data()[point] == 0) continue;
        if (const Index i = point / ny; i != in_row) {
            evidence.tilt->take_from(i, evidence.map->heights.row(i).data(), row.data());
            in_row = i;
        }
        height = row[point % ny];
    }
}

/// Spikes whose removal does not lower the slopes belong to the surface, such as steps and grains.
void take_out_spikes(Evidence& evidence, parallel::Threads threads) {
    auto spikes = found_spikes(evidence, threads);
    if (spikes.count == 0) return;
    auto& heights = evidence.heights.heights;
    const double step = evidence.heights.pixel_size()[0], before = rms_slope_along_x(heights, step);
    auto others = heights_without(spikes, evidence);
    exchange(heights, others);
    const double after = rms_slope_along_x(heights, step);
    if (!(after < before)) {
        exchange(heights, others);
        evidence.rms_slope_x = before;
        return;
    }
    evidence.rms_slope_x = after;
    if (evidence.scars) recall_scars(others, evidence);
    evidence.spikes = std::move(spikes);
    evidence.at_spikes = std::move(others);
}

}  // namespace

void clean(Evidence& evidence, parallel::Threads threads) {
    auto& heights = evidence.heights.heights;
    const Index nx = heights.rows(), ny = heights.cols();
    if (evidence.scars) bridge_lines(heights, *evidence.scars);
    if (nx >= min_points && (evidence.is_line || ny >= min_points)) take_out_spikes(evidence, threads);
    const auto undefined_at = [&](const NewHeight& spike) { return std::isnan(heights.data()[spike.point]); };
    if (evidence.defined < nx * ny || std::any_of(evidence.at_spikes.begin(), evidence.at_spikes.end(), undefined_at)) {
        fill_along_lines(heights, threads);
        evidence.rms_slope_x.reset();
    } else {
        evidence.level_is_clean = !evidence.scars && !evidence.spikes;
    }
    if (nx >= min_points) evidence.scan_spectrum = scan_spectrum(evidence.heights, threads);
}

double clean_rms_height(const Evidence& evidence) {
    return evidence.level_is_clean ? evidence.form.rms_level : rms_height(evidence.heights.heights);
}

}  // namespace setae::diagnostics
