// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "setae/crack_front/work_field.hpp"

namespace setae::crack_front {

/// Pinning force on the front on each line, linear between points: a w [J/m] on rays, w [J/m²] on parallels.
class PinningLines {
public:
    /// `repeats`: the line is periodic.
    PinningLines(Array2D forces, const LinePoints& points, bool repeats);

    struct Value {
        double force, slope;
    };

    [[nodiscard]] Index lines() const { return forces_.rows(); }
    [[nodiscard]] const LinePoints& points() const { return points_; }
    [[nodiscard]] Index cell(double x) const {
        return static_cast<Index>(std::floor((x - points_.first) / points_.spacing));
    }
    /// Begin of a cell; it ends at the begin of the next.
    [[nodiscard]] double begin(Index cell) const { return points_.at(cell); }
    [[nodiscard]] bool holds(Index cell) const { return repeats_ || (cell >= 0 && cell < points_.count - 1); }
    [[nodiscard]] Value at(Index line, double x, Index cell) const {
        const double* forces = forces_.row(line).data();
        const Index k = repeats_ ? wrapped(cell) : cell;
        const double left = forces[k], right = forces[repeats_ && k + 1 == points_.count ? 0 : k + 1];
        const double slope = (right - left) / points_.spacing;
        return {left + slope * (x - begin(cell)), slope};
    }
    /// ∫ force dx from the line's first point; the line does not repeat itself.
    [[nodiscard]] double integral(Index line, double x) const;

private:
    [[nodiscard]] Index wrapped(Index cell) const {
        const Index k = cell % points_.count;
        return k < 0 ? k + points_.count : k;
    }

    Array2D forces_, integrals_;
    LinePoints points_;
    bool repeats_;
};

}  // namespace setae::crack_front
