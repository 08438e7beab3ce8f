// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/transition.hpp"

#include <cmath>

#include <fmt/format.h>

#include "domain.hpp"
#include "mapped.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact::transition {
namespace {

constexpr double relation_scale = 0.924, relation_share = 1.02;

void require(const RadiusCurve& curve) {
    require_positive(curve.zero_load_radius, "contact radius at zero load");
    if (!(curve.pull_off_force < 0.0) || std::isinf(curve.pull_off_force))
        throw InvalidArgument(fmt::format("pull-off force must be < 0 and finite, got {}", curve.pull_off_force));
    if (!(curve.transition_share >= 0.0 && curve.transition_share <= 1.0))
        throw InvalidArgument(fmt::format("transition share must lie in [0, 1], got {}", curve.transition_share));
}

/// The contact of R = 1, W = 1/π, K = 1, where Maugis' units are 1.
maugis_dugdale::Contact unit_contact(double lambda) {
    return {.radius = 1.0, .contact_modulus = 0.75, .work_of_adhesion = 1.0 / pi, .cohesive_stress = 0.5 * lambda};
}

}  // namespace

double contact_radius(double force, const RadiusCurve& curve) {
    require(curve);
    const double excess = 1.0 - force / curve.pull_off_force;
    if (!(excess >= 0.0)) return undefined;
    const double alpha = curve.transition_share;
    const double share = std::cbrt((alpha + std::sqrt(excess)) / (1.0 + alpha));
    return curve.zero_load_radius * share * share;
}

double force(double contact_radius, const RadiusCurve& curve) {
    require(curve);
    require_not_negative(contact_radius, "contact radius");
    const double share = contact_radius / curve.zero_load_radius;
    const double root = (1.0 + curve.transition_share) * share * std::sqrt(share) - curve.transition_share;
    // rounding may put the radius at pull-off a hair below it
    if (!(root >= -1e-14)) return undefined;
    return curve.pull_off_force * (1.0 - root) * (1.0 + root);
}

Array1D contact_radius(const ArrayView1D& force, const RadiusCurve& curve) {
    return mapped(force, [&](double f) { return contact_radius(f, curve); });
}

Array1D force(const ArrayView1D& contact_radius, const RadiusCurve& curve) {
    return mapped(contact_radius, [&](double a) { return force(a, curve); });
}

double transition_share(double transition_parameter) {
    require_positive(transition_parameter, "transition parameter");
    return -std::expm1(-transition_parameter / relation_scale) / relation_share;
}

double transition_parameter(double transition_share) {
    if (!(transition_share > 0.0 && relation_share * transition_share < 1.0))
        throw InvalidArgument(
            fmt::format("transition share must lie in (0, {:.4f}) to give a transition parameter, got {}; above this "
                        "range the contact follows JKR, at 0 DMT",
                        1.0 / relation_share, transition_share));
    return -relation_scale * std::log1p(-relation_share * transition_share);
}

RadiusCurve curve_of(const maugis_dugdale::Contact& contact) {
    return {.zero_load_radius = maugis_dugdale::contact_radius_at_force(0.0, contact),
            .pull_off_force = maugis_dugdale::pull_off_at_fixed_load(contact).force,
            .transition_share = transition_share(maugis_dugdale::transition_parameter(contact))};
}

maugis_dugdale::Contact contact_of(const RadiusCurve& curve, double radius) {
    require(curve);
    require_positive(radius, "sphere radius");
    const double lambda = transition_parameter(curve.transition_share);
    const maugis_dugdale::Contact unit = unit_contact(lambda);
    const double work = curve.pull_off_force / maugis_dugdale::pull_off_at_fixed_load(unit).force / (pi * radius);
    // a0 = Â0 (πWR²/K)^(1/3), K = 4E*/3
    const double scale = maugis_dugdale::contact_radius_at_force(0.0, unit) / curve.zero_load_radius;
    const double modulus = 0.75 * pi * work * radius * radius * scale * scale * scale;
    const double stress = maugis_dugdale::cohesive_stress(
        lambda, {.radius = radius, .contact_modulus = modulus, .work_of_adhesion = work});
    return {.radius = radius, .contact_modulus = modulus, .work_of_adhesion = work, .cohesive_stress = stress};
}

}  // namespace setae::contact::transition
