// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "setae/contact/jkr.hpp"
#include "setae/contact/jkr_curve.hpp"
#include "setae/contact/large_strain.hpp"
#include "setae/contact/maugis_dugdale.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

constexpr double min_curve_lambda = 1e-3, max_curve_lambda = 1e3;

/// F = E* H − √E* w A and δ = D − w B/√E*, w the signed root of W: JKR for whatever shape and body, with slopes by a.
struct EdgeTerms {
    double dry_force, dry_force_slope;                  ///< H
    double edge_force, edge_force_slope;                ///< A
    double dry_displacement, dry_displacement_slope;    ///< D
    double edge_displacement, edge_displacement_slope;  ///< B
};

EdgeTerms half_space_terms(double a, double radius) {
    // E* = 1 and W = 1: every term separately
    const contact::jkr::CurveAt<double> jkr(a);
    const double e = contact::jkr::press_coefficient(1.0, radius), g = contact::jkr::pull_coefficient(1.0),
                 p = 2.0 / 3.0 * g / e / radius;
    return {.dry_force = e * jkr.cube,
            .dry_force_slope = jkr.force_slope(e, 0.0),
            .edge_force = g * jkr.three_halves,
            .edge_force_slope = -jkr.force_slope(0.0, g),
            .dry_displacement = jkr.square / radius,
            .dry_displacement_slope = 2.0 * a / radius,
            .edge_displacement = p * jkr.root,
            .edge_displacement_slope = 0.5 * p * jkr.inverse_root()};
}

EdgeTerms layer_terms(double a, double radius, const contact::layer::Layer& layer) {
    EdgeTerms terms = half_space_terms(a, radius);
    const contact::layer::Factors factor = layer.factors(a), slope = layer.factor_slopes(a);
    terms.dry_force_slope = terms.dry_force_slope * factor.dry_force + terms.dry_force * slope.dry_force;
    terms.dry_force *= factor.dry_force;
    const double stiff = factor.stiffness / factor.edge;
    const double stiff_slope = (slope.stiffness - stiff * slope.edge) / factor.edge;
    terms.edge_force_slope = terms.edge_force_slope * stiff + terms.edge_force * stiff_slope;
    terms.edge_force *= stiff;
    terms.dry_displacement_slope =
        terms.dry_displacement_slope * factor.dry_displacement + terms.dry_displacement * slope.dry_displacement;
    terms.dry_displacement *= factor.dry_displacement;
    terms.edge_displacement_slope =
        (terms.edge_displacement_slope - terms.edge_displacement * slope.edge / factor.edge) / factor.edge;
    terms.edge_displacement /= factor.edge;
    return terms;
}

EdgeTerms sphere_terms(double a, double radius) {
    EdgeTerms terms = half_space_terms(a, radius);
    const contact::AdhesiveContact dry{.radius = radius, .contact_modulus = 1.0};
    const double x = a / radius, steep = x / (1.0 - x * x);
    terms.dry_force = contact::large_strain::force(a, dry);
    terms.dry_force_slope = 2.0 * a * (std::atanh(x) + steep);
    terms.dry_displacement = contact::large_strain::displacement(a, dry);
    terms.dry_displacement_slope = std::atanh(x) + steep;
    return terms;
}

}  // namespace

ModelCurve::ModelCurve(ContactModel model, const LensAndCounterBody& bodies, bool stress_given)
    : model_(model), radius_(bodies.radius), stress_given_(stress_given) {
    if (!(radius_ > 0.0) || std::isinf(radius_))
        throw InvalidArgument(fmt::format("sphere radius must be > 0 m and finite, got {}", radius_));
    if (model != ContactModel::layer) return;
    const auto height = bodies.soft_height();
    if (!height) throw InvalidArgument("the model of a layer needs its thickness; give layer_thickness or choose jkr");
    layer_.emplace(*height, bodies.lens_poisson_ratio);
}

int ModelCurve::parameters() const {
    switch (model_) {
        case ContactModel::hertz: return 1;
        case ContactModel::maugis_dugdale:
        case ContactModel::transition: return 3;
        default: return 2;
    }
}

double ModelCurve::largest_radius() const {
    if (layer_) return layer_->largest_contact_radius();
    // at 1 − 1e-6 the force is some ten times E*R²
    if (model_ == ContactModel::large_strain) return (1.0 - 1e-6) * radius_;
    return std::numeric_limits<double>::infinity();
}

double ModelCurve::work_of_adhesion(const CurveParameters& parameters) const {
    switch (model_) {
        case ContactModel::hertz: return 0.0;
        case ContactModel::dmt: return parameters[1];
        case ContactModel::maugis_dugdale: return std::exp(parameters[1]);
        default: return parameters[1] * std::abs(parameters[1]);
    }
}

double ModelCurve::work_slot(double work_of_adhesion) const {
    switch (model_) {
        case ContactModel::dmt: return work_of_adhesion;
        case ContactModel::maugis_dugdale: return std::log(work_of_adhesion);
        default: return std::copysign(std::sqrt(std::abs(work_of_adhesion)), work_of_adhesion);
    }
}

double ModelCurve::transition_parameter(const CurveParameters& parameters) const {
    double log_lambda = parameters[2];
    if (stress_given_)
        log_lambda += std::log(2.0) +
                      (std::log(radius_ / pi) - parameters[1] - 2.0 * (parameters[0] + std::log(4.0 / 3.0))) / 3.0;
    return std::clamp(std::exp(log_lambda), min_curve_lambda, max_curve_lambda);
}

double ModelCurve::radius_bound(double force, const CurveParameters& parameters) const {
    if (model_ == ContactModel::transition) {
        const double share = 1.0 / (1.0 + std::exp(-parameters[2]));
        const double root = std::sqrt(std::max(0.0, 1.0 + force * std::exp(-parameters[1])));
        return std::exp(parameters[0]) * std::cbrt(std::pow((share + root) / (1.0 + share), 2.0));
    }
    const double pull = 2.0 * pi * radius_ * std::abs(work_of_adhesion(parameters));
    const double root = std::sqrt(pull) + std::sqrt(std::max(0.0, force) + pull);
    return std::min(largest_radius(), std::cbrt(0.75 * radius_ * root * root * std::exp(-parameters[0])));
}

CurvePoint ModelCurve::at(double t, const CurveParameters& parameters) const {
    switch (model_) {
        case ContactModel::hertz:
        case ContactModel::dmt: return apart_or_pressed(t, parameters);
        case ContactModel::maugis_dugdale: return zone_point(t, parameters);
        case ContactModel::transition: return transition_point(t, parameters);
        default: return edge_point(t, parameters);
    }
}

CurvePoint ModelCurve::apart_or_pressed(double t, const CurveParameters& parameters) const {
    const double modulus = std::exp(parameters[0]), a = std::max(t, 0.0);
    const double dry = 4.0 * modulus * a * a * a / (3.0 * radius_);
    const double pull = model_ == ContactModel::dmt ? 2.0 * pi * radius_ : 0.0;
    return {.force = dry - (pull > 0.0 ? pull * parameters[1] : 0.0),
            .displacement = t * std::abs(t) / radius_,
            .radius = a,
            .force_slope = 4.0 * modulus * a * a / radius_,
            .displacement_slope = 2.0 * std::abs(t) / radius_,
            .radius_slope = t > 0.0 ? 1.0 : 0.0,
            .force_by = {dry, -pull, 0.0}};
}

CurvePoint ModelCurve::edge_point(double t, const CurveParameters& parameters) const {
    const EdgeTerms terms = model_ == ContactModel::layer          ? layer_terms(t, radius_, *layer_)
                            : model_ == ContactModel::large_strain ? sphere_terms(t, radius_)
                                                                   : half_space_terms(t, radius_);
    const double modulus = std::exp(parameters[0]), root = std::exp(0.5 * parameters[0]), w = parameters[1];
    return {.force = modulus * terms.dry_force - root * w * terms.edge_force,
            .displacement = terms.dry_displacement - w / root * terms.edge_displacement,
            .radius = t,
            .force_slope = modulus * terms.dry_force_slope - root * w * terms.edge_force_slope,
            .displacement_slope = terms.dry_displacement_slope - w / root * terms.edge_displacement_slope,
            .force_by = {modulus * terms.dry_force - 0.5 * root * w * terms.edge_force, -root * terms.edge_force, 0.0},
            .displacement_by = {0.5 * w / root * terms.edge_displacement, -terms.edge_displacement / root, 0.0}};
}

CurvePoint ModelCurve::zone_point(double t, const CurveParameters& parameters) const {
    const double work = std::exp(parameters[1]), lambda = transition_parameter(parameters);
    const contact::jkr::MaugisUnits units = contact::jkr::maugis_units(
        {.radius = radius_, .contact_modulus = std::exp(parameters[0]), .work_of_adhesion = work});
    const double a = std::max(t / units.length, 1e-9);
    const auto slopes = contact::maugis_dugdale::reduced_slopes(a, lambda);
    const bool bound = lambda <= min_curve_lambda || lambda >= max_curve_lambda;
    const double by_log_lambda = bound ? 0.0 : lambda;
    const double force_lambda = units.force * slopes.force_by_transition * by_log_lambda;
    const double displacement_lambda = units.height * slopes.displacement_by_transition * by_log_lambda;
    // A falls by a third of ln W and grows by a third of ln E*; so does λ at given σ0, by one and two thirds, downwards
    const double force_radius = units.force * slopes.force_by_radius * a / 3.0;
    const double displacement_radius = units.height * slopes.displacement_by_radius * a / 3.0;
    CurvePoint point{.force = units.force * slopes.state.force,
                     .displacement = units.height * slopes.state.displacement,
                     .radius = t,
                     .force_slope = units.force * slopes.force_by_radius / units.length,
                     .displacement_slope = units.height * slopes.displacement_by_radius / units.length};
    point.force_by = {force_radius, point.force - force_radius, force_lambda};
    point.displacement_by = {displacement_radius - 2.0 / 3.0 * point.displacement,
                             2.0 / 3.0 * point.displacement - displacement_radius, displacement_lambda};
    if (stress_given_) {
        point.force_by[0] -= 2.0 / 3.0 * force_lambda;
        point.force_by[1] -= force_lambda / 3.0;
        point.displacement_by[0] -= 2.0 / 3.0 * displacement_lambda;
        point.displacement_by[1] -= displacement_lambda / 3.0;
    }
    return point;
}

CurvePoint ModelCurve::transition_point(double t, const CurveParameters& parameters) const {
    const double share = 1.0 / (1.0 + std::exp(-parameters[2])), pull = -std::exp(parameters[1]);
    const double y = std::pow(t * std::exp(-parameters[0]), 1.5), u = (1.0 + share) * y - share;
    CurvePoint point{
        .force = pull * (1.0 - u * u), .radius = t, .force_slope = -3.0 * pull * u * (1.0 + share) * y / t};
    point.force_by = {3.0 * pull * u * (1.0 + share) * y, point.force,
                      -2.0 * pull * u * (y - 1.0) * share * (1.0 - share)};
    return point;
}

}  // namespace setae::loops
