// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace setae::scales {

/// Moments of the points of a cell about their means: input of the best plane and of the union of cells.
struct CellMoments {
    double weight = 0.0;                  ///< points, or length
    double x = 0.0, y = 0.0, h = 0.0;     ///< means
    double xx = 0.0, xy = 0.0, yy = 0.0;  ///< sums of products about the means
    double xh = 0.0, yh = 0.0, hh = 0.0;

    /// Adds another cell. Source: Chan, Golub, LeVeque, Am. Stat. 37 (1983) 242.
    void add(const CellMoments& other) {
        if (!(other.weight > 0.0)) return;
        if (!(weight > 0.0)) {
            *this = other;
            return;
        }
        const double total = weight + other.weight, share = other.weight / total, reduced = weight * share;
        const double dx = other.x - x, dy = other.y - y, dh = other.h - h;
        xx += other.xx + reduced * dx * dx;
        xy += other.xy + reduced * dx * dy;
        yy += other.yy + reduced * dy * dy;
        xh += other.xh + reduced * dx * dh;
        yh += other.yh + reduced * dy * dh;
        hh += other.hh + reduced * dh * dh;
        x += share * dx;
        y += share * dy;
        h += share * dh;
        weight = total;
    }

    /// Residual sum of squares of the best plane; for points on one line (or at one place) that of the best line (or
    /// the mean).
    [[nodiscard]] double residual() const {
        const double determinant = xx * yy - xy * xy, trace = xx + yy;
        double explained = 0.0;
        if (determinant > 1e-12 * trace * trace)
            explained = (yy * xh * xh - 2.0 * xy * xh * yh + xx * yh * yh) / determinant;
        else if (trace > 0.0) explained = (xh * xh + yh * yh) / trace;
        return std::max(0.0, hh - explained);
    }
};

}  // namespace setae::scales
