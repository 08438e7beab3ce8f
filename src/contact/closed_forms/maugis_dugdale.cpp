// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/maugis_dugdale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "domain.hpp"
#include "mapped.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::contact::maugis_dugdale {
namespace {

/// Far beyond both limits, and λ² and its squares stay numbers.
void require_transition_parameter(double lambda) {
    if (!(lambda >= 1e-30 && lambda <= 1e30))
        throw InvalidArgument(
            fmt::format("transition parameter must lie in [1e-30, 1e30], got {}; check the units of the "
                        "cohesive stress",
                        lambda));
}

/// A point of the curve and its derivatives by s.
struct Point {
    double radius, force, displacement;
    double radius_slope, force_slope, displacement_slope;
};

/// s − atan s, by its series where they cancel.
double excess_over_arctangent(double s) {
    if (s > 0.25) return s - std::atan(s);
    double sum = 0.0;
    for (int k = 14; k >= 1; --k) sum = 1.0 / (2.0 * k + 1.0) - sum * s * s;
    return sum * s * s * s;
}

/// The state at s = √(m² − 1), for which the first equation reads p A² + 2q A = 1.
Point point_at(double s, double lambda) {
    const double arc = std::atan(s), s2 = s * s, m = std::sqrt(1.0 + s2);
    const double p = 0.5 * lambda * (excess_over_arctangent(s) + s2 * arc);
    const double q = 2.0 / 3.0 * lambda * lambda * (s * (arc - s / (1.0 + m)));
    const double p_slope = lambda * (s * arc + s2 / (1.0 + s2));
    const double q_slope = 2.0 / 3.0 * lambda * lambda * (arc + s / (1.0 + s2) - s / m);
    const double root = std::sqrt(q * q + p);
    const double a = 1.0 / (q + root);
    const double a_slope = -0.5 * a * (p_slope * a + 2.0 * q_slope) / root;  // p A + q = √(q² + p)
    const double g = s + (1.0 + s2) * arc, g_slope = 2.0 + 2.0 * s * arc;
    return {.radius = a,
            .force = a * a * (a - lambda * g),
            .displacement = a * (a - 4.0 / 3.0 * lambda * s),
            .radius_slope = a_slope,
            .force_slope = a * (3.0 * a * a_slope - lambda * (2.0 * a_slope * g + a * g_slope)),
            .displacement_slope = 2.0 * a * a_slope - 4.0 / 3.0 * lambda * (a_slope * s + a)};
}

/// Reduced outer radius c of the cohesive zone where the contact has just vanished: λπ/4 c² + 4λ²/3 (π/2 − 1) c = 1.
double zone_of_vanished_contact(double lambda) {
    const double p = 0.25 * pi * lambda, q = 2.0 / 3.0 * lambda * lambda * (0.5 * pi - 1.0);
    return 1.0 / (q + std::sqrt(q * q + p));
}

ReducedState vanished_contact(double lambda) {
    const double c = zone_of_vanished_contact(lambda);
    return {.force = -0.5 * pi * lambda * c * c,
            .displacement = -4.0 / 3.0 * lambda * c,
            .contact_radius = 0.0,
            .zone_ratio = std::numeric_limits<double>::infinity()};
}

ReducedState reduced(double s, double lambda) {
    const Point point = point_at(s, lambda);
    return {.force = point.force,
            .displacement = point.displacement,
            .contact_radius = point.radius,
            .zone_ratio = std::hypot(1.0, s)};
}

/// s at reduced radius A > 0. What bounds A from above at each s, pA² < 1 with p < λ π s²/4 or p < 2λs³/3 and
/// 2qA < 1 with q < λ²s²/3, starts the search: Newton's steps on ln A(ln s), which bends little, within brackets where
/// they fail.
double zone_at_radius(double radius, double lambda) {
    double lower = std::min(std::sqrt(1.5 / radius) / lambda, std::sqrt(4.0 / (pi * lambda)) / radius);
    double s = lower;
    for (int round = 0; round < 30; ++round) {
        const Point point = point_at(s, lambda);
        const double excess = std::log(point.radius / radius);
        if (std::abs(excess) < 1e-15) return s;
        const double step = excess * point.radius / (point.radius_slope * s);
        if (!(std::abs(step) < 3.0)) break;
        s *= std::exp(-step);
        if (std::abs(step) < 1e-15) return s;
    }
    const auto difference = [&](double zone) { return point_at(zone, lambda).radius - radius; };
    while (!(difference(lower) >= 0.0)) lower *= 0.5;
    double upper = lower;
    while (difference(upper) > 0.0) upper *= 2.0;
    return numerics::bracketed_root(difference, std::max(lower, 0.5 * upper), upper);
}

/// s where the force is least; contacts have radii between λ (or 1/2) and 2 there.
double zone_at_min_force(double lambda) {
    const auto slope = [&](double s) { return point_at(s, lambda).force_slope; };
    const double lower = zone_at_radius(2.0, lambda);
    const double upper = zone_at_radius(std::min(lambda, 0.5), lambda);
    if (!(slope(upper) > 0.0)) return upper;  // λ < 1e-5: flat to rounding
    return numerics::bracketed_root(slope, lower, upper);
}

/// s where the displacement is least, NaN where it falls all the way to A = 0.
double zone_at_min_displacement(double lambda) {
    const auto slope = [&](double s) { return point_at(s, lambda).displacement_slope; };
    const double upper = zone_at_radius(1e-4, lambda);
    if (!(slope(upper) > 0.0)) return undefined;
    return numerics::bracketed_root(slope, zone_at_radius(2.0, lambda), upper);
}

/// Reference values of forces, or displacements, of a curve.
struct Fold {
    double zone;      ///< s of the least value; NaN where that is at A = 0
    double least;     ///< the least value
    double vanished;  ///< the value at A = 0
};

Fold fold_of_force(double lambda) {
    const double zone = zone_at_min_force(lambda);
    return {.zone = zone, .least = point_at(zone, lambda).force, .vanished = vanished_contact(lambda).force};
}

Fold fold_of_displacement(double lambda) {
    const double zone = zone_at_min_displacement(lambda), vanished = vanished_contact(lambda).displacement;
    return {
        .zone = zone, .least = std::isnan(zone) ? vanished : point_at(zone, lambda).displacement, .vanished = vanished};
}

/// Reduced radius where a member of Point has a value.
double radius_at(double value, double Point::*member, double lambda, const Fold& fold, Branch branch) {
    if (!(value >= fold.least) || std::isinf(value)) return undefined;
    const auto excess = [&](double s) { return point_at(s, lambda).*member - value; };
    const bool has_fold = !std::isnan(fold.zone);
    if (branch == Branch::inner) {
        if (!has_fold || value > fold.vanished) return undefined;
        double lower = fold.zone, upper = 2.0 * lower;
        // beyond, A² is lost in rounding
        const double last = 1e9 * std::max(fold.zone, zone_of_vanished_contact(lambda));
        while (excess(upper) < 0.0 && upper < last) {
            lower = upper;
            upper *= 2.0;
        }
        if (!(excess(upper) > 0.0)) return 0.0;
        return point_at(numerics::bracketed_root(excess, lower, upper), lambda).radius;
    }
    double upper = has_fold ? fold.zone : 1e9 * zone_of_vanished_contact(lambda);
    if (!(excess(upper) < 0.0)) return has_fold ? point_at(upper, lambda).radius : 0.0;
    double lower = has_fold ? upper : zone_at_radius(1.0, lambda);
    while (excess(lower) < 0.0) {
        upper = lower;
        lower *= 0.5;
    }
    return point_at(numerics::bracketed_root(excess, lower, upper), lambda).radius;
}

AdhesiveContact without_range(const Contact& contact) {
    return {.radius = contact.radius,
            .contact_modulus = contact.contact_modulus,
            .work_of_adhesion = contact.work_of_adhesion};
}

/// Scales and λ of a contact.
struct Scaled {
    explicit Scaled(const Contact& contact) : units(jkr::maugis_units(without_range(contact))) {
        require_positive(contact.cohesive_stress, "cohesive stress");
        // (πWK²/R)^(1/3) = K · length/R
        lambda = 1.5 * contact.cohesive_stress * contact.radius / (contact.contact_modulus * units.length);
        require_transition_parameter(lambda);
    }
    [[nodiscard]] State state(const ReducedState& at) const {
        return {.force = at.force * units.force,
                .displacement = at.displacement * units.height,
                .contact_radius = at.contact_radius * units.length};
    }
    jkr::MaugisUnits units;
    double lambda;
};

double radius_at_force(double force, const Scaled& scaled, const Fold& fold, Branch branch) {
    return scaled.units.length * radius_at(force / scaled.units.force, &Point::force, scaled.lambda, fold, branch);
}

double radius_at_displacement(double displacement, const Scaled& scaled, const Fold& fold, Branch branch) {
    return scaled.units.length *
           radius_at(displacement / scaled.units.height, &Point::displacement, scaled.lambda, fold, branch);
}

State state_at_radius(double contact_radius, const Scaled& scaled) {
    return scaled.state(reduced_state(contact_radius / scaled.units.length, scaled.lambda));
}

double force_of(double contact_radius, const Scaled& scaled) {
    return std::isnan(contact_radius) ? undefined : state_at_radius(contact_radius, scaled).force;
}

double displacement_of(double contact_radius, const Scaled& scaled) {
    return std::isnan(contact_radius) ? undefined : state_at_radius(contact_radius, scaled).displacement;
}

}  // namespace

ReducedState reduced_state(double reduced_radius, double transition_parameter) {
    require_transition_parameter(transition_parameter);
    require_not_negative(reduced_radius, "contact radius");
    if (std::isinf(reduced_radius)) throw InvalidArgument("contact radius must be finite");
    // the state differs from that at A = 0 by order A²
    if (reduced_radius < 1e-12 * std::min(1.0, zone_of_vanished_contact(transition_parameter)))
        return vanished_contact(transition_parameter);
    return reduced(zone_at_radius(reduced_radius, transition_parameter), transition_parameter);
}

ReducedSlopes reduced_slopes(double reduced_radius, double transition_parameter) {
    require_transition_parameter(transition_parameter);
    if (!(reduced_radius >= 1e-9) || std::isinf(reduced_radius))
        throw InvalidArgument(fmt::format("reduced contact radius must be >= 1e-9 and finite, got {}", reduced_radius));
    const double lambda = transition_parameter;
    const double s = zone_at_radius(reduced_radius, lambda);
    const Point point = point_at(s, lambda);
    const double a = point.radius, arc = std::atan(s), s2 = s * s;
    // p ∝ λ and q ∝ λ² in p A² + 2q A = 1, which gives A's derivative by λ at given s, and that of s at given A
    const double q = 2.0 / 3.0 * lambda * lambda * (s * (arc - s / (1.0 + std::sqrt(1.0 + s2))));
    const double p = (1.0 - 2.0 * q * a) / (a * a);
    const double a_by_lambda = -0.5 * a * (p * a + 4.0 * q) / (lambda * (p * a + q));
    const double s_by_lambda = -a_by_lambda / point.radius_slope;
    const double g = s + (1.0 + s2) * arc;
    return {.state = {.force = point.force,
                      .displacement = point.displacement,
                      .contact_radius = a,
                      .zone_ratio = std::hypot(1.0, s)},
            .force_by_radius = point.force_slope / point.radius_slope,
            .force_by_transition =
                -a * a * g + (a_by_lambda * (3.0 * a - 2.0 * lambda * g) * a) + point.force_slope * s_by_lambda,
            .displacement_by_radius = point.displacement_slope / point.radius_slope,
            .displacement_by_transition = -4.0 / 3.0 * a * s + a_by_lambda * (2.0 * a - 4.0 / 3.0 * lambda * s) +
                                          point.displacement_slope * s_by_lambda};
}

ReducedState reduced_pull_off_at_fixed_load(double transition_parameter) {
    require_transition_parameter(transition_parameter);
    return reduced(zone_at_min_force(transition_parameter), transition_parameter);
}

ReducedState reduced_pull_off_at_fixed_grips(double transition_parameter) {
    require_transition_parameter(transition_parameter);
    const double zone = zone_at_min_displacement(transition_parameter);
    return std::isnan(zone) ? vanished_contact(transition_parameter) : reduced(zone, transition_parameter);
}

double transition_parameter(const Contact& contact) { return Scaled(contact).lambda; }

double cohesive_stress(double transition_parameter, const AdhesiveContact& contact) {
    require_transition_parameter(transition_parameter);
    return transition_parameter * contact.contact_modulus * jkr::maugis_units(contact).length / (1.5 * contact.radius);
}

double force(double contact_radius, const Contact& contact) {
    return state_at_radius(contact_radius, Scaled(contact)).force;
}

double displacement(double contact_radius, const Contact& contact) {
    return state_at_radius(contact_radius, Scaled(contact)).displacement;
}

double contact_radius_at_force(double force, const Contact& contact, Branch branch) {
    const Scaled scaled(contact);
    return radius_at_force(force, scaled, fold_of_force(scaled.lambda), branch);
}

double contact_radius_at_displacement(double displacement, const Contact& contact, Branch branch) {
    const Scaled scaled(contact);
    return radius_at_displacement(displacement, scaled, fold_of_displacement(scaled.lambda), branch);
}

double force_at_displacement(double displacement, const Contact& contact, Branch branch) {
    return force_of(contact_radius_at_displacement(displacement, contact, branch), Scaled(contact));
}

double displacement_at_force(double force, const Contact& contact, Branch branch) {
    return displacement_of(contact_radius_at_force(force, contact, branch), Scaled(contact));
}

Array1D force(const ArrayView1D& contact_radius, const Contact& contact) {
    const Scaled scaled(contact);
    return mapped(contact_radius, [&](double a) { return state_at_radius(a, scaled).force; });
}

Array1D displacement(const ArrayView1D& contact_radius, const Contact& contact) {
    const Scaled scaled(contact);
    return mapped(contact_radius, [&](double a) { return state_at_radius(a, scaled).displacement; });
}

Array1D contact_radius_at_force(const ArrayView1D& force, const Contact& contact, Branch branch) {
    const Scaled scaled(contact);
    const Fold fold = fold_of_force(scaled.lambda);
    return mapped(force, [&](double f) { return radius_at_force(f, scaled, fold, branch); });
}

Array1D contact_radius_at_displacement(const ArrayView1D& displacement, const Contact& contact, Branch branch) {
    const Scaled scaled(contact);
    const Fold fold = fold_of_displacement(scaled.lambda);
    return mapped(displacement, [&](double d) { return radius_at_displacement(d, scaled, fold, branch); });
}

Array1D force_at_displacement(const ArrayView1D& displacement, const Contact& contact, Branch branch) {
    const Scaled scaled(contact);
    return mapped(contact_radius_at_displacement(displacement, contact, branch),
                  [&](double a) { return force_of(a, scaled); });
}

Array1D displacement_at_force(const ArrayView1D& force, const Contact& contact, Branch branch) {
    const Scaled scaled(contact);
    return mapped(contact_radius_at_force(force, contact, branch),
                  [&](double a) { return displacement_of(a, scaled); });
}

State pull_off_at_fixed_load(const Contact& contact) {
    const Scaled scaled(contact);
    return scaled.state(reduced_pull_off_at_fixed_load(scaled.lambda));
}

State pull_off_at_fixed_grips(const Contact& contact) {
    const Scaled scaled(contact);
    return scaled.state(reduced_pull_off_at_fixed_grips(scaled.lambda));
}

}  // namespace setae::contact::maugis_dugdale
