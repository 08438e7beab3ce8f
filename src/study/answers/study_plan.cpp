// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/study_plan.hpp"

#include <algorithm>

#include "setae/cache/store.hpp"

namespace setae::answers {

Index StudyPlan::count(std::string_view state) const {
    return std::count_if(steps.begin(), steps.end(), [state](const auto& step) { return state_of(step) == state; });
}

std::string_view state_of(const study::PlannedStep& step) {
    return !step.error.empty() ? "fails" : step.cached ? "kept" : "to do";
}

StudyPlan plan_of(const study::Study& study, const study::RunOptions& options) {
    return {.study = study.path,
            .output = study.output,
            .cache = options.store == nullptr ? std::string() : options.store->folder(),
            .steps = study::planned_steps(study, options),
            .missing = study::study_gaps(study)};
}

}  // namespace setae::answers
