// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/smooth_limit.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::hysteresis {
namespace {

/// Inputs of a mirror, in their order.
enum MirrorInput : std::size_t { mirror_approach, mirror_retraction, mirror_work, mirror_parameter };

/// A smooth surface: no stored energy, and full contact.
PairState mirror(const RetractionModel& model, const std::vector<double>& in, double jumps_per_area) {
    PairState state;
    state.work_of_adhesion = in[mirror_work];
    state.work_approach = in[mirror_approach];
    if (model.tip != Tip::none) state.tip_factor = in[mirror_retraction] / in[mirror_approach];
    if (model.law == Law::conformal_loss || model.law == Law::fitted_conformal_loss)
        state.jumps_per_area = jumps_per_area;
    return state;
}

}  // namespace

bool has_smooth_limit(const RetractionModel& model) {
    switch (model.law) {
        case Law::reversible:
        case Law::pinning:
        case Law::pinning_by_bands:
        case Law::fitted_pinning: return true;
        case Law::conformal_loss:
        case Law::fitted_conformal_loss:
        case Law::opening_work: return false;
    }
    throw InternalError("a retraction model whose smooth limit is not known");
}

RetractionModel model_without_measurements() { return {Law::reversible, Tip::none}; }

SmoothLimit smooth_limit(const FittedModel& fitted, const SmoothReference& reference,
                         const TracedValue& work_of_adhesion, double jumps_per_area) {
    if (!(reference.work_approach.value > 0.0 && reference.work_retraction.value > 0.0))
        throw InvalidArgument(fmt::format("a smooth reference with W_app {} and W_ret {} J/m2; expected both above 0",
                                          reference.work_approach.value, reference.work_retraction.value));
    const auto work_of = [&](const std::vector<double>& in) {
        const auto line = retraction_line(fitted.model, mirror(fitted.model, in, jumps_per_area), {});
        return line.slope * in[mirror_parameter] + line.constant;
    };
    const std::vector<TracedValue> inputs{reference.work_approach, reference.work_retraction, work_of_adhesion,
                                          fitted.parameter};
    return {.model = fitted.model,
            .work_retraction = setae::propagated(work_of, inputs),
            .distance = setae::propagated(
                [&](const std::vector<double>& in) { return work_of(in) - in[mirror_retraction]; }, inputs),
            .tends_to_reference = has_smooth_limit(fitted.model)};
}

}  // namespace setae::hysteresis
