// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/lens_radius.hpp"

#include <cmath>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "fits/least_squares.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

void require_points(const ArrayView1D& x, const ArrayView1D& y) {
    if (x.size() != y.size()) throw InvalidArgument(fmt::format("{} x and {} y coordinates", x.size(), y.size()));
    if (!x.allFinite() || !y.allFinite()) throw InvalidArgument("a point of the outline is undefined; remove it");
}

/// Points about their centre, in units of their spread.
struct Scaled {
    Array1D x, y;
    double centre_x, centre_y, unit;
};

Scaled scaled(const ArrayView1D& x, const ArrayView1D& y) {
    Scaled points{.x = x - x.mean(), .y = y - y.mean(), .centre_x = x.mean(), .centre_y = y.mean(), .unit = 1.0};
    points.unit = std::sqrt((points.x.square() + points.y.square()).mean());
    if (!(points.unit > 0.0)) throw InvalidArgument("all points of the outline coincide");
    points.x /= points.unit;
    points.y /= points.unit;
    return points;
}

/// Centre and radius from the linear problem x² + y² = 2 x c_x + 2 y c_y + (r² − c²).
Eigen::Vector3d algebraic_circle(const Scaled& points) {
    Eigen::MatrixXd design(points.x.size(), 3);
    design << 2.0 * points.x, 2.0 * points.y, Array1D::Ones(points.x.size());
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(design);
    decomposition.setThreshold(1e-12);
    if (decomposition.rank() < 3) throw InvalidArgument("the points of the outline lie on a line: no circle");
    const Eigen::Vector3d solution = decomposition.solve((points.x.square() + points.y.square()).matrix());
    return {solution[0], solution[1], std::sqrt(solution[2] + solution.head<2>().squaredNorm())};
}

Circle unscaled(const Scaled& points, const Eigen::Vector3d& circle) {
    return {.centre_x = points.centre_x + points.unit * circle[0],
            .centre_y = points.centre_y + points.unit * circle[1],
            .radius = {points.unit * circle[2]}};
}

}  // namespace

Circle circle_through(const ArrayView1D& x, const ArrayView1D& y) {
    require_points(x, y);
    if (x.size() != 3)
        throw InvalidArgument(fmt::format("{} points, a circle goes through three; use fit_circle", x.size()));
    const Scaled points = scaled(x, y);
    return unscaled(points, algebraic_circle(points));
}

Circle fit_circle(const ArrayView1D& x, const ArrayView1D& y) {
    require_points(x, y);
    if (x.size() < 4) throw UndefinedDataError(fmt::format("{} points, a fitted circle needs at least four", x.size()));
    const Scaled points = scaled(x, y);
    const ResidualFunction distances{
        .residuals = x.size(),
        .parameters = 3,
        .evaluate = [&](const Eigen::VectorXd& at, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) {
            for (Index i = 0; i < residuals.size(); ++i) {
                const double dx = points.x[i] - at[0], dy = points.y[i] - at[1];
                const double distance = std::hypot(dx, dy);
                residuals[i] = distance - at[2];
                if (jacobian) jacobian->row(i) << -dx / distance, -dy / distance, -1.0;
            }
        }};
    const LeastSquaresSolution solution = solve_nonlinear(distances, algebraic_circle(points));
    Circle circle = unscaled(points, solution.parameters);
    circle.radius =
        solution.estimate(circle.radius.value, points.unit * std::sqrt(solution.uncertainty.covariance(2, 2)));
    circle.rms_residual = points.unit * std::sqrt(solution.residuals.array().square().mean());
    return circle;
}

}  // namespace setae::loops
