// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::processing {

/// Penalties of a spline through equally spaced points: squares of first and of second differences.
struct SplineStiffness {
    double stretching = 0.0;  ///< β α²
    double bending = 0.0;     ///< (1 − β) α⁴
};

/// The w that minimises sum weights (h − w)² + stretching sum (Δw)² + bending sum (Δ²w)²; free ends, or wrapped
/// differences on periodic lines.
///
/// Rows of the least-squares problem are rotated into a banded triangle (Givens), which keeps twice the digits of the
/// five-diagonal system: the error is 1e-16 α² of the largest height instead of 1e-16 α⁴. A periodic line is folded, 0,
/// n−1, 1, n−2 …, which also gives a band. O(n); the rotations apply to any number of lines with the same weights.
class SmoothingSpline {
public:
    SmoothingSpline(const ArrayView1D& weights, const SplineStiffness& stiffness, bool periodic);

    /// Smooths n heights in place; those without weight are not used. All NaN if fewer points have weight than there
    /// are free modes.
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
        Index point;  ///< point whose height is on the right-hand side; −1: 0
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
