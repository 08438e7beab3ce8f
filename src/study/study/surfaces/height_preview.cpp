// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/height_preview.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "setae/core/constants.hpp"

namespace setae::study {
namespace {

/// Indices of the points of a line that are kept: every point, or the lowest and the highest of each section and both
/// ends.
std::vector<Index> kept_points(const Array1D& heights, Index max_points) {
    const Index n = heights.size();
    std::vector<Index> kept;
    if (n <= 2 * max_points) {
        for (Index i = 0; i < n; ++i) kept.push_back(i);
        return kept;
    }
    kept.push_back(0);
    for (Index stretch = 0; stretch < max_points; ++stretch) {
        const Index first = stretch * n / max_points, end = (stretch + 1) * n / max_points;
        Index lowest = -1, highest = -1;
        for (Index i = first; i < end; ++i) {
            if (std::isnan(heights[i])) continue;
            if (lowest < 0 || heights[i] < heights[lowest]) lowest = i;
            if (highest < 0 || heights[i] > heights[highest]) highest = i;
        }
        if (lowest < 0) lowest = highest = first;  // a gap stays one
        kept.push_back(std::min(lowest, highest));
        kept.push_back(std::max(lowest, highest));
    }
    kept.push_back(n - 1);
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    return kept;
}

HeightPreview line_preview(const Array1D& positions, const Array1D& heights, double size, Index max_points) {
    const auto kept = kept_points(heights, max_points);
    HeightPreview preview;
    preview.positions.resize(std::ssize(kept));
    preview.heights.resize(std::ssize(kept));
    for (Index i = 0; i < std::ssize(kept); ++i) {
        preview.positions[i] = positions[kept[static_cast<std::size_t>(i)]];
        preview.heights[i] = heights[kept[static_cast<std::size_t>(i)]];
    }
    preview.size = {size, 0.0};
    return preview;
}

}  // namespace

MapPreview::MapPreview(Index nx, Index ny, std::array<double, 2> size, Index max_pixels)
    : nx_(nx),
      ny_(ny),
      size_(size),
      sum_(Array2D::Zero(std::min(nx, max_pixels), std::min(ny, max_pixels))),
      count_(Array2D::Zero(sum_.rows(), sum_.cols())) {}

void MapPreview::add(const ArrayView2D& band, Index first) {
    const auto rows = sum_.rows(), columns = sum_.cols();
    for (Index row = 0; row < rows; ++row)
        for (Index i = row * nx_ / rows; i < (row + 1) * nx_ / rows; ++i)
            for (Index column = 0; column < columns; ++column) {
                const Index begin = std::max(column * ny_ / columns - first, Index{0}),
                            end = std::min((column + 1) * ny_ / columns - first, band.cols());
                for (Index j = begin; j < end; ++j) {
                    if (std::isnan(band(i, j))) continue;
                    sum_(row, column) += band(i, j);
                    count_(row, column) += 1.0;
                }
            }
}

HeightPreview MapPreview::result() const {
    HeightPreview preview;
    preview.map = (count_ > 0.0).select(sum_ / count_, undefined);
    preview.size = size_;
    return preview;
}

HeightPreview height_preview(const topography::Measurement& measurement, Index max_points, Index max_pixels) {
    return std::visit(
        [&](const auto& m) {
            using Kind = std::decay_t<decltype(m)>;
            if constexpr (std::is_same_v<Kind, topography::HeightMap>) {
                MapPreview preview(m.heights.rows(), m.heights.cols(), m.size, max_pixels);
                preview.add(m.heights, 0);
                return preview.result();
            } else if constexpr (std::is_same_v<Kind, topography::LineScan>) {
                const auto n = m.heights.size();
                return line_preview(Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)) * m.pixel_size(), m.heights,
                                    m.size, max_points);
            } else {
                return line_preview(m.positions, m.heights, m.size(), max_points);
            }
        },
        measurement);
}

}  // namespace setae::study
