// SPDX-License-Identifier: GPL-3.0-or-later
#include "latent_start.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "fit_support.hpp"

namespace setae::experiment::latent {
namespace {
/// Round by round, the offset of the curvature held while a sum of squares is made least: where plain rounds do not settle.
Solution solve_with_offsets_held(const Points& points, const Solution& near) {
    constexpr int most_rounds = 30;
    constexpr double settled = 1e-7;
    Solution solution = near;
    for (int round = 0; round < most_rounds; ++round) {
        const Parameters before = solution.parameters;
        solution = solve_carefully(round == 0 ? points : straightened(points, solution), before, solution.x);
        if (!solution.converged) return solution;
        solution.converged = round > 0 && (solution.parameters - before).cwiseAbs().maxCoeff() <= settled * before.cwiseAbs().maxCoeff();
        if (solution.converged) break;
    }
    return solution;
}

Solution solve_from(const Points& points, const Parameters& start) {
    Solution solution = solve(points, start, first_radii(points, start));
    if (!solution.converged) solution = solve_with_offsets_held(points, {.parameters = start, .x = first_radii(points, start)});
    return solution;
}

/// By how much the variance of the noise exceeds what the fit's corrections bear.
double excess(const Fitted& fitted) {
    constexpr double curvature = 0.1, pretended = 0.05;
    const AlongTheCurve along = along_the_curve(fitted.points, fitted.solution);
    const double share = across_information(across(fitted.points, fitted.solution)).ldlt().solve(along.pretended).trace();
    return std::max(std::pow(along.curvature / curvature, 2), share / pretended);
}

}  // namespace

Parameters linear_start(const Points& all) {
    const Points points = averaged(all, neighbours_of_a_first_solution(all.force.size()));
    const Array1D three_halves = points.contact_radius * points.contact_radius.sqrt(), cube = points.contact_radius.cube();
    Eigen::Matrix2d normal;
    normal << cube.square().sum(), -(cube * three_halves).sum(), 0.0, cube.sum();
    normal(1, 0) = normal(0, 1);
    const Eigen::Vector2d found = normal.fullPivLu().solve(Eigen::Vector2d((cube * points.force).sum(), -(three_halves * points.force).sum()));
    Parameters start(found[0], found[1], 0.0);
    if (points.channels.displacement)
        start[2] = (points.depth - points.contact_radius.square() + 2.0 / 3.0 * start[1] / start[0] * points.contact_radius.sqrt()).mean();
    return start;
}

Fitted fit(const Points& points, const Parameters& start) {
    constexpr Index fewest_means = 24;
    const Index samples = points.force.size(), first_neighbours = neighbours_of_a_first_solution(samples);
    const Index most = std::max<Index>(1, samples / fewest_means);
    Parameters near = start;
    Index neighbours = 1;
    if (first_neighbours > 1) {
        Fitted first{.points = averaged(points, first_neighbours)};
        first.solution = solve_with_offsets_held(first.points, {.parameters = start, .x = first_radii(first.points, start)});
        neighbours = most;
        if (first.solution.converged) {
            near = first.solution.parameters;
            // variances of the samples are so many times those of the means
            const double wanted = static_cast<double>(first_neighbours) * excess(first);
            if (wanted < static_cast<double>(most)) neighbours = std::max<Index>(1, static_cast<Index>(std::ceil(wanted)));
        }
    }
    Fitted all{.points = neighbours > 1 ? averaged(points, neighbours) : points};
    all.solution = solve_from(all.points, near);
    return all;
}

}  // namespace setae::experiment::latent
