// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/hertz.hpp"

#include <cmath>

#include "domain.hpp"
#include "setae/core/constants.hpp"

namespace setae::contact::hertz {
namespace {

void require(double value, const char* what, const SphereOnFlat& contact) {
    require_sphere(contact.radius, contact.contact_modulus);
    require_not_negative(value, what);
}

}  // namespace

double force(double penetration, const SphereOnFlat& contact) {
    require(penetration, "penetration", contact);
    return 4.0 / 3.0 * contact.contact_modulus * std::sqrt(contact.radius * penetration) * penetration;
}

double contact_radius(double force, const SphereOnFlat& contact) {
    require(force, "force of a contact without adhesion", contact);
    return std::cbrt(0.75 * contact.radius * force / contact.contact_modulus);
}

double penetration(double force, const SphereOnFlat& contact) {
    const double a = contact_radius(force, contact);
    return a * a / contact.radius;
}

double energy(double penetration, const SphereOnFlat& contact) {
    return 0.4 * force(penetration, contact) * penetration;
}

}  // namespace setae::contact::hertz
