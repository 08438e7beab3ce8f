// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "mean_line.hpp"
#include "oriented_curve.hpp"
#include "setae/core/constants.hpp"

namespace setae::topography {
namespace {

/// The same direction as an angle in −π … π.
double wrapped(double angle) { return std::remainder(angle, 2.0 * pi); }

}  // namespace

ParametricStatistics parametric_statistics(const TracedCurve& curve) {
    auto kept = distinct_points(curve);
    if (curve.closed && kept.size() > 2) kept.push_back(kept.front());
    const Array1D x = curve.x(kept), y = curve.y(kept);
    const auto line = mean_line(x, y);
    const auto along = lengths_along(x, y);
    const Index segments = x.size() - 1;
    const double chord = std::hypot(x[segments] - x[0], y[segments] - y[0]);

    ParametricStatistics statistics;
    statistics.length = line.length;
    statistics.tortuosity = chord > 0.0 ? line.length / chord : undefined;
    statistics.rms_normal_distance = std::sqrt(line.mean_square_distance);
    statistics.reentrant_share = levelled(curve, Reentrance::envelope).reentrant_share;

    const auto direction = [&](Index i) { return std::atan2(y[i + 1] - y[i], x[i + 1] - x[i]); };
    double angles = 0.0, turns = 0.0, turned_length = 0.0;
    for (Index i = 0; i < segments; ++i)
        angles += std::pow(wrapped(direction(i) - line.angle), 2) * (along[i + 1] - along[i]);
    const auto turn = [&](Index before, Index after, double length) {
        turns += std::pow(wrapped(direction(after) - direction(before)), 2) / length;
        turned_length += length;
    };
    for (Index i = 1; i < segments; ++i) turn(i - 1, i, 0.5 * (along[i + 1] - along[i - 1]));
    if (curve.closed && segments > 1) turn(segments - 1, 0, 0.5 * (along[1] + along[segments] - along[segments - 1]));
    statistics.rms_angle = std::sqrt(angles / line.length);
    statistics.rms_curvature = turned_length > 0.0 ? std::sqrt(turns / turned_length) : 0.0;
    return statistics;
}

}  // namespace setae::topography
