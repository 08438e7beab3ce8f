// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include "height_locator.hpp"
#include "setae/texture/material_ratio.hpp"

namespace setae::texture {

/// A triangle by the heights of its corners, a <= b <= c, and the number of heights of the locator at or below each.
struct Triangle {
    double a, b, c;
    int below_a, below_b, below_c;
};

/// A straight segment, a <= c, or a point, a = c, with a weight.
struct Segment {
    double a, c, weight;
    int below_a, below_c;
};

/// Calls visitor(Triangle) for the triangles between rows first … last − 1 of a map and the next rows.
template <class Visitor>
void visit_triangles(const topography::HeightMap& map, Index first, Index last, const HeightLocator& locate,
                     Visitor& visitor) {
    const auto nx = map.heights.rows(), ny = map.heights.cols();
    const auto columns = map.periodic ? ny : ny - 1;
    std::vector<int> lower_below(static_cast<std::size_t>(ny)), upper_below(static_cast<std::size_t>(ny));
    const auto locate_row = [&](Index i, std::vector<int>& below) {
        const double* row = map.heights.data() + i * ny;
        for (Index j = 0; j < ny; ++j) below[static_cast<std::size_t>(j)] = locate(row[j]);
    };
    locate_row(first, lower_below);
    for (Index i = first; i < last; ++i) {
        const auto above = i + 1 == nx ? 0 : i + 1;
        locate_row(above, upper_below);
        const double* lower = map.heights.data() + i * ny;
        const double* upper = map.heights.data() + above * ny;
        const int* lower_k = lower_below.data();
        const int* upper_k = upper_below.data();
        for (Index j = 0; j < columns; ++j) {
            const auto next = j + 1 == ny ? 0 : j + 1;
            const int k_x = upper_k[j], k_y = lower_k[next];
            if ((k_x | k_y) < 0) continue;
            const double low = std::min(upper[j], lower[next]), high = std::max(upper[j], lower[next]);
            const int k_low = std::min(k_x, k_y), k_high = std::max(k_x, k_y);
            const auto corner = [&](double h, int k) {
                if (k < 0) return;
                visitor(Triangle{std::min(low, h), std::max(low, std::min(high, h)), std::max(high, h),
                                 std::min(k_low, k), std::max(k_low, std::min(k_high, k)), std::max(k_high, k)});
            };
            corner(lower[j], lower_k[j]);
            corner(upper[next], upper_k[next]);
        }
        std::swap(lower_below, upper_below);
    }
}

/// Calls visitor(Segment) for points first … last − 1 of a series, each separately.
template <class Visitor>
void visit_points(const double* heights, Index first, Index last, const HeightLocator& locate, Visitor& visitor) {
    for (Index i = first; i < last; ++i)
        if (const int k = locate(heights[i]); k >= 0) visitor(Segment{heights[i], heights[i], 1.0, k, k});
}

/// Calls visitor(Segment) for the segments of a line; weight(i) is the length of segment i.
template <class Visitor, class Weight>
void visit_segments(const Array1D& heights, bool periodic, const HeightLocator& locate, Visitor& visitor,
                    Weight weight) {
    const auto n = heights.size();
    for (Index i = 0; i < (periodic ? n : n - 1); ++i) {
        const double left = heights[i], right = heights[i + 1 == n ? 0 : i + 1];
        const int k_left = locate(left), k_right = locate(right);
        if ((k_left | k_right) >= 0)
            visitor(Segment{std::min(left, right), std::max(left, right), weight(i), std::min(k_left, k_right),
                            std::max(k_left, k_right)});
    }
}

struct Range {
    double lowest = 0.0;
    double highest = 0.0;
};

/// The elements of a measurement in blocks that do not depend on threads.
class Elements {
public:
    /// @throws InvalidArgument for points of a polyline, or a re-entrant one.
    Elements(const MeasurementView& measurement, Between between);

    /// Number of blocks; sums over blocks are added in their order.
    [[nodiscard]] std::size_t blocks() const { return blocks_; }

    template <class Visitor>
    void visit(std::size_t block, const HeightLocator& locate, Visitor& visitor) const {
        const auto first = static_cast<Index>(block) * block_size_, last = std::min(count_, first + block_size_);
        measurement_.visit([&](const auto& m) {
            using Kind = std::decay_t<decltype(m)>;
            if (between_ == Between::nothing) visit_points(m.heights.data(), first, last, locate, visitor);
            else if constexpr (std::is_same_v<Kind, topography::HeightMap>)
                visit_triangles(m, first, last, locate, visitor);
            else if constexpr (std::is_same_v<Kind, topography::LineScan>)
                visit_segments(m.heights, m.periodic, locate, visitor, [](Index) { return 1.0; });
            else
                visit_segments(m.heights, false, locate, visitor,
                               [&m](Index i) { return m.positions[i + 1] - m.positions[i]; });
        });
    }

    /// Lowest and highest defined point: the range of all elements.
    /// @throws UndefinedDataError if none is defined.
    [[nodiscard]] Range range() const;

    /// @throws UndefinedDataError if no element is defined, that is, the weight is 0.
    void require_weight(double weight) const;

private:
    MeasurementView measurement_;
    Between between_;
    Index count_ = 1;  ///< rows of triangles, points, or 1 for all segments
    Index block_size_ = 1;
    std::size_t blocks_ = 1;
};

}  // namespace setae::texture
