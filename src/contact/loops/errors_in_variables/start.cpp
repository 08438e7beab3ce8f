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

/// Iterations with a fixed offset of the curvature, in which a sum of squares is minimised: used where plain iterations
/// do not converge.
Solution solve_with_offsets_held(const Points& points, const Solution& near) {
    constexpr int max_rounds = 30;
    constexpr double settled = 1e-7;
    Solution solution = near;
    for (int round = 0; round < max_rounds; ++round) {
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

/// Force against displacement has a minimum on each side of W = 0 where W is poorly determined: that of W > 0 is
/// searched, and W = 0 used where there is none. JKR's curve continues to W < 0, where it is no contact.
Parameters on_the_adhesive_side(const Points& points, const Parameters& start) {
    constexpr double min_share = 0.05;
    const Parameters at(start[0], std::max(std::abs(start[1]), min_share * start[0]), start[2]);
    const Solution found = solve_carefully(points, at, first_radii(points, at));
    Parameters near = found.converged ? found.parameters : start;
    near[1] = std::max(near[1], 0.0);
    return near;
}

/// The solution with W = 0 in place of one below.
Solution without_adhesion(const Points& points, const Solution& below) {
    Parameters at = below.parameters;
    at[1] = 0.0;
    const Options bound{.held = Held::work};
    Solution solution = solve(points, at, first_radii(points, at), bound);
    if (!solution.converged) solution = solve_carefully(points, at, first_radii(points, at), bound);
    return solution;
}

/// Ratio by which the variance of the noise exceeds the range of the fit's corrections.
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
    constexpr Index min_means = 24;
    const Index samples = points.force.size(), first_neighbours = neighbours_of_a_first_solution(samples);
    const Index most = std::max<Index>(1, samples / min_means);
    Fitted first{.points = first_neighbours > 1 ? averaged(points, first_neighbours) : points};
    Parameters near = points.channels.contact_radius ? start : on_the_adhesive_side(first.points, start);
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
    if (!points.channels.contact_radius && all.solution.parameters[1] < 0.0)
        all.solution = without_adhesion(all.points, all.solution);
    return all;
}

}  // namespace setae::loops::errors_in_variables
