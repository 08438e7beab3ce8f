// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/layer.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "domain.hpp"
#include "mapped.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::contact::layer {
namespace {

void require(const AdhesiveContact& contact) {
    require_sphere(contact.radius, contact.contact_modulus);
    require_not_negative(contact.work_of_adhesion, "work of adhesion");
}

/// Decrease of the dry displacement by the adhesion at the edge [m].
double stretch_at(double a, const AdhesiveContact& contact, const Factors& factors) {
    return std::sqrt(2.0 * pi * a * contact.work_of_adhesion / contact.contact_modulus) / factors.edge;
}

State state_at(double a, const AdhesiveContact& contact, const Layer& layer) {
    const Factors factors = layer.factors(a);
    const double stretch = stretch_at(a, contact, factors), flat = a * a / contact.radius;
    return {.force = 2.0 * contact.contact_modulus * a *
                     (2.0 / 3.0 * flat * factors.dry_force - factors.stiffness * stretch),
            .displacement = flat * factors.dry_displacement - stretch,
            .contact_radius = a};
}

/// Derivatives of force and displacement along equilibrium by the contact radius, > 0; the dry force grows as
/// 2aE* s times the dry displacement.
struct Slopes {
    double force, displacement;
};

Slopes slopes_at(double a, const AdhesiveContact& contact, const Layer& layer) {
    const Factors factors = layer.factors(a), slopes = layer.factor_slopes(a);
    const double stretch = stretch_at(a, contact, factors);
    const double dry_slope = a / contact.radius * (2.0 * factors.dry_displacement + a * slopes.dry_displacement);
    const double slope = dry_slope - stretch * (0.5 / a - slopes.edge / factors.edge);
    const double stiffness_slope = factors.stiffness + a * slopes.stiffness;
    return {.force = 2.0 * contact.contact_modulus * (a * factors.stiffness * slope - stiffness_slope * stretch),
            .displacement = slope};
}

/// Where force or displacement is least.
double fold(double Slopes::*slope, double half_space_fold, const AdhesiveContact& contact, const Layer& layer) {
    if (half_space_fold == 0.0) return 0.0;
    const auto slope_at = [&](double a) { return slopes_at(a, contact, layer).*slope; };
    const double upper = layer.largest_contact_radius();
    if (slope_at(upper) < 0.0)
        throw InvalidArgument(
            fmt::format("this contact separates at a contact radius above {} layer thicknesses of {} m, where the "
                        "factors of the layer end; use a thicker layer",
                        Layer::largest_ratio, layer.thickness()));
    return numerics::bracketed_root(slope_at, 1e-3 * std::min(half_space_fold, upper), upper);
}

double fold_of_force(const AdhesiveContact& contact, const Layer& layer) {
    return fold(&Slopes::force, jkr::pull_off_at_fixed_load(contact).contact_radius, contact, layer);
}

double fold_of_displacement(const AdhesiveContact& contact, const Layer& layer) {
    return fold(&Slopes::displacement, jkr::pull_off_at_fixed_grips(contact).contact_radius, contact, layer);
}

double radius_at(double value, double State::*member, double fold, const AdhesiveContact& contact, const Layer& layer,
                 Branch branch) {
    const auto excess = [&](double a) { return state_at(a, contact, layer).*member - value; };
    const double at_fold = excess(fold);
    if (!(at_fold <= 0.0)) return undefined;
    if (at_fold == 0.0) return fold;
    if (branch == Branch::inner) return value > 0.0 ? undefined : numerics::bracketed_root(excess, 0.0, fold);
    const double upper = layer.largest_contact_radius();
    if (excess(upper) < 0.0)
        throw InvalidArgument(
            fmt::format("the contact radius would exceed {} layer thicknesses of {} m, where the factors of the layer "
                        "end; use a thicker layer or press less",
                        Layer::largest_ratio, layer.thickness()));
    return numerics::bracketed_root(excess, fold, upper);
}

}  // namespace

double force(double contact_radius, const AdhesiveContact& contact, const Layer& layer) {
    require(contact);
    return state_at(contact_radius, contact, layer).force;
}

double displacement(double contact_radius, const AdhesiveContact& contact, const Layer& layer) {
    require(contact);
    return state_at(contact_radius, contact, layer).displacement;
}

double energy_release_rate_at_force(double contact_radius, double force, const SphereOnFlat& contact,
                                    const Layer& layer) {
    require_sphere(contact.radius, contact.contact_modulus);
    require_positive(contact_radius, "contact radius");
    const Factors factors = layer.factors(contact_radius);
    const double a3 = contact_radius * contact_radius * contact_radius;
    const double missing = 4.0 / 3.0 * contact.contact_modulus * a3 / contact.radius * factors.dry_force - force;
    const double share = missing * factors.edge / factors.stiffness;
    return share * share / (8.0 * pi * contact.contact_modulus * a3);
}

double contact_radius_at_force(double force, const AdhesiveContact& contact, const Layer& layer, Branch branch) {
    require(contact);
    return radius_at(force, &State::force, fold_of_force(contact, layer), contact, layer, branch);
}

double contact_radius_at_displacement(double displacement, const AdhesiveContact& contact, const Layer& layer,
                                      Branch branch) {
    require(contact);
    return radius_at(displacement, &State::displacement, fold_of_displacement(contact, layer), contact, layer, branch);
}

Array1D contact_radius_at_force(const ArrayView1D& force, const AdhesiveContact& contact, const Layer& layer,
                                Branch branch) {
    require(contact);
    const double fold = fold_of_force(contact, layer);
    return mapped(force, [&](double f) { return radius_at(f, &State::force, fold, contact, layer, branch); });
}

Array1D contact_radius_at_displacement(const ArrayView1D& displacement, const AdhesiveContact& contact,
                                       const Layer& layer, Branch branch) {
    require(contact);
    const double fold = fold_of_displacement(contact, layer);
    return mapped(displacement,
                  [&](double d) { return radius_at(d, &State::displacement, fold, contact, layer, branch); });
}

State pull_off_at_fixed_load(const AdhesiveContact& contact, const Layer& layer) {
    require(contact);
    return state_at(fold_of_force(contact, layer), contact, layer);
}

State pull_off_at_fixed_grips(const AdhesiveContact& contact, const Layer& layer) {
    require(contact);
    return state_at(fold_of_displacement(contact, layer), contact, layer);
}

}  // namespace setae::contact::layer
