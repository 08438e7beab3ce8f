// SPDX-License-Identifier: GPL-3.0-or-later
#include "latent_start.hpp"

#include <Eigen/Dense>

#include "fit_support.hpp"

namespace setae::experiment::latent {
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

Solution solve_from(const Points& points, const Parameters& start, const Options& options) {
    Parameters near = start;
    const Index neighbours = neighbours_of_a_first_solution(points.force.size());
    if (neighbours > 1) {
        const Points few = averaged(points, neighbours);
        const Solution first = solve(few, start, first_radii(few, start), options);
        if (first.converged) near = first.parameters;
    }
    return solve(points, near, first_radii(points, near), options);
}

}  // namespace setae::experiment::latent
