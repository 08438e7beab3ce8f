// SPDX-License-Identifier: GPL-3.0-or-later
#include "smoothing_spline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include "setae/core/extent.hpp"

namespace setae::processing {
namespace {

struct Term {
    Index point;
    double coefficient;
};

}  // namespace

Index SmoothingSpline::place(Index point) const {
    if (!folded_) return point;
    return 2 * point < points_ ? 2 * point : 2 * (points_ - 1 - point) + 1;
}

SmoothingSpline::SmoothingSpline(const ArrayView1D& weights, const SplineStiffness& stiffness, bool periodic)
    : points_(weights.size()), band_(periodic && weights.size() > 2 ? 5 : 3), folded_(band_ == 5), weights_(weights) {
    const bool lines_are_free = !folded_ && stiffness.stretching == 0.0 && points_ > 2;
    determined_ = (weights > 0.0).count() >= (lines_are_free ? 2 : 1) && (points_ > 2 || (weights > 0.0).all());
    if (!determined_) return;
    triangle_.setZero(points_, band_);
    // rows wait for the last of their places, so only earlier rows of the triangle are involved
    std::vector<std::vector<std::vector<Term>>> waiting(extent(points_));
    const auto put = [&](std::vector<Term> row) {
        Index last = 0;
        for (Term& term : row) {
            term.point = place((term.point + points_) % points_);
            last = std::max(last, term.point);
        }
        waiting[extent(last)].push_back(std::move(row));
    };
    const double stretch = std::sqrt(stiffness.stretching), bend = std::sqrt(stiffness.bending);
    if (stretch > 0.0)
        for (Index i = folded_ ? 0 : 1; i < points_; ++i) put({{i - 1, -stretch}, {i, stretch}});
    if (bend > 0.0)
        for (Index i = folded_ ? 0 : 1; i < (folded_ ? points_ : points_ - 1); ++i)
            put({{i - 1, bend}, {i, -2.0 * bend}, {i + 1, bend}});
    std::vector<Index> point_at(extent(points_));
    for (Index i = 0; i < points_; ++i) point_at[extent(place(i))] = i;
    for (Index k = 0; k < points_; ++k) {
        const Index point = point_at[extent(k)];
        if (weights[point] > 0.0) insert(k, Array1D{{std::sqrt(weights[point])}}, std::sqrt(weights[point]), point);
        for (const auto& row : waiting[extent(k)]) {
            Index first = points_;
            for (const Term& term : row) first = std::min(first, term.point);
            Array1D coefficients = Array1D::Zero(k - first + 1);
            for (const Term& term : row) coefficients[term.point - first] += term.coefficient;
            insert(first, std::move(coefficients), 0.0, -1);
        }
    }
}

void SmoothingSpline::insert(Index first, Array1D coefficients, double root_of_weight, Index point) {
    for (Index n = 0; n < coefficients.size(); ++n) {
        const double value = coefficients[n];
        if (value == 0.0) continue;
        const Index k = first + n;
        const double length = std::hypot(triangle_(k, 0), value), cosine = triangle_(k, 0) / length,
                     sine = value / length;
        for (Index m = n; m < coefficients.size(); ++m) {
            const double upper = triangle_(k, m - n), lower = coefficients[m];
            triangle_(k, m - n) = cosine * upper + sine * lower;
            coefficients[m] = cosine * lower - sine * upper;
        }
        rotations_.push_back({k, cosine, sine});
    }
    inserted_.push_back({point, root_of_weight, rotations_.size()});
}

void SmoothingSpline::smooth(double* heights) const {
    if (!determined_) {
        std::fill(heights, heights + points_, std::numeric_limits<double>::quiet_NaN());
        return;
    }
    double sum = 0.0, weight = 0.0;
    for (Index i = 0; i < points_; ++i)
        if (weights_[i] > 0.0) {
            sum += weights_[i] * heights[i];
            weight += weights_[i];
        }
    const double centre = sum / weight;
    Array1D right = Array1D::Zero(points_);
    std::size_t next = 0;
    for (const Inserted& row : inserted_) {
        double value = row.point >= 0 ? row.root_of_weight * (heights[row.point] - centre) : 0.0;
        for (; next < row.rotations_end; ++next) {
            const Rotation& turn = rotations_[next];
            const double upper = right[turn.row];
            right[turn.row] = turn.cosine * upper + turn.sine * value;
            value = turn.cosine * value - turn.sine * upper;
        }
    }
    for (Index k = points_ - 1; k >= 0; --k) {
        double value = right[k];
        for (Index m = 1; m < std::min(band_, points_ - k); ++m) value -= triangle_(k, m) * right[k + m];
        right[k] = value / triangle_(k, 0);
    }
    for (Index i = 0; i < points_; ++i) heights[i] = centre + right[place(i)];
}

}  // namespace setae::processing
