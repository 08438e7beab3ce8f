// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace setae::validation {
namespace {

constexpr double square = 8.0;  // px

}  // namespace

CurveIndex::CurveIndex(const simulation::PixelCurve& curve)
    : curve_(curve), left_(curve.x.minCoeff()), top_(curve.y.minCoeff()) {
    columns_ = static_cast<long>((curve.x.maxCoeff() - left_) / square) + 1;
    rows_ = static_cast<long>((curve.y.maxCoeff() - top_) / square) + 1;
    segments_.resize(static_cast<std::size_t>(columns_ * rows_));
    const auto column = [&](double x) { return static_cast<long>((x - left_) / square); };
    const auto row = [&](double y) { return static_cast<long>((y - top_) / square); };
    for (Index i = 0; i + 1 < curve.x.size(); ++i) {
        const auto [first_x, last_x] = std::minmax({column(curve.x[i]), column(curve.x[i + 1])});
        const auto [first_y, last_y] = std::minmax({row(curve.y[i]), row(curve.y[i + 1])});
        for (long r = first_y; r <= last_y; ++r)
            for (long c = first_x; c <= last_x; ++c) segments_[static_cast<std::size_t>(r * columns_ + c)].push_back(i);
    }
}

NearestPlace CurveIndex::nearest(double x, double y) const {
    NearestPlace best;
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](Index i) {
        const double along_x = curve_.x[i + 1] - curve_.x[i], along_y = curve_.y[i + 1] - curve_.y[i],
                     dx = x - curve_.x[i], dy = y - curve_.y[i];
        const double squared_length = along_x * along_x + along_y * along_y;
        const double share =
            squared_length > 0.0 ? std::clamp((dx * along_x + dy * along_y) / squared_length, 0.0, 1.0) : 0.0;
        const double off_x = dx - share * along_x, off_y = dy - share * along_y,
                     squared = off_x * off_x + off_y * off_y;
        if (squared >= least) return;
        least = squared;
        // y is downwards: smaller y are on the left of the direction of x
        best = {std::copysign(std::sqrt(squared), along_y * off_x - along_x * off_y), i, x - off_x, y - off_y};
    };
    const long column = static_cast<long>(std::floor((x - left_) / square)),
               row = static_cast<long>(std::floor((y - top_) / square));
    // rings of squares, until the next is further away than the nearest point found
    const long outside = std::max({0L, -column, column - columns_ + 1, -row, row - rows_ + 1});
    const long rings = std::max(columns_, rows_) + outside;
    for (long ring = outside; ring <= rings && static_cast<double>(ring - 1) * square <= std::sqrt(least); ++ring)
        for (long r = std::max(0L, row - ring); r <= std::min(rows_ - 1, row + ring); ++r) {
            const bool whole_row = std::abs(r - row) == ring;
            const long step = whole_row ? 1 : std::max(1L, 2 * ring);
            for (long c = column - ring; c <= column + ring; c += step)
                if (c >= 0 && c < columns_)
                    for (const Index i : segments_[static_cast<std::size_t>(r * columns_ + c)]) look(i);
        }
    return best;
}

Array1D length_along(const simulation::PixelCurve& curve) {
    Array1D along = Array1D::Zero(curve.x.size());
    for (Index i = 1; i < along.size(); ++i)
        along[i] = along[i - 1] + std::hypot(curve.x[i] - curve.x[i - 1], curve.y[i] - curve.y[i - 1]);
    return along;
}

}  // namespace setae::validation
