// SPDX-License-Identifier: GPL-3.0-or-later
#include "gaussian_axis.hpp"

#include <algorithm>
#include <cmath>

namespace setae::processing {
namespace {

/// Where a Gaussian ends, in its own deviations.
const double reach = 4.0 * std::sqrt(2.0);
/// Narrower Gaussians [pixels] are summed directly.
constexpr double widest_direct = 3.0;

struct Direct {
    explicit Direct(GaussianAxis& axis, double deviation, Index orders) {
        const Index half = static_cast<Index>(std::ceil(reach * deviation));
        axis.direct = true;
        axis.coarse = axis.points;
        axis.taps = 2 * half + 1;
        for (Index q = 0; q <= orders; ++q) axis.gather.emplace_back(axis.points, axis.taps);
        for (Index t = 0; t < axis.taps; ++t) {
            const double offset = deviation > 0.0 ? static_cast<double>(t - half) / deviation : 0.0;
            double weight = std::exp(-0.5 * offset * offset);
            for (Index q = 0; q <= orders; ++q, weight *= offset)
                axis.gather[static_cast<std::size_t>(q)].col(t) = weight;
        }
        for (Index i = 0; i < axis.points; ++i) axis.first_tap.push_back(i - half);
        axis.coordinate.setZero(axis.points);
    }
};

struct Coarse {
    GaussianAxis& axis;
    double deviation, step, origin = 0.0;
    Index orders, half;

    Coarse(GaussianAxis& target, double width, Index highest)
        : axis(target), deviation(width), step(0.5 * width), orders(highest) {
        const auto n = static_cast<double>(axis.points);
        if (axis.periodic) {
            axis.coarse = static_cast<Index>(std::ceil(n / step));
            step = n / static_cast<double>(axis.coarse);
        }
        half = static_cast<Index>(std::ceil(4.0 * deviation / step));
        if (!axis.periodic) {
            origin = -static_cast<double>(half) * step;
            axis.coarse = static_cast<Index>(std::floor((n - 1.0 - origin) / step)) + half + 1;
        }
        axis.taps = 2 * half;
        axis.shares = 2 * half + 1;
        axis.coordinate.resize(axis.points);
        for (Index k = 0; k <= orders; ++k) {
            axis.share.emplace_back(axis.points, axis.shares);
            axis.gather.emplace_back(axis.points, axis.taps);
        }
        for (Index i = 0; i < axis.points; ++i) tabulate(i);
    }

    void tabulate(Index i) {
        const double place = (static_cast<double>(i) - origin) / step;  // in coarse steps
        const auto below = static_cast<Index>(std::floor(place));
        axis.coordinate[i] = (place - static_cast<double>(below)) * step / deviation;
        axis.first_tap.push_back(below - half + 1);
        for (Index t = 0; t < axis.taps; ++t) {
            const double from_reference = static_cast<double>(t - half + 1) * step / deviation;
            const double distance = axis.coordinate[i] - from_reference;
            double weight = std::exp(-distance * distance);
            for (Index q = 0; q <= orders; ++q, weight *= from_reference)
                axis.gather[static_cast<std::size_t>(q)](i, t) = weight;
        }
        const auto first = static_cast<Index>(std::ceil(place)) - half;
        axis.first_share.push_back(first);
        for (Index s = 0; s < axis.shares; ++s) {
            const double distance = (place - static_cast<double>(first + s)) * step / deviation;
            double weight = std::abs(distance) * deviation <= static_cast<double>(half) * step
                                ? std::exp(-distance * distance)
                                : 0.0;
            for (Index m = 0; m <= orders; ++m, weight *= distance)
                axis.share[static_cast<std::size_t>(m)](i, s) = weight;
        }
    }
};

}  // namespace

GaussianAxis::GaussianAxis(Index number, double deviation, bool wraps, Index orders) : points(number), periodic(wraps) {
    if (deviation <= widest_direct) Direct(*this, deviation, orders);
    else Coarse(*this, deviation, orders);
}

Index GaussianAxis::place(Index number) const {
    if (number >= 0 && number < coarse) return number;
    if (!periodic) return -1;
    const Index rest = number % coarse;
    return rest < 0 ? rest + coarse : rest;
}

}  // namespace setae::processing
