// SPDX-License-Identifier: GPL-3.0-or-later
#include "force_minimum.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "fits/correlated_residuals.hpp"
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

struct Vertex {
    double at;  ///< from −1 at the first value to +1 at the last
    double value;
    double standard_error;
};

/// Scatter of values about a smooth curve: about a polynomial of fourth degree, which fits the shape of a minimum.
Eigen::VectorXd scatter_of(const Eigen::VectorXd& values, const Array1D& u) {
    constexpr Index coefficients = 5;
    if (values.size() <= 2 * coefficients) return Eigen::VectorXd::Zero(values.size());
    Eigen::MatrixXd design(values.size(), coefficients);
    design << Array1D::Ones(values.size()), u, u.square(), u.cube(), u.square().square();
    return values - design * numerics::least_squares(design, values);
}

/// The smallest value of a parabola through values; noise and scatter, the larger, decide its error.
Vertex smallest_of_parabola(const Eigen::VectorXd& values, const SampleNoise& noise) {
    const Array1D u = Array1D::LinSpaced(values.size(), -1.0, 1.0);
    Eigen::MatrixXd design(values.size(), 3);
    design << Array1D::Ones(values.size()), u, u.square();
    const Eigen::VectorXd found = numerics::least_squares(design, values);
    double at = -0.5 * found[1] / found[2];
    if (!(found[2] > 0.0)) at = found[1] > 0.0 ? -1.0 : 1.0;  // the force decreases up to one end
    at = std::clamp(at, -1.0, 1.0);
    const Eigen::Vector3d row(1.0, at, at * at);
    const double independent = row.dot(numerics::inverse(design.transpose() * design) * row);
    const double scatter = row.dot(correlated_covariance(design, scatter_of(values, u)).covariance * row);
    const double variance = noise.sigma * noise.sigma * noise.correlated_samples * independent;
    return {at, row.dot(found), std::sqrt(scatter > variance ? scatter : variance)};
}

}  // namespace

ForceMinimum smallest_force(const Array1D& force, const IndexRange& stretch, const SampleNoise& noise) {
    constexpr double visible = 1e-6, widest = 0.05;
    const Array1D part = force.segment(stretch.first, stretch.count());
    Index at = 0;
    const double smallest = part.minCoeff(&at);
    if (noise.sigma <= visible * std::abs(smallest)) return {stretch.first + at, smallest, noise.sigma};
    const Array1D means = local_means(part, neighbours_of(noise.sigma, smallest, part.size()));
    means.minCoeff(&at);
    const double share = std::min(std::sqrt(2.0 * noise.sigma / std::abs(smallest)), widest);
    const IndexRange window = around(means, at, share);
    const Vertex vertex = smallest_of_parabola(part.segment(window.first, window.count()).matrix(), noise);
    const auto sample =
        window.first +
        static_cast<Index>(std::lround(0.5 * (vertex.at + 1.0) * static_cast<double>(window.count() - 1)));
    const double by_curve = 0.05 * share * share * std::abs(smallest);  // a JKR curve is no parabola
    return {stretch.first + sample, vertex.value, std::hypot(vertex.standard_error, by_curve)};
}

}  // namespace setae::loops
