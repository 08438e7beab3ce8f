// SPDX-License-Identifier: GPL-3.0-or-later
#include "front_equation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace setae::crack_front {

void FrontEquation::evaluate(const Array1D& front, const std::vector<Index>& cells, Balance& balance) {
    elasticity_.stiffened(front, bent_);
    elastic_part(front, bent_, balance);
    scale_.setOnes(front.size());
    scale_pinning(front, scale_);
    for (Index j = 0; j < front.size(); ++j) {
        const auto pinned = pinning_.at(j, front[j], cells[static_cast<std::size_t>(j)]);
        balance.residual[j] -= scale_[j] * pinned.force;
        balance.stiffness[j] -= scale_[j] * pinned.slope;
    }
}

NewtonStep newton_step(LineElasticity& elasticity, const Balance& balance, double largest_move, double accuracy) {
    const Index n = balance.residual.size();
    const double least = 1e-3 * balance.kernel * elasticity.own();
    const double mean_stiffness = std::max(balance.stiffness.max(0.0).mean(), least);
    NewtonStep found{.step = Array1D::Zero(n)};
    Array1D rest = -balance.residual, conditioned(n), direction(n), along(n);
    const double target = accuracy * rest.matrix().norm();
    const auto precondition = [&] { elasticity.softened(rest, conditioned, mean_stiffness, balance.kernel); };
    precondition();
    direction = conditioned;
    double fall = (rest * conditioned).sum();
    const auto to_largest_move = [&] {
        // the share t of the direction with which some point has moved that far
        double t = std::numeric_limits<double>::infinity();
        for (Index j = 0; j < n; ++j)
            if (direction[j] != 0.0)
                t = std::min(t, (std::copysign(largest_move, direction[j]) - found.step[j]) / direction[j]);
        found.step += std::max(t, 0.0) * direction;
    };
    for (Index k = 0; k < 4 * n + 20 && rest.matrix().norm() > target && fall > 0.0; ++k) {
        elasticity.stiffened(direction, along);
        along = balance.stiffness * direction + balance.kernel * along;
        if (balance.coupling_factor != 0.0)
            along -= balance.coupling_factor * (balance.coupling * direction).sum() * balance.coupling;
        const double curvature = (direction * along).sum();
        if (!(curvature > 0.0)) {
            found.stable = false;
            to_largest_move();
            return found;
        }
        const double length = fall / curvature;
        if ((found.step + length * direction).abs().maxCoeff() > largest_move) {
            to_largest_move();
            return found;
        }
        found.step += length * direction;
        rest -= length * along;
        precondition();
        const double next = (rest * conditioned).sum();
        direction = conditioned + next / fall * direction;
        fall = next;
    }
    return found;
}

Equilibrium trust_region(FrontEquation& equation, Array1D& front, const SearchLimits& limits) {
    const auto& pinning = equation.pinning();
    const auto n = static_cast<std::size_t>(front.size());
    std::vector<Index> cells(n), trial_cells(n);
    const auto find_cells = [&](const Array1D& at, std::vector<Index>& of) {
        bool held = true;
        for (std::size_t j = 0; j < n; ++j) {
            of[j] = pinning.cell(at[static_cast<Index>(j)]);
            held = held && pinning.holds(of[j]);
        }
        return held;
    };
    Balance here, there;
    Equilibrium found;
    if (!find_cells(front, cells)) {
        found.left = true;
        return found;
    }
    equation.evaluate(front, cells, here);
    double radius = limits.largest_move;
    for (found.iterations = 1; found.iterations < limits.max_iterations;) {
        found.residual = here.residual.abs().maxCoeff();
        if (found.residual <= limits.tolerance) {
            found.converged = true;
            return found;
        }
        const double accuracy = std::min(0.1, std::sqrt(found.residual / limits.tolerance) * 1e-3);
        const Array1D step = newton_step(equation.elasticity(), here, radius, accuracy).step;
        const Array1D trial = front + step;
        if (!find_cells(trial, trial_cells)) {
            found.left = true;
            front = trial;
            return found;
        }
        equation.evaluate(trial, trial_cells, there);
        ++found.iterations;
        const double work = ((here.residual + there.residual) * step).sum();
        if (work > 0.0 && radius > 1e-12 * limits.largest_move) {
            radius = 0.5 * std::min(radius, step.abs().maxCoeff());
            continue;
        }
        front = trial;
        cells.swap(trial_cells);
        std::swap(here, there);
        radius = std::min(2.0 * radius, limits.largest_move);
    }
    return found;
}

}  // namespace setae::crack_front
