// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "setae/imaging/contour_trace.hpp"

namespace setae::imaging::tests {

using Mask = Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The mask a binary picture's outlines enclose: 1 sample, 0 vacuum. Inverse of tracing such a picture.
inline Mask enclosed(const std::vector<ContourSegment>& outlines, long width, long height) {
    // each upright side of a pixel that is walked says what lies right of it; what lies left of the first one is the
    // other
    constexpr std::uint8_t vacuum = 0, sample = 1, unknown = 2;
    Mask right_of = Mask::Constant(height, width + 1, unknown), below = Mask::Constant(height + 1, width, unknown);
    for (const auto& outline : outlines) {
        const Index n = outline.x.size();
        for (Index i = 0; i + (outline.closed ? 0 : 1) < n; ++i) {
            const auto x0 = std::lround(outline.x[i] + 0.5), y0 = std::lround(outline.y[i] + 0.5),
                       x1 = std::lround(outline.x[(i + 1) % n] + 0.5), y1 = std::lround(outline.y[(i + 1) % n] + 0.5);
            for (long y = std::min(y0, y1); x0 == x1 && y < std::max(y0, y1); ++y)
                right_of(y, x0) = y1 > y0 ? vacuum : sample;
            for (long x = std::min(x0, x1); y0 == y1 && x < std::max(x0, x1); ++x)
                below(y0, x) = x1 > x0 ? sample : vacuum;
        }
    }
    Mask mask(height, width);
    for (long row = 0; row < height; ++row) {
        std::uint8_t state = unknown;
        for (long column = 1; column < width && state == unknown; ++column)
            if (right_of(row, column) != unknown) state = static_cast<std::uint8_t>(1 - right_of(row, column));
        if (state == unknown) state = below(row, 0) != unknown ? below(row, 0) : row > 0 ? mask(row - 1, 0) : vacuum;
        for (long column = 0; column < width; ++column) {
            if (column > 0 && right_of(row, column) != unknown) state = right_of(row, column);
            mask(row, column) = state;
        }
    }
    // rows above the first border take the state of what lies above that border
    long first = 0;
    while (first < height && (right_of.row(first) == unknown).all() && (below.row(first) == unknown).all()) ++first;
    if (first < height && first > 0 && (below.row(first) != unknown).any()) {
        Index at = 0;
        (below.row(first) != unknown).cast<int>().maxCoeff(&at);
        mask.topRows(first).setConstant(static_cast<std::uint8_t>(1 - below(first, at)));
    }
    return mask;
}

}  // namespace setae::imaging::tests
