// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/next_measurement.hpp"

#include <algorithm>
#include <cmath>

#include "setae/roughness/parameter_spread.hpp"

namespace setae::adhesion {
namespace {

void shrink(Components& inputs, const std::string& name, double factor) {
    if (const auto found = inputs.find(name); found != inputs.end()) found->second.directions *= factor;
}

/// A pair as it would be with the candidate measured.
PairPoint with(PairPoint pair, const Candidate& candidate) {
    using Kind = Candidate::Kind;
    if (candidate.kind == Kind::loop) {
        if (pair.surface != candidate.name || pair.elastomer != candidate.elastomer) return pair;
        const double factor = std::sqrt(candidate.loops / (candidate.loops + 1.0));
        pair.measured.standard_error *= factor;
        for (auto& [name, component] : pair.measured_noise) component.directions *= factor;
        return pair;
    }
    const bool spectrum = candidate.kind == Kind::spectrum;
    const auto name = spectrum ? roughness::spectrum_input(candidate.name) : candidate.name;
    for (auto* inputs : {&pair.measured_inputs, &pair.slope_inputs, &pair.offset_inputs})
        shrink(*inputs, name, spectrum ? std::sqrt(0.5) : 0.5);
    return pair;
}

double error_of(const GeneralisedFit& fit, const std::optional<PairPoint>& line) {
    return line ? raw_prediction(*line, fit.work_of_adhesion).standard_error() : fit.work_of_adhesion.standard_error();
}

}  // namespace

std::vector<NextMeasurement> next_measurements(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit,
                                               const std::optional<PairPoint>& line,
                                               const std::vector<Candidate>& candidates) {
    const double now = error_of(fit, line);
    std::vector<NextMeasurement> list;
    for (const auto& candidate : candidates) {
        std::vector<PairPoint> there;
        for (const auto& pair : pairs) there.push_back(with(pair, candidate));
        const auto later = line ? std::optional(with(*line, candidate)) : std::nullopt;
        const double error = error_of(fit_generalised(there, fit.scatter), later);
        list.push_back({candidate, error, 1.0 - error / now});
    }
    const bool by_hour = std::all_of(candidates.begin(), candidates.end(), [](const auto& c) { return c.hours.has_value(); });
    const auto worth = [by_hour](const NextMeasurement& next) {
        return by_hour ? next.gain / *next.candidate.hours : next.gain;
    };
    std::stable_sort(list.begin(), list.end(),
                     [&](const auto& a, const auto& b) { return worth(a) > worth(b); });
    return list;
}

}  // namespace setae::adhesion
