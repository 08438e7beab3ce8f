// SPDX-License-Identifier: GPL-3.0-or-later
#include "force_minimum.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "local_lines.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::loops {
namespace {

/// Neighbours to average on both sides so that noise moves means by less than 1 % of the smallest force.
Index neighbours_of(double sigma, double smallest, Index samples) {
    constexpr double share = 0.01;
    const double wanted = 0.5 * std::pow(sigma / (share * std::abs(smallest)), 2);
    return std::min(static_cast<Index>(std::ceil(std::min(wanted, 1e6))), samples / 20);
}

/// Samples around a minimum in which the series is within a share of it; a few more where they are few.
IndexRange around(const Array1D& series, Index at, double share) {
    constexpr Index fewest = 8;
    const double level = (1.0 - share) * series[at];
    const Index last = series.size() - 1;
    IndexRange range{at, at};
    while (range.first > 0 && series[range.first - 1] < level) --range.first;
    while (range.last < last && series[range.last + 1] < level) ++range.last;
    while (range.count() < std::min(fewest, series.size())) {
        range.first = std::max<Index>(range.first - 1, 0);
        range.last = std::min(range.last + 1, last);
    }
    return range;
}

}  // namespace

ForceMinimum smallest_force(const Array1D& force, const IndexRange& stretch, const SampleNoise& noise) {
    constexpr double visible = 1e-6, widest = 0.05;
    const Array1D part = force.segment(stretch.first, stretch.count());
    Index at = 0;
    const double smallest = part.minCoeff(&at);
    const auto error = [&](double variance) { return noise.sigma * std::sqrt(noise.correlated_samples * variance); };
    if (noise.sigma <= visible * std::abs(smallest)) return {stretch.first + at, smallest, noise.sigma};
    const Array1D means = local_means(part, neighbours_of(noise.sigma, smallest, part.size()));
    means.minCoeff(&at);
    const double share = std::min(std::sqrt(2.0 * noise.sigma / std::abs(smallest)), widest);
    const IndexRange window = around(means, at, share);
    const Array1D u = Array1D::LinSpaced(window.count(), -1.0, 1.0);
    Eigen::MatrixXd design(window.count(), 3);
    design << Array1D::Ones(window.count()), u, u.square();
    const Eigen::VectorXd found = numerics::least_squares(design, part.segment(window.first, window.count()).matrix());
    double vertex = -0.5 * found[1] / found[2];
    if (!(found[2] > 0.0)) vertex = found[1] > 0.0 ? -1.0 : 1.0;  // it goes on falling to one end
    vertex = std::clamp(vertex, -1.0, 1.0);
    const Eigen::Vector3d row(1.0, vertex, vertex * vertex);
    const Eigen::MatrixXd inverse = numerics::inverse(design.transpose() * design);
    const auto sample =
        window.first + static_cast<Index>(std::lround(0.5 * (vertex + 1.0) * static_cast<double>(window.count() - 1)));
    const double by_curve = 0.05 * share * share * std::abs(smallest);  // a JKR curve is no parabola
    return {stretch.first + sample, row.dot(found), std::hypot(error(row.dot(inverse * row)), by_curve)};
}

}  // namespace setae::loops
