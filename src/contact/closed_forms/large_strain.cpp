// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/large_strain.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "domain.hpp"
#include "mapped.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::contact::large_strain {
namespace {

// everything below is in units of R and E*: x = a/R, force E*R², adhesion w = W/(E*R)
constexpr double largest_share = 1.0 - 1e-9;

double adhesion(const Contact& contact) {
    require_sphere(contact.radius, contact.contact_modulus);
    require_not_negative(contact.work_of_adhesion, "work of adhesion");
    const double w = contact.work_of_adhesion / (contact.contact_modulus * contact.radius);
    if (!(w <= 1e6))
        throw InvalidArgument(fmt::format("work of adhesion must be <= 1e6 E*R, got {} E*R; check the units", w));
    return w;
}

double share_of_radius(double contact_radius, double radius) {
    require_not_negative(contact_radius, "contact radius");
    if (!(contact_radius < radius))
        throw InvalidArgument(
            fmt::format("contact radius {} m is not below the sphere radius {} m; check the units of both",
                        contact_radius, radius));
    return contact_radius / radius;
}

/// (1 + x²) artanh x − x, by its series where the two terms cancel.
double dry_force(double x) {
    if (x > 0.25) return (1.0 + x * x) * std::atanh(x) - x;
    double sum = 0.0;
    for (int k = 14; k >= 1; --k) sum = sum * x * x + 4.0 * k / (4.0 * k * k - 1.0);
    return sum * x * x * x;
}

double scaled_force(double x, double w) { return dry_force(x) - std::sqrt(8.0 * pi * w * x) * x; }
double scaled_displacement(double x, double w) { return x * std::atanh(x) - std::sqrt(2.0 * pi * w * x); }

/// Where dF/da = 0: below the fold of the paraboloid, since the sphere is the blunter body.
double fold_of_force(double w) {
    if (w == 0.0) return 0.0;
    const double upper = std::min(std::cbrt(9.0 * pi * w / 8.0), largest_share);
    const auto slope = [w](double x) {
        return 2.0 * x * (std::atanh(x) + x / (1.0 - x * x)) - 1.5 * std::sqrt(8.0 * pi * w * x);
    };
    return numerics::bracketed_root(slope, 1e-3 * upper, upper);
}

/// Where dδ/da = 0.
double fold_of_displacement(double w) {
    if (w == 0.0) return 0.0;
    const double upper = std::min(std::cbrt(pi * w / 8.0), largest_share);
    const auto slope = [w](double x) { return std::atanh(x) + x / (1.0 - x * x) - 0.5 * std::sqrt(2.0 * pi * w / x); };
    return numerics::bracketed_root(slope, 1e-3 * upper, upper);
}

/// x where a curve that decreases from 0 to its fold and increases beyond has a value; NaN where it does not reach it.
template <class Curve>
double share_at(double value, double fold, Branch branch, Curve&& curve) {
    const double end = branch == Branch::outer ? largest_share : 0.0;
    const double least = curve(fold);
    if (!(value >= least && value <= curve(end))) return undefined;
    if (value == least) return fold;
    return numerics::bracketed_root([&](double x) { return curve(x) - value; }, fold, end);
}

double radius_at_force(double force, const Contact& contact, Branch branch, double w, double fold) {
    const double unit = contact.contact_modulus * contact.radius * contact.radius;
    return contact.radius * share_at(force / unit, fold, branch, [w](double x) { return scaled_force(x, w); });
}

double radius_at_displacement(double displacement, const Contact& contact, Branch branch, double w, double fold) {
    return contact.radius *
           share_at(displacement / contact.radius, fold, branch, [w](double x) { return scaled_displacement(x, w); });
}

State state_at(double x, double w, const Contact& contact) {
    return {.force = scaled_force(x, w) * contact.contact_modulus * contact.radius * contact.radius,
            .displacement = scaled_displacement(x, w) * contact.radius,
            .contact_radius = x * contact.radius};
}

double force_of(double contact_radius, const Contact& contact) {
    return std::isnan(contact_radius) ? undefined : force(contact_radius, contact);
}

}  // namespace

double force(double contact_radius, const Contact& contact) {
    const double w = adhesion(contact);
    return state_at(share_of_radius(contact_radius, contact.radius), w, contact).force;
}

double displacement(double contact_radius, const Contact& contact) {
    const double w = adhesion(contact);
    return state_at(share_of_radius(contact_radius, contact.radius), w, contact).displacement;
}

double energy_release_rate_at_force(double contact_radius, double force, const SphereOnFlat& contact) {
    require_sphere(contact.radius, contact.contact_modulus);
    require_positive(contact_radius, "contact radius");
    const double x = share_of_radius(contact_radius, contact.radius);
    const double missing = dry_force(x) * contact.contact_modulus * contact.radius * contact.radius - force;
    return missing * missing / (8.0 * pi * contact.contact_modulus * contact_radius * contact_radius * contact_radius);
}

double contact_radius_at_force(double force, const Contact& contact, Branch branch) {
    const double w = adhesion(contact);
    return radius_at_force(force, contact, branch, w, fold_of_force(w));
}

double contact_radius_at_displacement(double displacement, const Contact& contact, Branch branch) {
    const double w = adhesion(contact);
    return radius_at_displacement(displacement, contact, branch, w, fold_of_displacement(w));
}

double force_at_displacement(double displacement, const Contact& contact, Branch branch) {
    return force_of(contact_radius_at_displacement(displacement, contact, branch), contact);
}

Array1D contact_radius_at_force(const ArrayView1D& force, const Contact& contact, Branch branch) {
    const double w = adhesion(contact);
    const double fold = fold_of_force(w);
    return mapped(force, [&](double f) { return radius_at_force(f, contact, branch, w, fold); });
}

Array1D contact_radius_at_displacement(const ArrayView1D& displacement, const Contact& contact, Branch branch) {
    const double w = adhesion(contact);
    const double fold = fold_of_displacement(w);
    return mapped(displacement, [&](double d) { return radius_at_displacement(d, contact, branch, w, fold); });
}

Array1D force_at_displacement(const ArrayView1D& displacement, const Contact& contact, Branch branch) {
    return mapped(contact_radius_at_displacement(displacement, contact, branch),
                  [&](double a) { return force_of(a, contact); });
}

State pull_off_at_fixed_load(const Contact& contact) {
    const double w = adhesion(contact);
    return state_at(fold_of_force(w), w, contact);
}

State pull_off_at_fixed_grips(const Contact& contact) {
    const double w = adhesion(contact);
    return state_at(fold_of_displacement(w), w, contact);
}

}  // namespace setae::contact::large_strain
