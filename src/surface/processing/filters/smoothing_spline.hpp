// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::processing {

/// What a spline through equally spaced points pays for: squares of first and of second differences.
struct SplineStiffness {
    double stretching = 0.0;  ///< β α²
    double bending = 0.0;     ///< (1 − β) α⁴
};

/// The w that minimises sum weights (h − w)² + stretching sum (Δw)² + bending sum (Δ²w)²; free ends, or wrapped
/// differences on periodic lines.
///
/// Rows of the least-squares problem are rotated into a banded triangle (Givens), which keeps twice the digits of the
/// five-diagonal system: the error is 1e-16 α² of the largest height in place of 1e-16 α⁴. A periodic line is folded,
/// 0, n−1, 1, n−2 …, which makes it a band too. O(n); the rotations serve any number of lines with the same weights.
class SmoothingSpline {
public:
    SmoothingSpline(const ArrayView1D& weights, const SplineStiffness& stiffness, bool periodic);

    /// In place of n heights, of which those without weight are not looked at. All NaN where fewer points have weight
    /// than the free modes need.
    void smooth(double* heights) const;

private:
    struct Rotation {
        Index row;
        double cosine, sine;
    };
    /// A row of the problem: its coefficients at `band` places from `first` on.
    void insert(Index first, Array1D coefficients, double root_of_weight, Index point);
    [[nodiscard]] Index place(Index point) const;

    struct Inserted {
        Index point;  ///< whose height stands on the right; −1: 0
        double root_of_weight;
        std::size_t rotations_end;
    };
    Index points_, band_;
    bool folded_, determined_;
    Array1D weights_;
    Array2D triangle_;  ///< row k: coefficients at places k … k + band − 1
    std::vector<Inserted> inserted_;
    std::vector<Rotation> rotations_;
};

}  // namespace setae::processing
