// SPDX-License-Identifier: GPL-3.0-or-later
#include "gaussian_axis.hpp"

#include <algorithm>
#include <cmath>

namespace setae::processing {
namespace {

/// Truncation of a Gaussian, in its deviations.
const double reach = 4.0 * std::sqrt(2.0);
/// Narrower Gaussians [pixels] are summed directly.
constexpr double widest_direct = 3.0;

/// Tables of a Gaussian that is summed over the points themselves.
void tabulate_direct(GaussianAxis& axis, double deviation, Index orders) {
    const Index half = static_cast<Index>(std::ceil(reach * deviation));
    axis.direct = true;
    axis.coarse = axis.points;
    axis.taps = 2 * half + 1;
    for (Index q = 0; q <= orders; ++q) axis.gather.emplace_back(axis.points, axis.taps);
    for (Index t = 0; t < axis.taps; ++t) {
        const double offset = deviation > 0.0 ? static_cast<double>(t - half) / deviation : 0.0;
        double weight = std::exp(-0.5 * offset * offset);
        for (Index q = 0; q <= orders; ++q) {
            axis.gather[static_cast<std::size_t>(q)].col(t) = weight;
            weight *= offset;
        }
    }
    for (Index i = 0; i < axis.points; ++i) axis.first_tap.push_back(i - half);
    axis.coordinate.setZero(axis.points);
}

/// Coarse points half a deviation apart, at origin + k step.
struct CoarseGrid {
    double origin = 0.0, step = 0.0;  ///< [points]
    Index number = 0;
    Index half = 0;  ///< coarse points within a Gaussian on either side
};

CoarseGrid coarse_grid(const GaussianAxis& axis, double deviation) {
    const auto n = static_cast<double>(axis.points);
    CoarseGrid grid{.step = 0.5 * deviation};
    if (axis.periodic) {
        grid.number = static_cast<Index>(std::ceil(n / grid.step));
        grid.step = n / static_cast<double>(grid.number);
    }
    grid.half = static_cast<Index>(std::ceil(4.0 * deviation / grid.step));
    if (!axis.periodic) {
        grid.origin = -static_cast<double>(grid.half) * grid.step;
        grid.number = static_cast<Index>(std::floor((n - 1.0 - grid.origin) / grid.step)) + grid.half + 1;
    }
    return grid;
}

/// Weights of the coarse points used by point i.
void tabulate_gather(GaussianAxis& axis, const CoarseGrid& grid, double deviation, Index orders, Index i) {
    const double place = (static_cast<double>(i) - grid.origin) / grid.step;  // in coarse steps
    const auto below = static_cast<Index>(std::floor(place));
    axis.coordinate[i] = (place - static_cast<double>(below)) * grid.step / deviation;
    axis.first_tap.push_back(below - grid.half + 1);
    for (Index t = 0; t < axis.taps; ++t) {
        const double from_reference = static_cast<double>(t - grid.half + 1) * grid.step / deviation;
        const double distance = axis.coordinate[i] - from_reference;
        double weight = std::exp(-distance * distance);
        for (Index q = 0; q <= orders; ++q) {
            axis.gather[static_cast<std::size_t>(q)](i, t) = weight;
            weight *= from_reference;
        }
    }
}

/// Weights for the distribution of point i to coarse points.
void tabulate_shares(GaussianAxis& axis, const CoarseGrid& grid, double deviation, Index orders, Index i) {
    const double place = (static_cast<double>(i) - grid.origin) / grid.step;
    const auto first = static_cast<Index>(std::ceil(place)) - grid.half;
    axis.first_share.push_back(first);
    for (Index s = 0; s < axis.shares; ++s) {
        const double distance = (place - static_cast<double>(first + s)) * grid.step / deviation;
        const bool reached = std::abs(distance) * deviation <= static_cast<double>(grid.half) * grid.step;
        double weight = reached ? std::exp(-distance * distance) : 0.0;
        for (Index m = 0; m <= orders; ++m) {
            axis.share[static_cast<std::size_t>(m)](i, s) = weight;
            weight *= distance;
        }
    }
}

/// Tables of a Gaussian as a product of two, through coarse points.
void tabulate_coarse(GaussianAxis& axis, double deviation, Index orders) {
    const auto grid = coarse_grid(axis, deviation);
    axis.coarse = grid.number;
    axis.taps = 2 * grid.half;
    axis.shares = 2 * grid.half + 1;
    axis.coordinate.resize(axis.points);
    for (Index k = 0; k <= orders; ++k) {
        axis.share.emplace_back(axis.points, axis.shares);
        axis.gather.emplace_back(axis.points, axis.taps);
    }
    for (Index i = 0; i < axis.points; ++i) {
        tabulate_gather(axis, grid, deviation, orders, i);
        tabulate_shares(axis, grid, deviation, orders, i);
    }
}

}  // namespace

GaussianAxis::GaussianAxis(Index number, double deviation, bool wraps, Index orders) : points(number), periodic(wraps) {
    if (deviation <= widest_direct) tabulate_direct(*this, deviation, orders);
    else tabulate_coarse(*this, deviation, orders);
}

Index GaussianAxis::place(Index number) const {
    if (number >= 0 && number < coarse) return number;
    if (!periodic) return -1;
    const Index rest = number % coarse;
    return rest < 0 ? rest + coarse : rest;
}

}  // namespace setae::processing
