// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/lens_radius.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "fits/least_squares.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::loops {
namespace {

void require_points(const ArrayView1D& x, const ArrayView1D& y) {
    if (x.size() != y.size())
        throw InvalidArgument(fmt::format("{} x and {} y coordinates; expected the same number", x.size(), y.size()));
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

/// s of a conic at r from its apex, with ds/dr, ds/dc and ds/dκ.
struct Sagitta {
    double value, by_distance, by_curvature, by_constant;
};

Sagitta sagitta(double r, double curvature, double constant) {
    // beyond the equator of a spheroid there is no surface: the slope there is steep enough to lead back
    const double root = std::sqrt(std::max(1e-6, 1.0 - (1.0 + constant) * curvature * curvature * r * r));
    const double s = curvature * r * r / (1.0 + root);
    return {s, curvature * r / root, (r * r + (1.0 + constant) * s * s) / (2.0 * root),
            curvature * s * s / (2.0 * root)};
}

}  // namespace

Circle circle_through(const ArrayView1D& x, const ArrayView1D& y) {
    require_points(x, y);
    if (x.size() != 3)
        throw InvalidArgument(fmt::format(
            "{} points, expected three: a circle goes through three points; use fit_circle for more", x.size()));
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

Conic fit_conic(const ArrayView1D& x, const ArrayView1D& z) {
    require_points(x, z);
    if (x.size() < 6) throw UndefinedDataError(fmt::format("{} points, a fitted conic needs at least six", x.size()));
    const Scaled points = scaled(x, z);
    const Eigen::Vector3d circle = algebraic_circle(points);
    const double side = circle[1] > 0.0 ? 1.0 : -1.0;  // the centre is above the points: z rises from the apex
    // from heights to distances: the circle's slope
    const Array1D cosine = ((points.y - circle[1]).abs() / circle[2]).min(1.0);
    const ResidualFunction distances{
        .residuals = x.size(),
        .parameters = 4,
        .evaluate = [&](const Eigen::VectorXd& at, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) {
            for (Index i = 0; i < residuals.size(); ++i) {
                const auto s = sagitta(points.x[i] - at[0], at[2], at[3]);
                residuals[i] = cosine[i] * (points.y[i] - at[1] - side * s.value);
                if (jacobian)
                    jacobian->row(i) << cosine[i] * side * s.by_distance, -cosine[i],
                        -cosine[i] * side * s.by_curvature, -cosine[i] * side * s.by_constant;
            }
        }};
    const Eigen::VectorXd start = Eigen::Vector4d(circle[0], circle[1] - side * circle[2], 1.0 / circle[2], 0.0);
    const auto solution = solve_nonlinear(distances, start);
    const double curvature = solution.parameters[2], constant = solution.parameters[3];
    const auto [least, most] = std::minmax_element(points.x.begin(), points.x.end());
    if (!(curvature > 0.0) || !(solution.parameters[0] > *least && solution.parameters[0] < *most))
        throw UndefinedDataError("no conic has its apex among the points of the outline");
    const auto& covariance = solution.uncertainty.covariance;
    Conic conic{.apex_x = points.centre_x + points.unit * solution.parameters[0],
                .apex_z = points.centre_y + points.unit * solution.parameters[1],
                .radius = solution.estimate(points.unit / curvature,
                                            points.unit * std::sqrt(covariance(2, 2)) / (curvature * curvature)),
                .conic_constant = solution.estimate(constant, std::sqrt(covariance(3, 3)))};
    const double farthest = std::max(solution.parameters[0] - *least, *most - solution.parameters[0]);
    conic.departure =
        points.unit * side * (sagitta(farthest, curvature, constant).value - sagitta(farthest, curvature, 0.0).value);
    if (conic.conic_constant.uncertain())
        conic.probability = 2.0 * student_t_probability(-std::abs(constant) / conic.conic_constant.standard_error,
                                                        solution.uncertainty.degrees_of_freedom);
    conic.rms_residual = points.unit * std::sqrt(solution.residuals.array().square().mean());
    return conic;
}

}  // namespace setae::loops
