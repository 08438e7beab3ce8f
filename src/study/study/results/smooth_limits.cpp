// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_limits.hpp"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "pairs.hpp"
#include "setae/study/study_result.hpp"

namespace setae::study {
namespace {

hysteresis::SmoothReference traced(const ReferenceWorks& works, const std::string& elastomer) {
    return {.work_approach = {works.approach, fmt::format("W_app of the reference on {}", elastomer)},
            .work_retraction = {works.retraction, fmt::format("W_ret of the reference on {}", elastomer)}};
}

}  // namespace

std::vector<ReferenceLimit> smooth_limits(const StudyResult& result, const hysteresis::Ranking& ranking) {
    std::vector<ReferenceLimit> limits;
    for (const auto& elastomer : result.elastomers) {
        const auto works = reference_works(result, elastomer.input.name);
        if (!works) continue;
        const auto reference = traced(*works, elastomer.input.name);
        for (const auto& score : ranking.models)
            limits.push_back({elastomer.input.name, reference.work_retraction.estimate(),
                              hysteresis::smooth_limit(score.fitted, reference, result.traced_work_of_adhesion,
                                                       works->jumps_per_area)});
    }
    return limits;
}

}  // namespace setae::study
