// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/workflow/height_preview.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "setae/core/constants.hpp"

namespace setae::workflow {
namespace {

/// Indices of what is kept of a line: every point, or the lowest and the highest of each stretch and both ends.
std::vector<Index> kept_points(const Array1D& heights, Index most_points) {
    const Index n = heights.size();
    std::vector<Index> kept;
    if (n <= 2 * most_points) {
        for (Index i = 0; i < n; ++i) kept.push_back(i);
        return kept;
    }
    kept.push_back(0);
    for (Index stretch = 0; stretch < most_points; ++stretch) {
        const Index first = stretch * n / most_points, end = (stretch + 1) * n / most_points;
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

HeightPreview line_preview(const Array1D& positions, const Array1D& heights, double size, Index most_points) {
    const auto kept = kept_points(heights, most_points);
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

double mean_of_defined(const Array2D& heights, Index row, Index rows, Index column, Index columns) {
    double sum = 0.0;
    Index count = 0;
    for (Index i = row; i < row + rows; ++i)
        for (Index j = column; j < column + columns; ++j)
            if (!std::isnan(heights(i, j))) {
                sum += heights(i, j);
                ++count;
            }
    return count > 0 ? sum / static_cast<double>(count) : undefined;
}

HeightPreview map_preview(const topography::HeightMap& map, Index most_pixels) {
    const auto [nx, ny] = map.shape();
    const Index rows = std::min(nx, most_pixels), columns = std::min(ny, most_pixels);
    HeightPreview preview;
    preview.map.resize(rows, columns);
    for (Index i = 0; i < rows; ++i)
        for (Index j = 0; j < columns; ++j) {
            const Index row = i * nx / rows, column = j * ny / columns;
            preview.map(i, j) = mean_of_defined(map.heights, row, (i + 1) * nx / rows - row, column, (j + 1) * ny / columns - column);
        }
    preview.size = map.size;
    return preview;
}

}  // namespace

HeightPreview height_preview(const topography::Measurement& measurement, Index most_points, Index most_pixels) {
    return std::visit(
        [&](const auto& m) {
            using Kind = std::decay_t<decltype(m)>;
            if constexpr (std::is_same_v<Kind, topography::HeightMap>) {
                return map_preview(m, most_pixels);
            } else if constexpr (std::is_same_v<Kind, topography::LineScan>) {
                const auto n = m.heights.size();
                return line_preview(Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)) * m.pixel_size(), m.heights, m.size, most_points);
            } else {
                return line_preview(m.positions, m.heights, m.size(), most_points);
            }
        },
        measurement);
}

}  // namespace setae::workflow
