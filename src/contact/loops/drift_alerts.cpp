// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "alert_list.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"

namespace setae::loops {
namespace {

/// "3.20 µN (1.1 % of the largest tension)".
std::string beside_tension(double force, double tension) {
    const std::string text = format_value(std::abs(force), "N", 3);
    if (!(tension > 0.0)) return text;
    return fmt::format("{} ({:.2g} % of the largest tension)", text, 100.0 * std::abs(force) / tension);
}

/// "sample 812 (16.2 s)".
std::string place_of(Index sample, const Loop& loop) {
    const std::string text = fmt::format("sample {}", sample);
    return loop.time.size() > 0 ? fmt::format("{} ({:.4g} s)", text, loop.time[sample]) : text;
}

void check_curve(AlertList& list, const ForceDrift& drift, double tension) {
    if (drift.degree > 1)
        list.add(
            "DRIFT_NOT_LINEAR",
            fmt::format("the zero of force does not drift linearly: a polynomial of degree {} was removed, which "
                        "differs from a line by up to {} within contact; the ± include the uncertainty of this choice",
                        drift.degree, beside_tension(drift.bend, tension)),
            "let the sensor settle before the record starts, or record faster");
    if (drift.irregular)
        list.add("DRIFT_IRREGULAR",
                 "the drift of the zero of force between the free flight before and after contact follows no "
                 "polynomial of degree 3 or less; a line between both was removed",
                 "look for a step of the sensor; forces may be off by up to the ± that is reported");
}

void check_stretches(AlertList& list, const LoopAnalysis& analysis, double tension) {
    const ForceZero& zero = analysis.force_zero;
    if (zero.drift.stretches != 1 || zero.drift.degree == 0) return;
    const bool before = analysis.segments.before.range.has_value();
    const Index far = before ? analysis.loading.range.last : analysis.loading.range.first;
    const double error = zero.modes.row(far).matrix().norm();
    list.add("ONE_BASELINE",
             fmt::format("free flight is recorded only {} contact: a line extrapolated from there gives the zero of "
                         "force at sample {} within {}",
                         before ? "before" : "after", far, beside_tension(error, tension)),
             "record free flight before and after contact; set drift to none if the sensor is known not to "
             "drift");
}

void check_steps(AlertList& list, const LoopAnalysis& analysis, const Loop& loop, double tension) {
    constexpr double visible = 0.003;  // share of the largest tension
    for (const ForceStep& step : analysis.segments.steps)
        if (std::abs(step.size) > visible * tension)
            list.add(
                "STEP_IN_FREE_FLIGHT",
                fmt::format(
                    "the force steps by {} in free flight, at {}; only the free flight between the step and contact "
                    "gives the zero of force",
                    beside_tension(step.size, tension), place_of(step.sample, loop)),
                "check the sensor; look for other steps within contact");
    constexpr std::size_t most = 5;
    for (std::size_t i = 0; i < std::min(most, analysis.steps_in_contact.size()); ++i) {
        const ForceStep& step = analysis.steps_in_contact[i];
        list.add(
            "STEP_IN_CONTACT",
            fmt::format("the force changes by {} at once within contact, at {}: the contact slipped, or the sensor "
                        "stepped",
                        beside_tension(step.size, tension), place_of(step.sample, loop)),
            "do not use E*, W and the energy of this loop until the step is explained");
    }
}

}  // namespace

void check_drift(AlertList& list, const LoopAnalysis& analysis, const Loop& loop, const AlertLimits& limits) {
    const ForceDrift& drift = analysis.force_zero.drift;
    const double tension = std::max(-loop.force.minCoeff(), 0.0);
    if (drift.stretches == 0)
        list.add("NO_BASELINE",
                 "the record has no free flight before or after contact: the forces are used without a "
                 "correction of their zero",
                 "record free flight before or after contact, or check that the zero of force is right");
    if (drift.stretches > 0 && drift.degree == 0)
        list.add("DRIFT_UNKNOWN", "no drift of the force was removed: forces may be off by the drift",
                 "leave the drift setting at its default, so that the drift is found and removed");
    if (drift.degree > 0 && drift.largest_in_contact > limits.drift_share * tension)
        list.add(
            "FORCE_DRIFT",
            fmt::format("the zero of force drifts by up to {} within contact; {} was removed, which follows from the "
                        "free flight {} contact",
                        beside_tension(drift.largest_in_contact, tension),
                        drift.degree == 1 ? "a line in time" : "a polynomial in time",
                        drift.stretches > 1              ? "before and after"
                        : analysis.segments.before.range ? "before"
                                                         : "after"),
            "the ± of all results include the uncertainty of the drift; let the sensor settle before the "
            "record starts");
    check_curve(list, drift, tension);
    check_stretches(list, analysis, tension);
    check_steps(list, analysis, loop, tension);
}

}  // namespace setae::loops
