// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_slopes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "setae/fourier/buffer.hpp"

namespace setae::processing {
namespace {

void fourier_slopes(const fourier::RealTransform& forward, const fourier::InverseRealTransform& back,
                    const double* heights, double* slopes) {
    const Index n = forward.points();
    thread_local fourier::Buffer<double> line;
    thread_local fourier::Buffer<fourier::Complex> modes;
    line.resize(static_cast<std::size_t>(n));
    modes.resize(static_cast<std::size_t>(forward.modes()));
    std::copy(heights, heights + n, line.begin());
    forward.forward(line.data(), modes.data());
    const double step =
        2.0 * std::numbers::pi / (static_cast<double>(n) * static_cast<double>(n));  // 2π/n, and 1/n of the transform
    for (Index k = 0; k < forward.modes(); ++k)
        modes[static_cast<std::size_t>(k)] *=
            2 * k == n ? fourier::Complex(0.0) : fourier::Complex(0.0, step * static_cast<double>(k));
    back.apply(modes.data(), line.data());
    std::copy(line.begin(), line.end(), slopes);
}

}  // namespace

LineSlopes::LineSlopes(Index points, bool periodic) : points_(points), periodic_(periodic) {
    if (!periodic) return;
    forward_.emplace(points);
    back_.emplace(points);
}

void LineSlopes::find(const double* heights, double* slopes) const {
    const Index n = points_;
    if (periodic_ && std::none_of(heights, heights + n, [](double height) { return std::isnan(height); })) {
        fourier_slopes(*forward_, *back_, heights, slopes);
        return;
    }
    const auto height = [&](Index i) {
        if (periodic_) return heights[((i % n) + n) % n];
        return i < 0 || i >= n ? std::nan("") : heights[i];
    };
    // from the point and those on one side, in steps of `to`.
    const auto one_sided = [&](Index i, Index to) {
        const double here = heights[i], near = height(i + to), far = height(i + 2 * to);
        const double slope = std::isnan(far) ? near - here : 0.5 * (4.0 * (near - here) - (far - here));
        return static_cast<double>(to) * slope;
    };
    for (Index i = 0; i < n; ++i) {
        const double before = height(i - 1), after = height(i + 1);
        if (!std::isnan(before) && !std::isnan(after)) slopes[i] = 0.5 * (after - before);
        else if (!std::isnan(after)) slopes[i] = one_sided(i, 1);
        else if (!std::isnan(before)) slopes[i] = one_sided(i, -1);
        else slopes[i] = 0.0;
    }
}

}  // namespace setae::processing
