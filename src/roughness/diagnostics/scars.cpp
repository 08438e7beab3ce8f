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

namespace setae::diagnostics {
namespace {

using topography::HeightMap;

/// Far above what a rough surface shows by itself: rms differences of neighbouring lines.
const processing::RemoveScars striking{.high = 2.0, .low = 2.0};

/// upper_median() of the defined ones of n heights; `room` has as many places. Those between two bounds of a sample are
/// few; where these miss the median, all are looked at.
double upper_median_of(const double* heights, Index n, std::vector<double>& room) {
    constexpr Index sample_size = 64, margin = 14;
    const auto keep = [&](double low, double high) {
        Index below = 0, kept = 0, defined = 0;
        for (Index k = 0; k < n; ++k) {
            const double h = heights[k];
            room[static_cast<std::size_t>(kept)] = h;
            kept += static_cast<int>(h >= low) & static_cast<int>(h <= high);
            below += h < low;
            defined += h == h;
        }
        return std::array<Index, 2>{kept, defined / 2 - below};
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low = -infinity, high = infinity;
    if (n > 4 * sample_size) {
        std::array<double, sample_size> sample;
        for (Index k = 0; k < sample_size; ++k) sample[static_cast<std::size_t>(k)] = heights[k * n / sample_size];
        const auto end = std::remove_if(sample.begin(), sample.end(), [](double h) { return h != h; });
        const auto size = end - sample.begin();
        std::sort(sample.begin(), end);
        if (size > 2 * margin)
            low = sample[static_cast<std::size_t>(size / 2 - margin)],
            high = sample[static_cast<std::size_t>(size / 2 + margin - 1)];
    }
    auto [kept, rank] = keep(low, high);
    if (rank < 0 || rank >= kept) std::tie(kept, rank) = std::tuple_cat(keep(-infinity, infinity));
    if (kept == 0) return 0.0;
    const auto middle = room.begin() + rank;
    std::nth_element(room.begin(), middle, room.begin() + kept);
    return *middle;
}

/// Without the median of each scan line, so that lines offset as a whole are no strokes.
HeightMap aligned(const HeightMap& map, parallel::Threads threads) {
    const auto [nx, ny] = map.shape();
    HeightMap result{Array2D(nx, ny), map.size, map.periodic, {}};
    constexpr Index together = 16;  // lines lie across memory: neighbours are gathered side by side
    const Index blocks = (ny + together - 1) / together;
    parallel::for_each_index(
        static_cast<std::size_t>(blocks), threads, [&, points = nx, lines = ny](std::size_t block) {
            const Index first = static_cast<Index>(block) * together, count = std::min(together, lines - first);
            Array2D gathered(count, points);
            std::vector<double> room(static_cast<std::size_t>(points));
            for (Index i = 0; i < points; ++i)
                for (Index j = 0; j < count; ++j) gathered(j, i) = map.heights(i, first + j);
            Eigen::Array<double, 1, Eigen::Dynamic> medians(count);
            for (Index j = 0; j < count; ++j) medians[j] = upper_median_of(gathered.row(j).data(), points, room);
            for (Index i = 0; i < points; ++i)
                for (Index j = 0; j < count; ++j) result.heights(i, first + j) = gathered(j, i) - medians[j];
        });
    return result;
}

/// The same of the map with rows for columns.
HeightMap turned_and_aligned(const HeightMap& map, parallel::Threads threads) {
    const auto [nx, ny] = map.shape();
    HeightMap result{Array2D(ny, nx), {map.size[1], map.size[0]}, map.periodic, {}};
    constexpr Index together = 16;
    const Index blocks = (nx + together - 1) / together;
    parallel::for_each_index(
        static_cast<std::size_t>(blocks), threads, [&, lines = nx, points = ny](std::size_t block) {
            const Index first = static_cast<Index>(block) * together, count = std::min(together, lines - first);
            std::vector<double> room(static_cast<std::size_t>(points));
            std::array<double, together> medians{};
            for (Index i = 0; i < count; ++i)
                medians[static_cast<std::size_t>(i)] = upper_median_of(map.heights.row(first + i).data(), points, room);
            for (Index j = 0; j < points; ++j)
                for (Index i = 0; i < count; ++i)
                    result.heights(j, first + i) = map.heights(first + i, j) - medians[static_cast<std::size_t>(i)];
        });
    return result;
}

}  // namespace

std::optional<topography::Mask> scar_points(const topography::HeightMap& map, parallel::Threads threads) {
    constexpr Index fewest = 32;
    if (map.heights.rows() < fewest || map.heights.cols() < fewest) return {};
    auto mask = processing::find_scars(striking, aligned(map, threads), threads);
    const Index points = mask.cast<Index>().sum();
    if (points == 0) return {};
    // ridges of the surface itself lie along y as often
    constexpr Index one_sided = 4;
    if (points <=
        one_sided * processing::find_scars(striking, turned_and_aligned(map, threads), threads).cast<Index>().sum())
        return {};
    return mask;
}

Found scars(const Evidence& evidence) {
    if (!evidence.scars) return {};
    const auto& mask = *evidence.scars;
    const Index points = mask.cast<Index>().sum();
    const auto strokes = patches(mask).count;
    const double share = static_cast<double>(points) / static_cast<double>(mask.size());
    const Array2D rest = (mask > 0).select(undefined, evidence.level->heights);
    const double with = evidence.rms_level, without = rms_height(rest);
    return Finding{
        {"SCARS", evidence.subject,
         fmt::format(
             "{} {} along the fast axis {} out of the lines beside, {:.2g} % of all points: rms height {} with and {} without them",
             strokes, strokes == 1 ? "stroke" : "strokes", strokes == 1 ? "stands" : "stand", 100.0 * share,
             length_text(with), length_text(without)),
         "remove them (level with a step remove_scars), or scan slower"},
        {effect_count("scars", strokes), effect_count("scar_points", points), effect("scar_share", "", share, "1"),
         effect("rms_height_with_scars", "h_rms", with, "m"),
         effect("rms_height_without_scars", "h_rms", without, "m")}};
}

}  // namespace setae::diagnostics
