// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon_coverage.hpp"

#include <algorithm>
#include <cmath>

namespace setae::simulation {
namespace {

/// A place in units of pixels from the window's left upper corner.
struct Place {
    double across, down;
};

/// Areas of a curve's segments in each pixel and, in the row below, in all pixels further down.
class SignedAreas {
public:
    explicit SignedAreas(const PixelWindow& window)
        : rows_(window.height), columns_(window.width), steps_(Array2D::Zero(window.height + 1, window.width)) {}

    void add(Place from, Place to) {
        if (from.across == to.across) return;
        const double sign = to.across > from.across ? 1.0 : -1.0;
        if (sign < 0.0) std::swap(from, to);
        const double slope = (to.down - from.down) / (to.across - from.across);
        const auto [lower, upper] = std::minmax(from.down, to.down);
        const double low = lower, high = upper;
        const auto down = [&](double across) {
            return std::clamp(from.down + slope * (across - from.across), low, high);
        };
        double begin = std::max(from.across, 0.0);
        const double end = std::min(to.across, static_cast<double>(columns_));
        for (long column = static_cast<long>(begin); begin < end; ++column) {
            const double next = std::min(end, static_cast<double>(column + 1));
            add_in_column(column, sign * (next - begin), down(begin), down(next));
            begin = next;
        }
    }

    [[nodiscard]] Array2D summed() && {
        for (long row = 1; row < rows_; ++row) steps_.row(row) += steps_.row(row - 1);
        return steps_.topRows(rows_);
    }

private:
    void add_in_column(long column, double width, double one, double other) {
        const double begin = std::min(one, other), end = std::max(one, other);
        const double bottom = static_cast<double>(rows_);
        if (begin >= bottom) return;
        // a segment above the window covers the whole column
        if (end <= 0.0) {
            steps_(0, column) += width;
            return;
        }
        const double per_row = end > begin ? width / (end - begin) : 0.0;
        if (begin < 0.0) steps_(0, column) -= per_row * begin;
        for (long row = static_cast<long>(std::max(begin, 0.0)); row < rows_ && static_cast<double>(row) <= end;
             ++row) {
            const double top = std::max(begin, static_cast<double>(row)),
                         under = std::min(end, static_cast<double>(row + 1));
            const double part = end > begin ? per_row * (under - top) : width;
            const double middle = 0.5 * (top + under) - static_cast<double>(row);
            steps_(row, column) += part * (1.0 - middle);
            steps_(row + 1, column) += part * middle;
        }
    }

    long rows_, columns_;
    Array2D steps_;
};

Place place_of(const PixelCurve& curve, Index point, const PixelWindow& window) {
    return {curve.x[point] - static_cast<double>(window.left) + 0.5,
            curve.y[point] - static_cast<double>(window.top) + 0.5};
}

/// The curve's segments with a horizontal one at either end, outside the window.
template <class Body>
void for_each_segment(const PixelCurve& curve, const PixelWindow& window, Body body) {
    const Index n = curve.x.size();
    const Place first = place_of(curve, 0, window), last = place_of(curve, n - 1, window);
    const double beyond = static_cast<double>(window.width) + 1.0;
    if (first.across > 0.0) body(Place{-1.0, first.down}, first);
    for (Index i = 1; i < n; ++i) body(place_of(curve, i - 1, window), place_of(curve, i, window));
    if (last.across < beyond) body(last, Place{beyond, last.down});
}

/// Squared distances to one short segment, where they are the least so far.
void lower_to_segment(Array2D& squared, const Place& from, const Place& to, double reach) {
    const double along_x = to.across - from.across, along_y = to.down - from.down;
    const double length_squared = along_x * along_x + along_y * along_y;
    // centres of pixels are half a pixel from the corner
    const auto first = [&](double one, double other) {
        return std::max(0L, static_cast<long>(std::ceil(std::min(one, other) - reach - 0.5)));
    };
    const auto last = [&](double one, double other, Index size) {
        return std::min(static_cast<long>(size) - 1, static_cast<long>(std::floor(std::max(one, other) + reach - 0.5)));
    };
    const long first_column = first(from.across, to.across), last_column = last(from.across, to.across, squared.cols());
    const long first_row = first(from.down, to.down), last_row = last(from.down, to.down, squared.rows());
    for (long row = first_row; row <= last_row; ++row) {
        const double dy = static_cast<double>(row) + 0.5 - from.down;
        for (long column = first_column; column <= last_column; ++column) {
            const double dx = static_cast<double>(column) + 0.5 - from.across;
            const double share =
                length_squared > 0.0 ? std::clamp((dx * along_x + dy * along_y) / length_squared, 0.0, 1.0) : 0.0;
            const double off_x = dx - share * along_x, off_y = dy - share * along_y;
            double& least = squared(row, column);
            least = std::min(least, off_x * off_x + off_y * off_y);
        }
    }
}

/// Signed crossings of the line from above to each pixel's centre: 1 below the curve, 0 above.
Array2D crossings_above(const PixelCurve& curve, const PixelWindow& window) {
    Array2D count = Array2D::Zero(window.height, window.width);
    for_each_segment(curve, window, [&](const Place& from, const Place& to) {
        const double left = std::min(from.across, to.across), right = std::max(from.across, to.across);
        const double sign = to.across > from.across ? 1.0 : -1.0;
        // columns with their centre in (left, right]
        const long first = std::max(0L, static_cast<long>(std::floor(left - 0.5)) + 1),
                   last = std::min(window.width - 1, static_cast<long>(std::floor(right - 0.5)));
        for (long column = first; column <= last; ++column) {
            const double down = from.down + (to.down - from.down) * (static_cast<double>(column) + 0.5 - from.across) /
                                                (to.across - from.across);
            const long row = std::max(0L, static_cast<long>(std::ceil(down - 0.5)));
            if (row < window.height) count(row, column) += sign;
        }
    });
    for (long row = 1; row < window.height; ++row) count.row(row) += count.row(row - 1);
    return count;
}

}  // namespace

Array2D coverage_below(const PixelCurve& curve, const PixelWindow& window) {
    SignedAreas areas(window);
    for_each_segment(curve, window, [&](const Place& from, const Place& to) { areas.add(from, to); });
    return std::move(areas).summed();
}

Array2D signed_distance(const PixelCurve& curve, const PixelWindow& window, double reach) {
    Array2D squared = Array2D::Constant(window.height, window.width, reach * reach);
    constexpr double piece = 8.0;  // px: of a long one the surroundings would be the whole picture
    for_each_segment(curve, window, [&](const Place& from, const Place& to) {
        const double length = std::hypot(to.across - from.across, to.down - from.down);
        const long pieces = 1 + static_cast<long>(length / piece);
        const auto at = [&](long k) {
            const double share = static_cast<double>(k) / static_cast<double>(pieces);
            return Place{from.across + share * (to.across - from.across), from.down + share * (to.down - from.down)};
        };
        for (long k = 0; k < pieces; ++k) lower_to_segment(squared, at(k), at(k + 1), reach);
    });
    return squared.sqrt() * (1.0 - 2.0 * crossings_above(curve, window));
}

}  // namespace setae::simulation
