// SPDX-License-Identifier: GPL-3.0-or-later
#include "mask_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "setae/imaging/contour_trace.hpp"

namespace setae::imaging {
namespace {

/// Directions of a walk along corners of pixels: right, down, left, up.
constexpr std::array<long, 4> side_x{1, 0, -1, 0}, side_y{0, 1, 0, -1};

/// Walks with vacuum on the left; a corner (x, y) is the upper left one of pixel (row y, column x).
class Walk {
public:
    explicit Walk(const PixelMask& sample)
        : sample_(sample),
          rows_(sample.rows()),
          columns_(sample.cols()),
          walked_(PixelMask::Zero(rows_ + 1, columns_ + 1)) {}

    std::vector<PlaneCurve> all() {
        std::vector<PlaneCurve> curves;
        for (const bool open : {true, false})  // open ones begin at the sides of the picture
            for (long y = 0; y <= rows_; ++y)
                for (long x = 0; x <= columns_; ++x)
                    for (int direction = 0; direction < 4; ++direction)
                        if (is_border(x, y, direction) && !was_walked(x, y, direction) &&
                            (!open || begins_at_side(x, y, direction)))
                            curves.push_back(from(x, y, direction, open));
        return curves;
    }

private:
    /// −1 outside the picture.
    [[nodiscard]] int label(long row, long column) const {
        return row < 0 || column < 0 || row >= rows_ || column >= columns_ ? -1 : sample_(row, column);
    }

    /// Whether vacuum is on the left and sample on the right of the step from a corner.
    [[nodiscard]] bool is_border(long x, long y, int direction) const {
        switch (direction) {
            case 0: return label(y - 1, x) == 0 && label(y, x) == 1;
            case 1: return label(y, x) == 0 && label(y, x - 1) == 1;
            case 2: return label(y, x - 1) == 0 && label(y - 1, x - 1) == 1;
            default: return label(y - 1, x - 1) == 0 && label(y - 1, x) == 1;
        }
    }

    [[nodiscard]] bool was_walked(long x, long y, int direction) const {
        return ((walked_(y, x) >> direction) & 1) != 0;
    }

    [[nodiscard]] static bool at_side(long x, long y, long columns, long rows) {
        return x == 0 || y == 0 || x == columns || y == rows;
    }

    /// No border leads to this corner.
    [[nodiscard]] bool begins_at_side(long x, long y, int) const {
        if (!at_side(x, y, columns_, rows_)) return false;
        for (int d = 0; d < 4; ++d) {
            const long from_x = x - side_x[d], from_y = y - side_y[d];
            if (from_x >= 0 && from_y >= 0 && from_x <= columns_ && from_y <= rows_ && is_border(from_x, from_y, d))
                return false;
        }
        return true;
    }

    PlaneCurve from(long x, long y, int direction, bool open) {
        std::vector<double> corner_x{static_cast<double>(x) - 0.5}, corner_y{static_cast<double>(y) - 0.5};
        const auto add = [&] {
            corner_x.push_back(static_cast<double>(x) - 0.5);
            corner_y.push_back(static_cast<double>(y) - 0.5);
        };
        const int first = direction;
        while (true) {
            walked_(y, x) = static_cast<std::uint8_t>(walked_(y, x) | (1 << direction));
            x += side_x[direction];
            y += side_y[direction];
            int next = -1;
            for (const int turn : {1, 0, 3}) {  // right first: parts of the sample that touch at a corner remain
                                                // separate
                const int candidate = (direction + turn) % 4;
                if (is_border(x, y, candidate) && !was_walked(x, y, candidate)) {
                    next = candidate;
                    break;
                }
            }
            if (next < 0) break;
            if (next != direction) add();
            direction = next;
        }
        if (open) add();
        else if (direction == first) {  // the walk began inside a straight part
            corner_x.erase(corner_x.begin());
            corner_y.erase(corner_y.begin());
        }
        PlaneCurve curve;
        curve.x = Eigen::Map<Array1D>(corner_x.data(), static_cast<Index>(corner_x.size()));
        curve.y = Eigen::Map<Array1D>(corner_y.data(), static_cast<Index>(corner_y.size()));
        curve.closed = !open;
        return curve;
    }

    const PixelMask& sample_;
    long rows_, columns_;
    PixelMask walked_;
};

}  // namespace

std::vector<PlaneCurve> outlines(const PixelMask& sample) {
    auto curves = Walk(sample).all();
    std::stable_sort(curves.begin(), curves.end(),
                     [](const auto& a, const auto& b) { return a.length() > b.length(); });
    return curves;
}

}  // namespace setae::imaging
