// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/scars.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "evidence.hpp"
#include "patches.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::diagnostics {
namespace {

/// Far above the usual differences of a rough surface: rms differences of neighbouring lines.
const processing::RemoveScars striking{.high = 2.0, .low = 2.0};

/// upper_median() of the defined ones of n heights; `room` has as many places. Only the few between two bounds of a
/// sample are used; if these exclude the median, all are used.
double upper_median_of(const double* heights, Index n, std::vector<double>& room) {
    constexpr Index sample_size = 64, margin = 14;
    const auto keep = [&](double low, double high) {
        Index below = 0, kept = 0, defined = 0;
        for (Index k = 0; k < n; ++k) {
            const double h = heights[k];
            room[static_cast<std::size_t>(kept)] = h;
            kept += static_cast<int>(h >= low) & static_cast<int>(h <= high);
            below += h < low;
            defined += !std::isnan(h);
        }
        return std::array<Index, 2>{kept, defined / 2 - below};
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low = -infinity, high = infinity;
    if (n > 4 * sample_size) {
        std::array<double, sample_size> sample;
        for (Index k = 0; k < sample_size; ++k) sample[static_cast<std::size_t>(k)] = heights[k * n / sample_size];
        const auto end = std::remove_if(sample.begin(), sample.end(), [](double h) { return std::isnan(h); });
        const auto size = end - sample.begin();
        std::sort(sample.begin(), end);
        if (size > 2 * margin) {
            low = sample[static_cast<std::size_t>(size / 2 - margin)];
            high = sample[static_cast<std::size_t>(size / 2 + margin - 1)];
        }
    }
    auto [kept, rank] = keep(low, high);
    if (rank < 0 || rank >= kept) std::tie(kept, rank) = std::tuple_cat(keep(-infinity, infinity));
    if (kept == 0) return 0.0;
    const auto middle = room.begin() + rank;
    std::nth_element(room.begin(), middle, room.begin() + kept);
    return *middle;
}

constexpr Index together = 16;  // lines are not contiguous: neighbours are processed together

/// Medians of the scan lines.
Array1D line_medians(const Array2D& heights, parallel::Threads threads) {
    const Index points = heights.rows(), lines = heights.cols(), blocks = (lines + together - 1) / together;
    Array1D medians(lines);
    parallel::for_each_index(static_cast<std::size_t>(blocks), threads, [&](std::size_t block) {
        const Index first = static_cast<Index>(block) * together, count = std::min(together, lines - first);
        Array2D gathered(count, points);
        std::vector<double> room(static_cast<std::size_t>(points));
        for (Index i = 0; i < points; ++i)
            for (Index j = 0; j < count; ++j) gathered(j, i) = heights(i, first + j);
        for (Index j = 0; j < count; ++j) medians[first + j] = upper_median_of(gathered.row(j).data(), points, room);
    });
    return medians;
}

/// Medians of the rows, points of one place along x.
Array1D row_medians(const Array2D& heights, parallel::Threads threads) {
    Array1D medians(heights.rows());
    numerics::by_row_blocks(numerics::RowBlocks(heights.rows(), heights.cols()), threads, std::vector<double>{},
                            [&](Index first, Index last, std::vector<double>& room) {
                                room.resize(static_cast<std::size_t>(heights.cols()));
                                for (Index i = first; i < last; ++i)
                                    medians[i] = upper_median_of(heights.row(i).data(), heights.cols(), room);
                                room = {};
                            });
    return medians;
}

/// Without the median of each scan line, so shifted lines are no strokes.
topography::Mask strokes_along_x(const Array2D& heights, parallel::Threads threads) {
    const Array1D medians = line_medians(heights, threads);
    const auto aligned = [&](Index first, Index last, double* room) -> const double* {
        const Index lines = heights.cols();
        for (Index i = first; i < last; ++i)
            Eigen::Map<Array1D>(room + (i - first) * lines, lines) = heights.row(i).transpose() - medians;
        return room;
    };
    return processing::find_scars(striking, {heights.rows(), heights.cols(), aligned}, threads);
}

/// Strokes along y: the same for the transposed map.
topography::Mask strokes_along_y(const Array2D& heights, parallel::Threads threads) {
    const Array1D medians = row_medians(heights, threads);
    const auto turned = [&](Index first, Index last, double* room) -> const double* {
        const Index points = heights.rows();
        for (Index i = 0; i < points; ++i)
            for (Index j = first; j < last; ++j) room[(j - first) * points + i] = heights(i, j) - medians[i];
        return room;
    };
    return processing::find_scars(striking, {heights.cols(), heights.rows(), turned}, threads);
}

}  // namespace

std::optional<topography::Mask> scar_points(const topography::HeightMap& map, parallel::Threads threads) {
    constexpr Index fewest = 32;
    if (map.heights.rows() < fewest || map.heights.cols() < fewest) return {};
    auto mask = strokes_along_x(map.heights, threads);
    const Index points = mask.cast<Index>().sum();
    if (points == 0) return {};
    // ridges of the surface are as frequent along y
    constexpr Index one_sided = 4;
    if (points <= one_sided * strokes_along_y(map.heights, threads).cast<Index>().sum()) return {};
    return mask;
}

Found scars(const Evidence& evidence) {
    if (!evidence.scars) return {};
    const auto& mask = *evidence.scars;
    const Index points = mask.cast<Index>().sum();
    const auto strokes = patches(mask).count;
    const double share = static_cast<double>(points) / static_cast<double>(mask.size());
    const double with = evidence.form.rms_level, without = rms_height_without(evidence.heights.heights, mask);
    return Finding{
        {"SCARS", evidence.subject,
         fmt::format("{} {} along the fast axis {} from the neighbouring lines, {:.2g} % of all points: the rms "
                     "height is {} with and {} without them",
                     strokes, strokes == 1 ? "stroke" : "deviates", strokes == 1 ? "deviate" : "stand", 100.0 * share,
                     length_text(with), length_text(without)),
         "remove the strokes (step remove_scars), or scan more slowly"},
        {effect_count("scars", strokes), effect_count("scar_points", points), effect("scar_share", "", share, "1"),
         effect("rms_height_with_scars", "h_rms", with, "m"),
         effect("rms_height_without_scars", "h_rms", without, "m")}};
}

}  // namespace setae::diagnostics
