// SPDX-License-Identifier: GPL-3.0-or-later
#include "height_bands.hpp"

#include <algorithm>
#include <variant>

namespace setae::topography {
namespace {

constexpr Index lines_of_band = 512;             ///< in memory: parts of a row that fill a page
constexpr std::size_t bytes_of_band = 64 << 20;  ///< for a map that is read for this purpose

HeightBands by_lines(Index nx, Index ny, Index together,
                     std::function<void(const std::function<void(std::size_t, const HeightBand&)>&)> for_each) {
    return {nx, ny, static_cast<std::size_t>((ny + together - 1) / together), std::move(for_each)};
}

}  // namespace

HeightBands bands_of(const Measurement& measurement, parallel::Threads threads) {
    return std::visit(
        [threads](const auto& m) {
            const double* const heights = m.heights.data();
            const bool is_map = m.heights.cols() > 1;
            const Index nx = m.heights.rows(), ny = is_map ? m.heights.cols() : 1;
            const auto count = static_cast<std::size_t>((ny + lines_of_band - 1) / lines_of_band);
            return by_lines(nx, ny, lines_of_band, [=](const auto& body) {
                parallel::for_each_index(count, threads, [&](std::size_t i) {
                    const Index first = static_cast<Index>(i) * lines_of_band;
                    body(i, HeightBand{heights + first, ny, first, std::min(lines_of_band, ny - first)});
                });
            });
        },
        measurement);
}

HeightBands bands_of(const TiledMap& map) {
    const Index together = lines_in(map, bytes_of_band);
    return by_lines(map.nx, map.ny, together, [&map, together](const auto& body) {
        for (Index first = 0; first < map.ny; first += together) {
            const auto heights = map.lines(first, std::min(together, map.ny - first));
            body(static_cast<std::size_t>(first / together),
                 HeightBand{heights.data(), heights.cols(), first, heights.cols()});
        }
    });
}

}  // namespace setae::topography
