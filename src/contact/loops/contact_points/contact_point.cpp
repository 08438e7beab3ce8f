// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/contact_point.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "attempt.hpp"
#include "contact_point_estimators.hpp"
#include "held_contact_point.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"

namespace setae::loops {
namespace {

using Mode = ContactPointChoice::Mode;

void add_spread(ContactPoints& points) {
    double least = INFINITY, most = -INFINITY, weight = 0.0, sum = 0.0, squares = 0.0;
    for (const ContactPointEstimate& estimate : points.estimates) {
        if (!estimate.contact_point) continue;
        const double value = estimate.contact_point->value - points.contact_point.value;
        least = std::min(least, value);
        most = std::max(most, value);
        if (!estimate.contact_point->uncertain()) continue;
        const double w = 1.0 / estimate.contact_point->variance();
        weight += w;
        sum += w * value;
        squares += w * value * value;
        ++points.degrees_of_freedom;
    }
    points.spread = most >= least ? most - least : 0.0;
    if (points.degrees_of_freedom == 0) return;
    --points.degrees_of_freedom;
    points.chi2 = std::max(squares - sum * sum / weight, 0.0);
}

/// The method that is used. @throws UndefinedDataError where the requested one has no result.
std::optional<ContactPointMethod> decided(const ContactPoints& points, const ContactPointChoice& choice,
                                          double penetration) {
    const auto must = [&](ContactPointMethod method) {
        const auto& found = points.of(method).contact_point;
        if (!found)
            throw UndefinedDataError(
                fmt::format("no contact point by {}: {}", contact_point_name(method), found.reason));
        return method;
    };
    if (choice.mode == Mode::value) return std::nullopt;
    if (choice.mode == Mode::estimator) return must(choice.estimator);
    if (choice.mode == Mode::fit) return must(ContactPointMethod::force_displacement);
    constexpr double determined =
        0.5;  // share of the penetration above which the fit does not determine the contact point
    const auto& fitted = points.of(ContactPointMethod::force_displacement).contact_point;
    if (fitted && fitted->standard_error < determined * penetration) return ContactPointMethod::force_displacement;
    std::optional<ContactPointMethod> best;
    double least = INFINITY;
    for (const ContactPointEstimate& estimate : points.estimates) {
        if (!estimate.contact_point || !(estimate.contact_point->standard_error < least)) continue;
        least = estimate.contact_point->standard_error;
        best = estimate.method;
    }
    if (!best) throw UndefinedDataError("no estimator finds a contact point; give the contact point");
    return best;
}

JkrFit held_fit(const ContactPointInputs& inputs, const LensAndCounterBody& bodies, double contact_point) {
    if (inputs.force_displacement)
        return fit_with_contact_point(inputs.loading, bodies, contact_point, *inputs.force_displacement);
    return fit_with_contact_point(inputs.loading, bodies, contact_point);
}

void add_sensitivity(ContactPoints& points, const ContactPointInputs& inputs, const LensAndCounterBody& bodies,
                     double penetration) {
    constexpr double min_share = 1e-3;
    const double error = points.contact_point.uncertain() ? points.contact_point.standard_error : 0.0;
    const double step = std::clamp(error, min_share * penetration, 10.0 * min_share * penetration);
    const auto held = [&](double sign) {
        return attempt([&] { return held_fit(inputs, bodies, points.contact_point.value + sign * step); });
    };
    const auto above = held(1.0), below = held(-1.0);
    if (!above || !below) {
        points.work_by_contact_point = points.modulus_by_contact_point = undefined;
        return;
    }
    points.work_by_contact_point = (above->work_of_adhesion.value - below->work_of_adhesion.value) / (2.0 * step);
    points.modulus_by_contact_point = (above->contact_modulus.value - below->contact_modulus.value) / (2.0 * step);
}

}  // namespace

const std::vector<ContactPointMethod>& contact_point_methods() {
    using enum ContactPointMethod;
    static const std::vector<ContactPointMethod> methods{force_departure, broken_line, jump_in, force_displacement,
                                                         pointwise,       zero_force,  pull_off};
    return methods;
}

std::string contact_point_name(ContactPointMethod method) {
    switch (method) {
        case ContactPointMethod::force_departure: return "force_departure";
        case ContactPointMethod::broken_line: return "broken_line";
        case ContactPointMethod::jump_in: return "jump_in";
        case ContactPointMethod::force_displacement: return "force_displacement";
        case ContactPointMethod::pointwise: return "pointwise";
        case ContactPointMethod::zero_force: return "zero_force";
        case ContactPointMethod::pull_off: return "pull_off";
    }
    throw InternalError("unknown contact point method");
}

ContactPointChoice parse_contact_point(std::string_view text) {
    const std::string_view word = trimmed(text);
    if (word == "auto") return {};
    if (word == "fit") return {.mode = Mode::fit};
    for (const ContactPointMethod method : contact_point_methods())
        if (word == contact_point_name(method)) return {.mode = Mode::estimator, .estimator = method};
    try {
        return {.mode = Mode::value, .value = parse_quantity(word, dimension::length)};
    } catch (const InvalidArgument& error) {
        std::string names;
        for (const ContactPointMethod method : contact_point_methods()) names += ", " + contact_point_name(method);
        throw InvalidArgument(fmt::format("contact point '{}' is unknown; expected auto, fit{} or a length: {}", text,
                                          names, error.what()));
    }
}

const ContactPointEstimate& ContactPoints::of(ContactPointMethod method) const {
    for (const ContactPointEstimate& estimate : estimates)
        if (estimate.method == method) return estimate;
    throw InternalError("no estimate by " + contact_point_name(method));
}

ContactPoints contact_points(const ContactPointInputs& inputs, const LensAndCounterBody& bodies,
                             const ContactPointChoice& choice) {
    if (inputs.loop.displacement.size() == 0)
        throw UndefinedDataError("the contact point needs the displacement, which was not measured");
    ContactPoints points;
    for (const ContactPointMethod method : contact_point_methods())
        points.estimates.push_back(
            {.method = method, .contact_point = attempt([&] {
                                   Estimate found = estimated_contact_point(method, inputs, bodies);
                                   if (!std::isfinite(found.value))
                                       throw UndefinedDataError(
                                           "the data do not determine the contact point by this method");
                                   return found;
                               })});
    const double deepest = inputs.loading.displacement.maxCoeff();
    const double reach = deepest - inputs.loading.displacement.minCoeff();
    points.chosen = decided(points, choice, reach);
    points.contact_point = points.chosen ? *points.of(*points.chosen).contact_point
                                         : Estimate{.value = choice.value, .standard_error = 0.0, .method = "given"};
    const double penetration = deepest - points.contact_point.value;
    if (!(penetration > 0.0))
        throw UndefinedDataError(
            fmt::format("the contact point {} lies beyond the largest displacement of the loading, {}",
                        format_value(points.contact_point.value, "m"), format_value(deepest, "m")));
    for (ContactPointEstimate& estimate : points.estimates)
        estimate.fit = estimate.contact_point
                           ? attempt([&] { return held_fit(inputs, bodies, estimate.contact_point->value); })
                           : Outcome<JkrFit>::missing(estimate.contact_point.reason);
    add_spread(points);
    points.spread_share = points.spread / penetration;
    add_sensitivity(points, inputs, bodies, penetration);
    return points;
}

}  // namespace setae::loops
