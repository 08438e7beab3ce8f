// SPDX-License-Identifier: GPL-3.0-or-later
#include "solution.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "curve.hpp"
#include "fits/small_least_squares.hpp"
#include "setae/core/constants.hpp"

namespace setae::loops::errors_in_variables {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double closest = 0.25;  ///< an iteration reduces a radius at most to this share

/// Normal equations of the parameters, with the radii eliminated, and the step of each radius.
struct Round {
    Matrix3d normal = Matrix3d::Zero();
    Vector3d gradient = Vector3d::Zero();
    double squares = 0.0;
    Array1D along;                        ///< T·z/H, H the second derivative by the radius
    std::array<Array1D, 3> by_parameter;  ///< T·J/H

    explicit Round(Index samples)
        : along(samples), by_parameter{Array1D(samples), Array1D(samples), Array1D(samples)} {}
};

/// Sums of two neighbouring samples at a time: the compiler may not reorder them.
template <bool depth, bool radius>
void evaluate(const Points& points, const Parameters& at, const Array1D& x, bool curvature, Round& round) {
    constexpr int parameters = depth ? 3 : 2;
    const Index n = x.size();
    Matrix3d normal = Matrix3d::Zero();
    Vector3d gradient = Vector3d::Zero();
    double squares = 0.0;
    const auto stretch = [&]<int width>(Index first, Index last) {
        using Lane = Eigen::Array<double, width, 1>;
        std::array<Lane, 6> products;
        std::array<Lane, 3> slopes;
        for (Lane& sum : products) sum.setZero();
        for (Lane& sum : slopes) sum.setZero();
        Lane sum_of_squares = Lane::Zero();
        for (Index i = first; i < last; i += width) {
            const auto curve = curve_at<depth, radius, Lane>(points, at, x.segment<width>(i), i);
            const Lane length = curve.dot(curve.tangent, curve.tangent), inverse = Lane::Ones() / length;
            // Newton's step where the sample is outside the bend, at most twice that of Gauss inside it
            const Lane newton = Lane::Ones() / (length - curve.dot(curve.residual, curve.second).min(0.5 * length));
            round.along.segment<width>(i) = newton * curve.dot(curve.tangent, curve.residual);
            const auto offset = curvature ? curve.straightened(inverse) : curve.residual;
            const Lane offset_along = inverse * curve.dot(curve.tangent, offset);
            sum_of_squares += curve.dot(offset, offset) - offset_along * curve.dot(curve.tangent, offset);
            std::array<Lane, parameters> along;
            for (int p = 0; p < parameters; ++p) {
                along[p] = curve.dot(curve.tangent, curve.by_parameter[p]);
                slopes[p] += curve.dot(offset, curve.by_parameter[p]) - along[p] * offset_along;
            }
            std::size_t entry = 0;
            for (int p = 0; p < parameters; ++p) {
                const Lane share = inverse * along[p];
                round.by_parameter[p].template segment<width>(i) = newton * along[p];
                for (int q = p; q < parameters; ++q)
                    products[entry++] += curve.dot(curve.by_parameter[p], curve.by_parameter[q]) - share * along[q];
            }
        }
        squares += sum_of_squares.sum();
        std::size_t entry = 0;
        for (int p = 0; p < parameters; ++p) {
            gradient[p] += slopes[p].sum();
            for (int q = p; q < parameters; ++q) normal(p, q) += products[entry++].sum();
        }
    };
    const Index even = n - n % 2;
    stretch.template operator()<2>(0, even);
    stretch.template operator()<1>(even, n);
    round.normal = normal.template selfadjointView<Eigen::Upper>();
    round.gradient = gradient;
    round.squares = squares;
}

void evaluate(const Points& points, const Parameters& at, const Array1D& x, bool curvature, Round& round) {
    if (points.channels.displacement && points.channels.contact_radius)
        return evaluate<true, true>(points, at, x, curvature, round);
    if (points.channels.displacement) return evaluate<true, false>(points, at, x, curvature, round);
    evaluate<false, true>(points, at, x, curvature, round);
}

/// Derivatives of e, g, d0 by the parameters that are free.
Eigen::Matrix<double, 3, Eigen::Dynamic> free_directions(const Points& points, const Parameters& at, Held held) {
    Matrix3d all = Matrix3d::Identity();
    // W ∝ g²/e is kept along dg = g/(2e) de
    if (held == Held::work) all.col(0) = Vector3d(1.0, 0.5 * at[1] / at[0], 0.0);
    std::vector<Index> kept{0, 1};
    if (held == Held::modulus) kept = {1};
    if (held == Held::work) kept = {0};
    if (points.channels.displacement) kept.push_back(2);
    Eigen::Matrix<double, 3, Eigen::Dynamic> directions(3, static_cast<Index>(kept.size()));
    for (Index c = 0; c < directions.cols(); ++c) directions.col(c) = all.col(kept[static_cast<std::size_t>(c)]);
    return directions;
}

/// Solution of the normal equations, damped after Marquardt, in the free directions; NaN where they are singular.
Vector3d step_of(const Round& round, const Eigen::Matrix<double, 3, Eigen::Dynamic>& free, double damping = 0.0) {
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> normal =
        free.transpose() * round.normal * free;
    const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> gradient = free.transpose() * round.gradient;
    return free * damped_step(normal, gradient, damping);
}

/// The larger relative change of e and g.
double change(const Parameters& at, const Vector3d& step) {
    return std::max(std::abs(step[0]) / at[0], std::abs(step[1]) / (std::abs(at[1]) + at[0]));
}

/// The step, shortened where it goes far: E* stays positive.
Vector3d within_reach(const Parameters& at, const Vector3d& step) {
    constexpr double furthest = 0.5;
    const double reach = change(at, step);
    return reach > furthest ? Vector3d(step * (furthest / reach)) : step;
}

/// Moves the parameters by a step, with W exactly constant where it is fixed, and the radii with them.
void move(Solution& solution, const Round& round, const Vector3d& step, Held held) {
    const Parameters before = solution.parameters;
    solution.parameters += step;
    if (held == Held::work) solution.parameters[1] = before[1] * std::sqrt(solution.parameters[0] / before[0]);
    Array1D moved = solution.x + round.along - step[0] * round.by_parameter[0] - step[1] * round.by_parameter[1];
    if (step[2] != 0.0) moved -= step[2] * round.by_parameter[2];
    solution.x = moved.max(closest * solution.x);
}

/// Whether a step is far below the standard errors, or zero.
bool small(const Vector3d& step, const Parameters& at, const Round& round, double freedom) {
    constexpr double of_value = 1e-13;
    return far_below_errors(step, round.normal, round.squares, freedom) || change(at, step) <= of_value;
}

/// Whether steps end in rounding: they are tiny and no longer fall.
bool only_rounding(double changed, double last_change) {
    constexpr double tiny = 1e-10;
    return changed <= tiny && changed >= 0.5 * last_change;
}

double degrees_of_freedom(const Points& points) {
    const double directions = points.channels.displacement && points.channels.contact_radius ? 2.0 : 1.0;
    return std::max(1.0,
                    directions * static_cast<double>(points.force.size()) - (points.channels.displacement ? 3.0 : 2.0));
}

/// The nearest points for the parameters as they are.
void settle_radii(const Points& points, Solution& solution, Round& round) {
    constexpr int most = 12;
    constexpr double near = 1e-7;
    for (int i = 0; i < most; ++i) {
        evaluate(points, solution.parameters, solution.x, false, round);
        if (!(round.along.abs() > near * solution.x).any()) break;
        move(solution, round, Vector3d::Zero(), Held::none);
    }
    solution.squares = round.squares;
}

}  // namespace

Parameters reduced_parameters(const Points& points, double contact_modulus, double work_of_adhesion,
                              double contact_point) {
    const double cubed = points.length * points.length * points.length;
    const double root = std::copysign(std::sqrt(std::abs(work_of_adhesion) * contact_modulus), work_of_adhesion);
    return {4.0 * contact_modulus * cubed / (3.0 * points.radius * points.force_unit),
            root * std::sqrt(8.0 * pi * cubed) / points.force_unit,
            (contact_point - points.origin) / points.depth_unit};
}

Array1D first_radii(const Points& points, const Parameters& parameters) {
    // the curve's radius at a dead load's pull-off, and y = x^(3/2) of its outer branch
    const double fold = std::max(0.5 * parameters[1] / parameters[0], 0.0);
    if (points.channels.contact_radius) return points.contact_radius.max(std::max(0.5 * std::cbrt(fold * fold), 1e-3));
    const Array1D root = (parameters[1] * parameters[1] + 4.0 * parameters[0] * points.force).max(0.0).sqrt();
    const Array1D y = ((parameters[1] + root) / (2.0 * parameters[0])).max(1e-3);
    return y.unaryExpr([](double value) { return std::cbrt(value * value); });
}

Solution solve(const Points& points, const Parameters& start, Array1D radii, const Options& options) {
    Solution solution{.parameters = start, .x = std::move(radii)};
    const double freedom = degrees_of_freedom(points);
    Round round(points.force.size());
    bool settled = false;
    double last_change = 1.0;
    for (;; ++solution.rounds) {
        evaluate(points, solution.parameters, solution.x, options.curvature, round);
        solution.squares = round.squares;
        if (settled || solution.rounds >= options.max_rounds) break;
        const Vector3d step = within_reach(solution.parameters,
                                           step_of(round, free_directions(points, solution.parameters, options.held)));
        if (!step.allFinite()) return solution;
        move(solution, round, step, options.held);
        const double changed = change(solution.parameters, step);
        settled = solution.rounds >= 2 &&
                  (small(step, solution.parameters, round, freedom) || only_rounding(changed, last_change));
        last_change = changed;
    }
    solution.converged = settled && std::isfinite(solution.squares);
    return solution;
}

Solution solve_carefully(const Points& points, const Parameters& start, Array1D radii, const Options& options) {
    Solution solution{.parameters = start, .x = std::move(radii)};
    const double freedom = degrees_of_freedom(points);
    Round round(points.force.size());
    settle_radii(points, solution, round);
    double damping = 1e-3;
    constexpr double max_damping = 1e9;
    for (; solution.rounds < options.max_rounds && damping < max_damping; ++solution.rounds) {
        const auto free = free_directions(points, solution.parameters, options.held);
        const Vector3d step = within_reach(solution.parameters, step_of(round, free, damping));
        if (!step.allFinite()) return solution;
        Solution trial = solution;
        Round there = round;
        move(trial, round, step, options.held);
        settle_radii(points, trial, there);
        solution.converged = small(step, solution.parameters, round, freedom);
        if (!(trial.squares <= solution.squares)) {
            if (solution.converged) break;
            damping *= 8.0;
            continue;
        }
        const bool done = solution.converged;
        const int rounds = solution.rounds;
        solution = std::move(trial);
        solution.rounds = rounds;
        solution.converged = done;
        round = std::move(there);
        if (done) break;
        damping *= 0.2;
    }
    return solution;
}

Solution projected(const Points& points, const Solution& solution) {
    if (points.force.size() == solution.x.size()) return solution;
    Solution result = solution;
    result.x = first_radii(points, solution.parameters);
    Round round(points.force.size());
    settle_radii(points, result, round);
    return result;
}

}  // namespace setae::loops::errors_in_variables
