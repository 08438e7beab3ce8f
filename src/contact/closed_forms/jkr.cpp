// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/jkr.hpp"

#include <algorithm>
#include <cmath>

#include "domain.hpp"
#include "mapped.hpp"
#include "setae/contact/jkr_curve.hpp"
#include "setae/core/constants.hpp"

namespace setae::contact::jkr {
namespace {

double cube(double x) { return x * x * x; }

void require(const Contact& contact) {
    require_sphere(contact.radius, contact.contact_modulus);
    require_not_negative(contact.work_of_adhesion, "work of adhesion");
}

/// P = 3/2 πRW [N], the magnitude of the pull-off force under a fixed load.
double pull_off_magnitude(const Contact& contact) { return 1.5 * pi * contact.radius * contact.work_of_adhesion; }

/// Radius at pull-off under fixed grips, a_c³ = πWR²/(8E*).
double critical_radius(const Contact& contact) {
    return std::cbrt(pi * contact.work_of_adhesion * contact.radius * contact.radius / (8.0 * contact.contact_modulus));
}

/// The root v >= 0 of v √(v² + 4 sign v + 6) = s, s >= 0: sign +1 on the outer branch, −1 on the inner one (v <= 1).
/// The left side is convex (outer) or concave (inner) and increasing, and the start is where Newton's steps approach
/// the root from one side.
double distance_from_fold(double s, double sign) {
    double v = s / std::sqrt(6.0);
    if (sign > 0.0) v = std::min(v, std::sqrt(s));
    constexpr int max_steps = 60;
    for (int step = 0; step < max_steps; ++step) {
        const double root = std::sqrt(v * v + sign * 4.0 * v + 6.0);
        const double change = (v * root - s) * root / (2.0 * (v * v + sign * 3.0 * v + 3.0));
        v -= change;
        if (std::abs(change) <= 1e-16 * v) break;
    }
    return v;
}

}  // namespace

double force(double contact_radius, const Contact& contact) {
    require(contact);
    require_not_negative(contact_radius, "contact radius");
    const double a3 = cube(contact_radius);
    return 4.0 / 3.0 * contact.contact_modulus * a3 / contact.radius -
           std::sqrt(8.0 * pi * contact.contact_modulus * contact.work_of_adhesion * a3);
}

double displacement(double contact_radius, const Contact& contact) {
    require(contact);
    require_not_negative(contact_radius, "contact radius");
    return contact_radius * contact_radius / contact.radius -
           std::sqrt(2.0 * pi * contact_radius * contact.work_of_adhesion / contact.contact_modulus);
}

double contact_radius_at_force(double force, const Contact& contact, Branch branch) {
    require(contact);
    const double pull_off = pull_off_magnitude(contact);
    if (!(force >= -pull_off)) return undefined;
    const double sum = std::sqrt(pull_off) + std::sqrt(force + pull_off);
    double root = sum;
    if (branch == Branch::inner) {
        if (force > 0.0) return undefined;
        root = sum == 0.0 ? 0.0 : -force / sum;  // √P − √(F + P)
    }
    return std::cbrt(0.75 * contact.radius / contact.contact_modulus * root * root);
}

double contact_radius_at_displacement(double displacement, const Contact& contact, Branch branch) {
    require(contact);
    if (branch == Branch::inner && displacement > 0.0) return undefined;
    const double critical = critical_radius(contact);
    if (critical == 0.0) return displacement >= 0.0 ? std::sqrt(contact.radius * displacement) : undefined;
    // δ_c = −3 a_c²/R; 3 (1 − δ/δ_c) = 3 + δR/a_c²
    const double excess = 3.0 + displacement * contact.radius / (critical * critical);
    if (!(excess >= 0.0)) return undefined;
    const double sign = branch == Branch::outer ? 1.0 : -1.0;
    const double root = std::max(0.0, 1.0 + sign * distance_from_fold(std::sqrt(excess), sign));
    return critical * root * root;
}

double force_at_displacement(double displacement, const Contact& contact, Branch branch) {
    const double a = contact_radius_at_displacement(displacement, contact, branch);
    return std::isnan(a) ? undefined : force_at(a, displacement, {contact.radius, contact.contact_modulus});
}

double displacement_at_force(double force, const Contact& contact, Branch branch) {
    const double a = contact_radius_at_force(force, contact, branch);
    return std::isnan(a) ? undefined : displacement(a, contact);
}

Array1D contact_radius_at_force(const ArrayView1D& force, const Contact& contact, Branch branch) {
    return mapped(force, [&](double f) { return contact_radius_at_force(f, contact, branch); });
}

Array1D contact_radius_at_displacement(const ArrayView1D& displacement, const Contact& contact, Branch branch) {
    return mapped(displacement, [&](double d) { return contact_radius_at_displacement(d, contact, branch); });
}

Array1D force_at_displacement(const ArrayView1D& displacement, const Contact& contact, Branch branch) {
    return mapped(displacement, [&](double d) { return force_at_displacement(d, contact, branch); });
}

Array1D displacement_at_force(const ArrayView1D& force, const Contact& contact, Branch branch) {
    return mapped(force, [&](double f) { return displacement_at_force(f, contact, branch); });
}

double force_at(double contact_radius, double displacement, const SphereOnFlat& contact) {
    require_sphere(contact.radius, contact.contact_modulus);
    require_not_negative(contact_radius, "contact radius");
    return 2.0 * contact_radius * contact.contact_modulus *
           (displacement - contact_radius * contact_radius / (3.0 * contact.radius));
}

double contact_radius_at(double force, double displacement, const SphereOnFlat& contact) {
    require_sphere(contact.radius, contact.contact_modulus);
    // a³ − 3p a + 2q = 0, increasing for a² > p
    const double p = contact.radius * displacement;
    const double q = 0.75 * contact.radius * force / contact.contact_modulus;
    const double discriminant = q * q - cube(p);
    if (p > 0.0 && discriminant <= 0.0) {
        const double root = std::sqrt(p);
        return 2.0 * root * std::cos(std::acos(std::clamp(-q / (p * root), -1.0, 1.0)) / 3.0);
    }
    if (!(q <= 0.0)) return undefined;
    // one real root: with s³ = −q + √(q² − p³), a = s + p/s; for p < 0 the sum cancels, so it is written as a quotient
    const double s = std::cbrt(-q + std::sqrt(discriminant));
    if (s == 0.0) return 0.0;
    if (p >= 0.0) return s + p / s;
    const double t = -p / s;
    return -2.0 * q / (s * s + s * t + t * t);
}

double energy_release_rate_at_force(double contact_radius, double force, const SphereOnFlat& contact) {
    require_sphere(contact.radius, contact.contact_modulus);
    require_positive(contact_radius, "contact radius");
    return energy_release_slopes(contact_radius, force, contact).value;
}

double energy_release_rate_at_displacement(double contact_radius, double displacement, const SphereOnFlat& contact) {
    require_sphere(contact.radius, contact.contact_modulus);
    require_positive(contact_radius, "contact radius");
    const double missing = displacement - contact_radius * contact_radius / contact.radius;
    return contact.contact_modulus * missing * missing / (2.0 * pi * contact_radius);
}

double total_energy(double contact_radius, double displacement, const Contact& contact) {
    require(contact);
    require_not_negative(contact_radius, "contact radius");
    const double a = contact_radius;
    const double flat = a * a / contact.radius;
    return contact.contact_modulus * a *
               (displacement * displacement - 2.0 / 3.0 * displacement * flat + 0.2 * flat * flat) -
           pi * contact.work_of_adhesion * a * a;
}

State pull_off_at_fixed_load(const Contact& contact) {
    require(contact);
    const double a = std::cbrt(9.0) * critical_radius(contact);
    return {
        .force = -pull_off_magnitude(contact), .displacement = -a * a / (3.0 * contact.radius), .contact_radius = a};
}

State pull_off_at_fixed_grips(const Contact& contact) {
    require(contact);
    const double a = critical_radius(contact);
    return {.force = -5.0 / 9.0 * pull_off_magnitude(contact),
            .displacement = -3.0 * a * a / contact.radius,
            .contact_radius = a};
}

State jump_in_at_fixed_grips(const Contact& contact) {
    require(contact);
    return {.force = -8.0 / 9.0 * pull_off_magnitude(contact),
            .displacement = 0.0,
            .contact_radius = std::cbrt(16.0) * critical_radius(contact)};
}

LoopLoss ideal_loop_loss(const Contact& contact) {
    const double a_in = jump_in_at_fixed_grips(contact).contact_radius;
    const double a_out = pull_off_at_fixed_grips(contact).contact_radius;
    const double jump_in = 0.6 * pi * contact.work_of_adhesion * a_in * a_in;
    const double jump_out = 0.4 * pi * contact.work_of_adhesion * a_out * a_out;
    return {.jump_in = jump_in, .jump_out = jump_out, .total = jump_in + jump_out};
}

double work_of_adhesion_from_pull_off(double pull_off_force, double radius, Control control) {
    require_positive(radius, "sphere radius");
    const double factor = control == Control::fixed_load ? 2.0 / 3.0 : 1.2;
    return factor * std::abs(pull_off_force) / (pi * radius);
}

MaugisUnits maugis_units(const Contact& contact) {
    require(contact);
    require_positive(contact.work_of_adhesion, "work of adhesion");
    // a_c³ = πWR²/(8E*) = πWR²/(6K)
    const double length = std::cbrt(6.0) * critical_radius(contact);
    const double height = length * length / contact.radius;
    const double force = pi * contact.radius * contact.work_of_adhesion;
    return {.length = length, .height = height, .force = force, .energy = force * height};
}

double tabor_parameter(const Contact& contact, double interaction_range) {
    require(contact);
    require_positive(interaction_range, "interaction range");
    const double ratio = contact.work_of_adhesion / contact.contact_modulus;
    return std::cbrt(contact.radius * ratio * ratio) / interaction_range;
}

}  // namespace setae::contact::jkr
