// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/next_measurement.hpp"

#include <set>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::study {
namespace {

using adhesion::Candidate;

/// Names of all inputs that somebody stated.
std::set<std::string> stated_inputs(const StudyResult& result) {
    std::set<std::string> names, spectra;
    for (const auto& surface : result.surfaces) spectra.insert(roughness::spectrum_input(surface.name));
    for (const auto& pair : result.modified->pairs)
        for (const auto* inputs : {&pair.measured_inputs, &pair.slope_inputs, &pair.offset_inputs})
            for (const auto& [name, component] : *inputs)
                if (!spectra.contains(name) && component.variance() > 0.0) names.insert(name);
    for (const auto& e : result.experiments) names.erase(fit_name(e.input.file));
    for (const auto& elastomer : result.elastomers) names.erase(loops_name(elastomer.input.name));
    return names;
}

std::optional<double> hours_of(const StudyResult& result, const std::string& key) {
    const auto found = result.study.costs.find(key);
    return found == result.study.costs.end() ? std::nullopt : std::optional(found->second);
}

std::string target_of(const PairResult& pair) { return fmt::format("{} on {}", pair.elastomer, pair.surface); }

}  // namespace

std::vector<Candidate> candidates_of(const StudyResult& result) {
    using Kind = Candidate::Kind;
    if (!result.modified) throw UndefinedDataError("no W_int is fitted: " + result.modified.reason);
    std::vector<Candidate> list;
    for (const auto& name : stated_inputs(result)) list.push_back({Kind::input, name, "", 1, hours_of(result, name)});
    for (const auto& pair : result.pairs)
        if (pair.experiments > 0)
            list.push_back({Kind::loop, pair.surface, pair.elastomer, pair.experiments, hours_of(result, "loop")});
    for (const auto& surface : result.surfaces)
        if (!surface.failed() && !surface.measurements.empty())
            list.push_back({Kind::spectrum, surface.name, "", 1, hours_of(result, "measurements")});
    return list;
}

std::vector<adhesion::NextMeasurement> next_measurements(const StudyResult& result, const std::string& target) {
    const auto candidates = candidates_of(result);
    std::optional<adhesion::PairPoint> line;
    std::vector<std::string> known{"W_int"};
    for (const auto& pair : result.pairs) {
        if (!pair.line) continue;
        known.push_back(target_of(pair));
        if (known.back() == target) line = pair.line;
    }
    if (!line && target != "W_int") {
        const auto nearest = nearest_match(target, known);
        throw InvalidArgument(fmt::format("'{}' is no number to be improved; expected W_int or a pair such as '{}'{}", target,
                                          known.back(), nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
    }
    return adhesion::next_measurements(result.modified->pairs, result.modified->generalised, line, candidates);
}

}  // namespace setae::study
