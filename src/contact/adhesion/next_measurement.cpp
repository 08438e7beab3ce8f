// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/next_measurement.hpp"

#include <algorithm>
#include <cmath>

#include "refitted.hpp"
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
    for (auto* inputs : {&pair.in_unitputs, &pair.slope_inputs, &pair.offset_inputs})
        shrink(*inputs, name, spectrum ? std::sqrt(0.5) : 0.5);
    return pair;
}

}  // namespace

Target work_target(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit) {
    return [pairs, scatter = fit.scatter](const Change& change) {
        return refitted(pairs, scatter, change).work_of_adhesion;
    };
}

Target prediction_target(const std::vector<PairPoint>& pairs, const GeneralisedFit& fit, const PairPoint& line) {
    return [work = work_target(pairs, fit), line](const Change& change) {
        return raw_prediction(change(line), work(change));
    };
}

Target difference_target(const Target& one, const Target& other) {
    return [one, other](const Change& change) {
        const auto a = one(change), b = other(change);
        return TracedValue(a.value - b.value, combined({{1.0, a.components}, {-1.0, b.components}}));
    };
}

TracedValue value_of(const Target& target) {
    return target([](const PairPoint& pair) { return pair; });
}

std::vector<NextMeasurement> next_measurements(const Target& target, const std::vector<Candidate>& candidates) {
    const double now = value_of(target).standard_error();
    std::vector<NextMeasurement> list;
    for (const auto& candidate : candidates) {
        const double error = target([&](const PairPoint& pair) { return with(pair, candidate); }).standard_error();
        list.push_back({candidate, error, 1.0 - error / now});
    }
    const bool by_hour =
        std::all_of(candidates.begin(), candidates.end(), [](const auto& c) { return c.hours.has_value(); });
    const auto worth = [by_hour](const NextMeasurement& next) {
        return by_hour ? next.gain / *next.candidate.hours : next.gain;
    };
    std::stable_sort(list.begin(), list.end(), [&](const auto& a, const auto& b) { return worth(a) > worth(b); });
    return list;
}

}  // namespace setae::adhesion
