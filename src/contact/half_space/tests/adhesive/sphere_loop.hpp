// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/core/extent.hpp"
#include "setae/half_space/adhesive_loop.hpp"

namespace setae::half_space {

/// A paraboloid in a periodic cell, in Maugis' units: R = 1, w = 1/π, E* = 3/4; forces in πwR, energies in
/// πwR (π²w²R/K²)^(1/3).
struct SphereCell {
    Index points = 0;    ///< along a side
    double side = 0.0;   ///< of the cell
    double range = 0.0;  ///< ρ
    AttractionLaw law = AttractionLaw::exponential;
    double depth = 0.1;  ///< displacement where it turns
    Array2D roughness;   ///< added to the paraboloid; empty: none
};

struct SphereLoop {
    bool complete = false;
    double greatest_pull = 0.0;
    double loss = 0.0, approach_dissipation = 0.0, separation_dissipation = 0.0;
    double steps = 0.0;
};

/// The largest tension between steps: of the parabola through the largest of them and its neighbours.
inline double greatest_tension(const std::vector<LoopStep>& steps) {
    const auto largest = std::ranges::max_element(steps, {}, [](const LoopStep& s) { return s.state.tension; });
    const auto at = std::clamp<std::ptrdiff_t>(largest - steps.begin(), 1, std::ssize(steps) - 2);
    const auto& [before, here, after] = std::tie(steps[extent(at - 1)], steps[extent(at)], steps[extent(at + 1)]);
    const double left = here.position - before.position, right = after.position - here.position;
    const double rise = (here.state.tension - before.state.tension) / left,
                 fall = (after.state.tension - here.state.tension) / right;
    const double bend = (rise - fall) / (left + right), slope = (rise * right + fall * left) / (left + right);
    return here.state.tension + 0.25 * slope * slope / bend;
}

/// Grips far away are moved. Images and their mean move a point of the cell by −3.9002649 F/(πE*L), the lattice sum of
/// 1/r with its background; the spring of a stage of 1/A of the inverse takes that back.
inline SphereLoop approach_and_part(const SphereCell& sphere) {
    constexpr double modulus = 0.75, lattice_sum = 3.9002649;
    const double pixel = sphere.side / static_cast<double>(sphere.points), area = sphere.side * sphere.side;
    const auto at = [&](Index i) { return pixel * static_cast<double>(i - sphere.points / 2); };
    Array2D heights = Array2D::NullaryExpr(sphere.points, sphere.points,
                                           [&](Index i, Index j) { return -0.5 * (at(i) * at(i) + at(j) * at(j)); });
    if (sphere.roughness.size() > 0) heights += sphere.roughness;
    AdhesiveCell cell(heights, {sphere.points, sphere.points, sphere.side, sphere.side}, {.contact_modulus = modulus},
                      {1.0 / pi, sphere.range, sphere.law});
    const auto loop = adhesive_loop(cell, {.turn = -heights.mean() - sphere.depth,
                                           .stage_stiffness = pi * modulus / (lattice_sum * sphere.side),
                                           .jump_share = 1e-5});
    return {.complete = loop.complete,
            .greatest_pull = greatest_tension(loop.steps) * area,
            .loss = loop.loss() * area,
            .approach_dissipation = loop.approach_dissipation * area,
            .separation_dissipation = loop.separation_dissipation * area,
            .steps = static_cast<double>(loop.steps.size())};
}

}  // namespace setae::half_space
