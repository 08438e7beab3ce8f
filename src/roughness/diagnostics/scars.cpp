// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/scars.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "evidence.hpp"
#include "patches.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"

namespace setae::diagnostics {
namespace {

/// Far above what a rough surface shows by itself: rms differences of neighbouring lines.
const processing::RemoveScars striking{.high = 2.0, .low = 2.0};

/// Without the median of each scan line, so that lines offset as a whole are no strokes.
topography::HeightMap aligned(topography::HeightMap map, parallel::Threads threads) {
    constexpr Index together = 16;  // lines lie across memory: neighbours are gathered side by side
    const Index blocks = (map.heights.cols() + together - 1) / together;
    parallel::for_each_index(static_cast<std::size_t>(blocks), threads, [&](std::size_t block) {
        const Index first = static_cast<Index>(block) * together,
                    count = std::min(together, map.heights.cols() - first);
        std::vector<std::vector<double>> lines(static_cast<std::size_t>(count));
        for (Index i = 0; i < map.heights.rows(); ++i)
            for (Index j = 0; j < count; ++j)
                if (const double h = map.heights(i, first + j); !std::isnan(h))
                    lines[static_cast<std::size_t>(j)].push_back(h);
        Eigen::Array<double, 1, Eigen::Dynamic> medians(count);
        for (Index j = 0; j < count; ++j) medians[j] = upper_median(std::move(lines[static_cast<std::size_t>(j)]));
        map.heights.middleCols(first, count).rowwise() -= medians;
    });
    return map;
}

}  // namespace

std::optional<topography::Mask> scar_points(const topography::HeightMap& map, parallel::Threads threads) {
    constexpr Index fewest = 32;
    if (map.heights.rows() < fewest || map.heights.cols() < fewest) return {};
    auto mask = processing::find_scars(striking, aligned(map, threads), threads);
    const Index points = mask.cast<Index>().sum();
    if (points == 0) return {};
    // ridges of the surface itself lie along y as often
    const topography::HeightMap turned{map.heights.transpose(), {map.size[1], map.size[0]}, map.periodic, {}};
    constexpr Index one_sided = 4;
    if (points <= one_sided * processing::find_scars(striking, aligned(turned, threads), threads).cast<Index>().sum())
        return {};
    return mask;
}

Found scars(const Evidence& evidence) {
    if (!evidence.scars) return {};
    const auto& mask = *evidence.scars;
    const Index points = mask.cast<Index>().sum();
    const auto strokes = patches(mask).count;
    const double share = static_cast<double>(points) / static_cast<double>(mask.size());
    const Array2D rest = (mask > 0).select(undefined, evidence.level.heights);
    const double with = rms_height(evidence.level.heights), without = rms_height(rest);
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
