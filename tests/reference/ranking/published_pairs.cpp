// SPDX-License-Identifier: GPL-3.0-or-later
#include "published_pairs.hpp"

#include "hysteresis_pairs.hpp"
#include "setae/adhesion/prediction.hpp"
#include "setae/study/study_result.hpp"

namespace setae::reference {

struct PublishedPairs::Study {
    study::StudyResult result = study::run_study(study::read_study(SETAE_EXAMPLES "/nanodiamond/published.toml"), {1});
    study::PreparedPairs prepared = study::prepared_pairs(result);
};

PublishedPairs::PublishedPairs() : study_(std::make_unique<Study>()) {
    for (const auto& pair : study_->prepared.pairs) {
        if (!pair.ranked()) continue;
        ranked_.push_back(
            {*pair.as_measured, pair.measured_approach(), {*pair.retraction(), pair.retraction_inputs()}});
        auto point = adhesion::modified_point(pair.as_measured->rough, pair.elastomer.soft_side());
        point.measured = *pair.measured.approach;
        point.measured_inputs = pair.measured.approach_inputs;
        point.measured_noise = pair.measured.approach_fits;
        points_.push_back(std::move(point));
    }
}

PublishedPairs::~PublishedPairs() = default;

}  // namespace setae::reference
