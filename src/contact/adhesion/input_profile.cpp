// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/input_profile.hpp"

#include <cmath>
#include <limits>

#include "refitted.hpp"

namespace setae::adhesion {
namespace {

/// The single direction of an input; 0 where a value does not depend on it, NaN where it has several.
double direction_of(const Components& components, const std::string& input) {
    const auto found = components.find(input);
    if (found == components.end()) return 0.0;
    const auto& directions = found->second.directions;
    return directions.size() == 1 ? directions[0] : std::numeric_limits<double>::quiet_NaN();
}

/// A pair with the input exact and off by so many of its standard errors.
PairPoint held(PairPoint pair, const std::string& input, double shift) {
    const auto move = [&](double& value, Components& inputs) {
        value += shift * direction_of(inputs, input);
        inputs.erase(input);
    };
    move(pair.measured.value, pair.in_unitputs);
    move(pair.slope, pair.slope_inputs);
    move(pair.offset, pair.offset_inputs);
    return pair;
}

bool has_one_direction(const std::vector<PairPoint>& pairs, const std::string& input) {
    bool any = false;
    for (const auto& pair : pairs)
        for (const auto* inputs : {&pair.in_unitputs, &pair.slope_inputs, &pair.offset_inputs}) {
            const double direction = direction_of(*inputs, input);
            if (std::isnan(direction)) return false;
            any = any || direction != 0.0;
        }
    return any;
}

/// From the parabola through three points with a spacing of one standard error.
Estimate maximum_of(const ProfilePoint& below, const ProfilePoint& middle, const ProfilePoint& above) {
    const double slope = 0.5 * (above.log_likelihood - below.log_likelihood);
    const double curvature = above.log_likelihood - 2.0 * middle.log_likelihood + below.log_likelihood;
    Estimate found{
        .value = 0.0, .standard_error = std::numeric_limits<double>::quiet_NaN(), .method = "profile likelihood"};
    constexpr double least = 1e-6;  // in ln L: rounding errors of the fits
    if (!(curvature < -least)) return found;
    found.value = -slope / curvature;
    found.standard_error = 1.0 / std::sqrt(-curvature);
    return found;
}

InputProfile profile_of(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit, const std::string& input) {
    InputProfile profile{.input = input};
    for (const double shift : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
        const auto found =
            refitted(pairs, fit.scatter, [&](const PairPoint& pair) { return held(pair, input, shift); });
        profile.points.push_back(
            {shift, found.work_of_adhesion.estimate("generalised least squares"), found.log_likelihood});
    }
    profile.by_pairs = maximum_of(profile.points[1], profile.points[2], profile.points[3]);
    return profile;
}

}  // namespace

std::vector<InputProfile> profile_inputs(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit,
                                         const std::vector<std::string>& inputs) {
    std::vector<InputProfile> profiles;
    for (const auto& input : inputs)
        if (has_one_direction(pairs, input)) profiles.push_back(profile_of(pairs, fit, input));
    return profiles;
}

}  // namespace setae::adhesion
