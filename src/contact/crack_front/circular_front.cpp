// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/crack_front/circular_front.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "circle_equation.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::crack_front {
namespace {

/// a w [J/m], pinning force of the edge on a ray.
Array2D line_forces(const WorkField& field) {
    require(field);
    Array2D forces = field.works;
    for (Index k = 0; k < forces.cols(); ++k) forces.col(k) *= field.points.at(k);
    return forces;
}

Machine machine_of(const FrontControl& control) {
    if (const auto* held = std::get_if<HeldDisplacement>(&control)) return {.displacement = held->displacement};
    if (const auto* load = std::get_if<DeadLoad>(&control)) return {.holds_displacement = false, .pull = load->force};
    const auto& stage = std::get<Stage>(control);
    if (!(stage.stiffness > 0.0))
        throw InvalidArgument(fmt::format("a stage of {} N/m; expected a stiffness above 0", stage.stiffness));
    return {.holds_displacement = false, .pull = stage.stiffness * stage.position, .stiffness = stage.stiffness};
}

}  // namespace

class CircularFront::Work {
public:
    Work(const contact::SphereOnFlat& sphere, const WorkField& field, const FrontOptions& options)
        : sphere_(sphere),
          options_(options),
          mean_work_(field.mean_work),
          pinning_(line_forces(field), field.points, false),
          elasticity_(field.lines(), 1.0),
          equation_(pinning_, elasticity_, sphere, field.mean_work, options.model) {
        if (!(sphere.radius > 0.0 && sphere.contact_modulus > 0.0))
            throw InvalidArgument(fmt::format("a sphere of {} m and {} Pa; expected radius and modulus above 0",
                                              sphere.radius, sphere.contact_modulus));
        if (options.method == EquilibriumMethod::rosso_krauth && options.model != FrontModel::constant_toughness)
            throw InvalidArgument(
                "rosso_krauth moves points in one direction only, which needs a front of the same stiffness "
                "everywhere; expected the model constant_toughness, or trust_region");
    }

    FrontState solve(const FrontControl& control) {
        const Machine machine = machine_of(control);
        if (!machine.holds_displacement && options_.model != FrontModel::constant_toughness)
            throw InvalidArgument("dead loads and stages need the model constant_toughness; expected a displacement");
        if (edge.size() == 0 && !meet(machine)) return parted(machine);
        equation_.drive(machine);
        const double scale = mean_work_ * std::max(edge.mean(), min_radius());
        const SearchLimits limits{.tolerance = options_.tolerance * scale,
                                  .max_iterations = options_.max_iterations,
                                  .largest_move = options_.largest_move * pinning_.points().spacing};
        const auto found = options_.method == EquilibriumMethod::rosso_krauth ? rosso_krauth(equation_, edge, limits)
                                                                              : trust_region(equation_, edge, limits);
        if (found.left) {
            if (edge.maxCoeff() >= pinning_.points().last())
                throw InvalidArgument(
                    fmt::format("the front reached {} m, where the field ends; press less, or make the field larger",
                                pinning_.points().last()));
            edge.resize(0);
            auto state = parted(machine);
            state.iterations = found.iterations;
            return state;
        }
        return described(machine, found, scale);
    }

    contact::SphereOnFlat sphere_;
    FrontOptions options_;
    double mean_work_;
    PinningLines pinning_;
    Array1D edge;

private:
    /// Radius of a smooth contact before separation; on approach the edge starts far below, at one spacing.
    [[nodiscard]] double min_radius() const {
        return contact::jkr::pull_off_at_fixed_grips({sphere_.radius, sphere_.contact_modulus, mean_work_})
            .contact_radius;
    }

    /// A circle as wide as Hertz's, or one spacing; false where there is no contact yet.
    bool meet(const Machine& machine) {
        const double touching = machine.holds_displacement ? machine.displacement : machine.pull;
        if (touching < 0.0) return false;
        const double hertz = machine.holds_displacement ? std::sqrt(sphere_.radius * machine.displacement) : 0.0;
        const double least = pinning_.points().first + pinning_.points().spacing;
        edge = Array1D::Constant(pinning_.lines(), std::max(hertz, least));
        return true;
    }

    [[nodiscard]] FrontState parted(const Machine& machine) const {
        FrontState state{.converged = true};
        if (machine.holds_displacement) state.displacement = machine.displacement;
        if (machine.stiffness > 0.0) state.displacement = machine.pull / machine.stiffness;
        return state;
    }

    FrontState described(const Machine& machine, const Equilibrium& found, double scale) {
        FrontState state{.displacement = machine.displacement_of(edge, sphere_)};
        const auto elastic = equation_.elastic(edge, state.displacement);
        state.force = elastic.force;
        state.elastic_energy = elastic.energy;
        state.mean_radius = edge.mean();
        state.area_radius = std::sqrt(edge.square().mean());
        state.smallest_radius = edge.minCoeff();
        state.largest_radius = edge.maxCoeff();
        Array1D slopes;
        elasticity_.slopes(edge, slopes);
        state.perimeter = 2.0 * pi * (edge.square() + slopes.square()).sqrt().mean();
        double surface = 0.0;
        for (Index j = 0; j < edge.size(); ++j) surface += pinning_.integral(j, edge[j]);
        state.surface_energy = -2.0 * pi * surface / static_cast<double>(edge.size());
        state.residual = found.residual / scale;
        state.iterations = found.iterations;
        state.converged = found.converged;
        state.in_contact = true;
        return state;
    }

    LineElasticity elasticity_;
    CircleEquation equation_;
};

CircularFront::CircularFront(const contact::SphereOnFlat& sphere, const WorkField& field, const FrontOptions& options)
    : work_(std::make_unique<Work>(sphere, field, options)) {}
CircularFront::~CircularFront() = default;
CircularFront::CircularFront(CircularFront&&) noexcept = default;
CircularFront& CircularFront::operator=(CircularFront&&) noexcept = default;

const contact::SphereOnFlat& CircularFront::sphere() const { return work_->sphere_; }
double CircularFront::mean_work() const { return work_->mean_work_; }
const LinePoints& CircularFront::radii_of_field() const { return work_->pinning_.points(); }
const Array1D& CircularFront::edge() const { return work_->edge; }

void CircularFront::begin_at(double radius) {
    if (radius > 0.0) work_->edge = Array1D::Constant(work_->pinning_.lines(), radius);
    else work_->edge.resize(0);
}

void CircularFront::begin_with(const Array1D& edge) {
    if (edge.size() != 0 && edge.size() != work_->pinning_.lines())
        throw InvalidArgument(fmt::format("an edge of {} points in a field of {} rays; expected as many of both",
                                          edge.size(), work_->pinning_.lines()));
    work_->edge = edge;
}

FrontState CircularFront::solve(const FrontControl& control) { return work_->solve(control); }

}  // namespace setae::crack_front
