// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_curve.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace setae::imaging {
namespace {

Array1D smoothed(const PlaneCurve& curve, const Array1D& values, double deviation) {
    const Index n = values.size(), reach = static_cast<Index>(std::ceil(4 * deviation));
    std::vector<double> kernel;
    double sum = 0;
    for (Index j = -reach; j <= reach; ++j) {
        kernel.push_back(std::exp(-0.5 * static_cast<double>(j * j) / (deviation * deviation)));
        sum += kernel.back();
    }
    const auto value = [&](Index i) {
        if (curve.closed) return values[((i % n) + n) % n];
        if (i < 0) return 2 * values[0] - values[std::min(-i, n - 1)];
        if (i >= n) return 2 * values[n - 1] - values[std::max(2 * (n - 1) - i, Index{0})];
        return values[i];
    };
    Array1D result(n);
    for (Index i = 0; i < n; ++i) {
        double total = 0;
        for (Index j = -reach; j <= reach; ++j) total += kernel[static_cast<std::size_t>(j + reach)] * value(i + j);
        result[i] = total / sum;
    }
    return result;
}

}  // namespace

double PlaneCurve::length() const {
    double sum = 0;
    for (Index i = 1; i < x.size(); ++i) sum += std::hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
    if (closed && x.size() > 1) sum += std::hypot(x[0] - x[x.size() - 1], y[0] - y[y.size() - 1]);
    return sum;
}

Index PlaneCurve::at(Index i) const {
    const Index n = size();
    return closed ? ((i % n) + n) % n : std::clamp(i, Index{0}, n - 1);
}

Normals normals(const PlaneCurve& curve) {
    const Index n = curve.size();
    Normals found{Array1D(n), Array1D(n)};
    for (Index i = 0; i < n; ++i) {
        const Index before = curve.at(i - 1), after = curve.at(i + 1);
        const double dx = curve.x[after] - curve.x[before], dy = curve.y[after] - curve.y[before],
                     length = std::max(1e-300, std::hypot(dx, dy));
        found.x[i] = dy / length;
        found.y[i] = -dx / length;
    }
    return found;
}

PlaneCurve resampled(const PlaneCurve& curve, double step, bool smooth) {
    const Index n = curve.size(), pieces = curve.closed ? n : n - 1;
    std::vector<double> along{0.0};
    for (Index i = 0; i < pieces; ++i)
        along.push_back(along.back() +
                        std::hypot(curve.x[curve.at(i + 1)] - curve.x[i], curve.y[curve.at(i + 1)] - curve.y[i]));
    const double length = along.back();
    const auto count =
        std::max<Index>(curve.closed ? 4 : 2, static_cast<Index>(std::lround(length / step)) + (curve.closed ? 0 : 1));
    const double pace = length / static_cast<double>(curve.closed ? count : count - 1);
    PlaneCurve result{Array1D(count), Array1D(count), curve.closed};
    std::size_t piece = 0;
    for (Index k = 0; k < count; ++k) {
        const double target = std::min(length, pace * static_cast<double>(k));
        while (piece + 2 < along.size() && along[piece + 1] < target) ++piece;
        const auto i = static_cast<Index>(piece);
        const double span = along[piece + 1] - along[piece],
                     t = span > 0 ? std::clamp((target - along[piece]) / span, 0.0, 1.0) : 0.0;
        const Index a = curve.at(i - 1), b = curve.at(i), c = curve.at(i + 1), d = curve.at(i + 2);
        const auto between = [&](const Array1D& v) {
            if (!smooth) return v[b] + t * (v[c] - v[b]);
            // ends continue in a straight line
            const double before = a == b ? 2 * v[b] - v[c] : v[a], beyond = d == c ? 2 * v[c] - v[b] : v[d];
            return v[b] +
                   0.5 * t *
                       (v[c] - before +
                        t * (2 * before - 5 * v[b] + 4 * v[c] - beyond + t * (3 * (v[b] - v[c]) + beyond - before)));
        };
        result.x[k] = between(curve.x);
        result.y[k] = between(curve.y);
    }
    return result;
}

PlaneCurve smoothed(const PlaneCurve& curve, double deviation) {
    return {smoothed(curve, curve.x, deviation), smoothed(curve, curve.y, deviation), curve.closed};
}

}  // namespace setae::imaging
