// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/next_measurement.hpp"

#include <optional>
#include <set>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::study {
namespace {

using adhesion::Candidate;

std::optional<double> hours_of(const StudyResult& result, const std::string& key) {
    const auto found = result.study.costs.find(key);
    return found == result.study.costs.end() ? std::nullopt : std::optional(found->second);
}

/// W_int of one balance.
struct BalanceTarget {
    std::string name;
    const Outcome<adhesion::WorkFit>* fit = nullptr;
};

/// @throws UndefinedDataError where it is not fitted.
adhesion::Target target_of(const BalanceTarget& balance) {
    if (!*balance.fit)
        throw UndefinedDataError(fmt::format("{} gives no fitted W_int: {}", balance.name, balance.fit->reason));
    return adhesion::work_target((*balance.fit)->pairs, (*balance.fit)->generalised);
}

/// "A - B" of two balances; empty for another text.
std::optional<adhesion::Target> difference_of(const StudyResult& result, const std::string& text) {
    Outcome<adhesion::WorkFit> losses;
    if (result.loop) losses.value = result.loop->through_origin;
    else losses.reason = result.loop.reason;
    const std::vector<BalanceTarget> balances{{"(7)", &result.modified},
                                              {"(2)", &result.without_area_change},
                                              {"(S13)", &result.persson_tosatti},
                                              {"(10)", &losses}};
    for (const auto& one : balances)
        for (const auto& other : balances)
            if (&one != &other && text == one.name + " - " + other.name)
                return adhesion::difference_target(target_of(one), target_of(other));
    return std::nullopt;
}

}  // namespace

std::vector<std::string> stated_inputs(const StudyResult& result, const Conclusions& conclusions) {
    if (!conclusions.modified) return {};
    std::set<std::string> names, spectra;
    for (const auto& surface : result.surfaces) spectra.insert(roughness::spectrum_input(surface.name));
    for (const auto& pair : conclusions.modified->pairs)
        for (const auto* inputs : {&pair.in_unitputs, &pair.slope_inputs, &pair.offset_inputs})
            for (const auto& [name, component] : *inputs)
                if (!spectra.contains(name) && component.variance() > 0.0) names.insert(name);
    for (const auto& e : result.experiments) names.erase(fit_name(e.input.file));
    for (const auto& elastomer : result.elastomers) names.erase(loops_name(elastomer.input.name));
    return {names.begin(), names.end()};
}

std::string pair_target(const std::string& elastomer, const std::string& surface) {
    return fmt::format("{} on {}", elastomer, surface);
}

adhesion::Target target_of(const StudyResult& result, const std::string& text) {
    if (!result.modified) throw UndefinedDataError("W_int is not fitted: " + result.modified.reason);
    const auto& fit = *result.modified;
    if (text == "W_int") return adhesion::work_target(fit.pairs, fit.generalised);
    if (auto difference = difference_of(result, text)) return *difference;
    std::vector<std::string> known{"W_int", "(7) - (S13)", "(7) - (2)", "(7) - (10)"};
    for (const auto& pair : result.pairs) {
        if (!pair.line) continue;
        known.push_back(pair_target(pair.elastomer, pair.surface));
        if (known.back() == text) return adhesion::prediction_target(fit.pairs, fit.generalised, *pair.line);
    }
    const auto nearest = nearest_match(text, known);
    throw InvalidArgument(
        fmt::format("'{}' is not a target; expected W_int, a difference such as '(7) - (10)' "
                    "or a pair such as '{}'{}",
                    text, known.back(), nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

std::vector<Candidate> candidates_of(const StudyResult& result) {
    using Kind = Candidate::Kind;
    if (!result.modified) throw UndefinedDataError("W_int is not fitted: " + result.modified.reason);
    std::vector<Candidate> list;
    for (const auto& name : stated_inputs(result, result))
        list.push_back({Kind::input, name, "", 1, hours_of(result, name)});
    for (const auto& pair : result.pairs)
        if (pair.experiments > 0)
            list.push_back({Kind::loop, pair.surface, pair.elastomer, pair.experiments, hours_of(result, "loop")});
    for (const auto& surface : result.surfaces)
        if (!surface.failed() && !surface.measurements.empty())
            list.push_back({Kind::spectrum, surface.name, "", 1, hours_of(result, "measurements")});
    return list;
}

std::vector<adhesion::NextMeasurement> next_measurements(const StudyResult& result, const std::string& target) {
    return adhesion::next_measurements(target_of(result, target), candidates_of(result));
}

}  // namespace setae::study
