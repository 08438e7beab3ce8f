// SPDX-License-Identifier: GPL-3.0-or-later
#include "start.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "fits/fit_support.hpp"
#include "setae/contact/jkr_curve.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::loops::errors_in_variables {
namespace {

/// Round by round, the offset of the curvature held while a sum of squares is made least: where plain rounds do not
/// settle.
Solution solve_with_offsets_held(const Points& points, const Solution& near) {
    constexpr int most_rounds = 30;
    constexpr double settled = 1e-7;
    Solution solution = near;
    for (int round = 0; round < most_rounds; ++round) {
        const Parameters before = solution.parameters;
        solution = solve_carefully(round == 0 ? points : straightened(points, solution), before, solution.x);
        if (!solution.converged) return solution;
        solution.converged =
            round > 0 && (solution.parameters - before).cwiseAbs().maxCoeff() <= settled * before.cwiseAbs().maxCoeff();
        if (solution.converged) break;
    }
    return solution;
}

Solution solve_from(const Points& points, const Parameters& start) {
    Solution solution = solve(points, start, first_radii(points, start));
    if (!solution.converged)
        solution = solve_with_offsets_held(points, {.parameters = start, .x = first_radii(points, start)});
    return solution;
}

/// Force against displacement has a minimum on each side of W = 0 where W is hardly known: that of W > 0 is taken
/// unless the other is better by three standard deviations.
Parameters on_the_better_side(const Points& points, const Parameters& start) {
    constexpr double least_share = 0.05, deviations = 3.0;
    const double root = std::max(std::abs(start[1]), least_share * start[0]);
    const auto from = [&](double signed_root) {
        const Parameters at(start[0], signed_root, start[2]);
        return solve_carefully(points, at, first_radii(points, at));
    };
    const Solution above = from(root), below = from(-root);
    if (!above.converged || !below.converged)
        return above.converged ? above.parameters : below.converged ? below.parameters : start;
    const double variance = below.squares / std::max(1.0, static_cast<double>(points.force.size()) - 3.0);
    return below.squares < above.squares - deviations * deviations * variance ? below.parameters : above.parameters;
}

/// By how much the variance of the noise exceeds what the fit's corrections bear.
double excess(const Fitted& fitted) {
    constexpr double curvature = 0.1, pretended = 0.05;
    const AlongTheCurve along = along_the_curve(fitted.points, fitted.solution);
    const double share =
        numerics::solved_symmetric(across_information(across(fitted.points, fitted.solution)), along.pretended).trace();
    return std::max(std::pow(along.curvature / curvature, 2), share / pretended);
}

}  // namespace

Parameters linear_start(const Points& all) {
    const Points points = averaged(all, neighbours_of_a_first_solution(all.force.size()));
    const contact::jkr::CurveAt<Array1D> curve(points.contact_radius);
    const Array1D &cube = curve.cube, &three_halves = curve.three_halves;
    Eigen::Matrix2d normal;
    normal << cube.square().sum(), -(cube * three_halves).sum(), 0.0, cube.sum();
    normal(1, 0) = normal(0, 1);
    const Eigen::Vector2d found =
        normal.fullPivLu().solve(Eigen::Vector2d((cube * points.force).sum(), -(three_halves * points.force).sum()));
    Parameters start(found[0], found[1], 0.0);
    if (points.channels.displacement)
        start[2] = (points.depth - curve.square + 2.0 / 3.0 * start[1] / start[0] * curve.root).mean();
    return start;
}

Fitted fit(const Points& points, const Parameters& start) {
    constexpr Index fewest_means = 24;
    const Index samples = points.force.size(), first_neighbours = neighbours_of_a_first_solution(samples);
    const Index most = std::max<Index>(1, samples / fewest_means);
    Fitted first{.points = first_neighbours > 1 ? averaged(points, first_neighbours) : points};
    Parameters near = points.channels.contact_radius ? start : on_the_better_side(first.points, start);
    Index neighbours = 1;
    if (first_neighbours > 1) {
        first.solution =
            solve_with_offsets_held(first.points, {.parameters = near, .x = first_radii(first.points, near)});
        neighbours = most;
        if (first.solution.converged) {
            near = first.solution.parameters;
            // variances of the samples are so many times those of the means
            const double wanted = static_cast<double>(first_neighbours) * excess(first);
            if (wanted < static_cast<double>(most))
                neighbours = std::max<Index>(1, static_cast<Index>(std::ceil(wanted)));
        }
    }
    Fitted all{.points = neighbours > 1 ? averaged(points, neighbours) : points};
    all.solution = solve_from(all.points, near);
    return all;
}

}  // namespace setae::loops::errors_in_variables
