// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_limits.hpp"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "setae/study/study_result.hpp"
#include "statistics.hpp"

namespace setae::study {
namespace {

struct MeanReference {
    hysteresis::SmoothReference works;
    double jumps_per_area = 0.0;  ///< [J/m²]; 0 where its loss or area is not known
};

std::optional<MeanReference> mean_reference(const StudyResult& result, const std::string& elastomer) {
    std::vector<Estimate> approach, retraction;
    MeanReference mean;
    for (const auto& reference : result.references) {
        if (reference.elastomer != elastomer || !(reference.approach.value > 0.0) ||
            !(reference.retraction.value > 0.0))
            continue;
        approach.push_back(reference.approach);
        retraction.push_back(reference.retraction);
        if (reference.ideal_loss && reference.contact_area && *reference.contact_area > 0.0)
            mean.jumps_per_area = *reference.ideal_loss / *reference.contact_area;
    }
    if (approach.empty()) return {};
    mean.works = {.work_approach = {mean_of(approach), fmt::format("W_app of the reference on {}", elastomer)},
                  .work_retraction = {mean_of(retraction), fmt::format("W_ret of the reference on {}", elastomer)}};
    return mean;
}

}  // namespace

std::vector<ReferenceLimit> smooth_limits(const StudyResult& result, const hysteresis::Ranking& ranking) {
    std::vector<ReferenceLimit> limits;
    for (const auto& elastomer : result.elastomers) {
        const auto reference = mean_reference(result, elastomer.input.name);
        if (!reference) continue;
        for (const auto& score : ranking.models)
            limits.push_back({elastomer.input.name, reference->works.work_retraction.estimate(),
                              hysteresis::smooth_limit(score.fitted, reference->works, result.traced_work_of_adhesion,
                                                       reference->jumps_per_area)});
    }
    return limits;
}

}  // namespace setae::study
