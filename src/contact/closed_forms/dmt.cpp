// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/dmt.hpp"

#include <cmath>

#include "domain.hpp"
#include "mapped.hpp"
#include "setae/core/constants.hpp"

namespace setae::contact::dmt {
namespace {

void require(const AdhesiveContact& contact) {
    require_sphere(contact.radius, contact.contact_modulus);
    require_not_negative(contact.work_of_adhesion, "work of adhesion");
}

/// 2πRW [N], the attraction that adds to the load.
double attraction(const AdhesiveContact& contact) { return 2.0 * pi * contact.radius * contact.work_of_adhesion; }

}  // namespace

double force(double contact_radius, const AdhesiveContact& contact) {
    require(contact);
    require_not_negative(contact_radius, "contact radius");
    return 4.0 / 3.0 * contact.contact_modulus * contact_radius * contact_radius * contact_radius / contact.radius -
           attraction(contact);
}

double displacement(double contact_radius, const AdhesiveContact& contact) {
    require(contact);
    require_not_negative(contact_radius, "contact radius");
    return contact_radius * contact_radius / contact.radius;
}

double contact_radius_at_force(double force, const AdhesiveContact& contact) {
    require(contact);
    const double pressing = force + attraction(contact);
    if (!(pressing >= 0.0)) return undefined;
    return std::cbrt(0.75 * contact.radius * pressing / contact.contact_modulus);
}

double contact_radius_at_displacement(double displacement, const AdhesiveContact& contact) {
    require(contact);
    if (!(displacement >= 0.0)) return undefined;
    return std::sqrt(contact.radius * displacement);
}

double force_at_displacement(double displacement, const AdhesiveContact& contact) {
    const double a = contact_radius_at_displacement(displacement, contact);
    return std::isnan(a) ? undefined : force(a, contact);
}

double displacement_at_force(double force, const AdhesiveContact& contact) {
    const double a = contact_radius_at_force(force, contact);
    return std::isnan(a) ? undefined : displacement(a, contact);
}

Array1D contact_radius_at_force(const ArrayView1D& force, const AdhesiveContact& contact) {
    return mapped(force, [&](double f) { return contact_radius_at_force(f, contact); });
}

Array1D contact_radius_at_displacement(const ArrayView1D& displacement, const AdhesiveContact& contact) {
    return mapped(displacement, [&](double d) { return contact_radius_at_displacement(d, contact); });
}

Array1D force_at_displacement(const ArrayView1D& displacement, const AdhesiveContact& contact) {
    return mapped(displacement, [&](double d) { return force_at_displacement(d, contact); });
}

Array1D displacement_at_force(const ArrayView1D& force, const AdhesiveContact& contact) {
    return mapped(force, [&](double f) { return displacement_at_force(f, contact); });
}

ContactState pull_off(const AdhesiveContact& contact) {
    require(contact);
    return {.force = -attraction(contact)};
}

double work_of_adhesion_from_pull_off(double pull_off_force, double radius) {
    require_positive(radius, "sphere radius");
    require_not_negative(std::abs(pull_off_force), "magnitude of the pull-off force");
    return std::abs(pull_off_force) / (2.0 * pi * radius);
}

}  // namespace setae::contact::dmt
