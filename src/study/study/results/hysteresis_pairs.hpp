// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "setae/adhesion/contact_scales.hpp"
#include "setae/hysteresis/pinning_law.hpp"
#include "setae/study/study_result.hpp"

namespace setae::study {

/// A pair of the study with the data that models refer to.
struct PreparedPair {
    const PairResult& measured;
    const ElastomerResult& elastomer;
    adhesion::RoughnessInContact roughness;
    std::optional<hysteresis::RetractionPair> from_roughness, as_measured;
    /// The same with W_ret read from the area of its loops, and that W_ret; where the area is known.
    std::optional<hysteresis::RetractionPair> by_area;
    std::optional<hysteresis::MeasuredWork> of_area;

    [[nodiscard]] const std::optional<Estimate>& retraction() const {
        return measured.retraction ? measured.retraction : measured.pull_off;
    }
    [[nodiscard]] const Components& retraction_inputs() const {
        return measured.retraction ? measured.retraction_inputs : measured.pull_off_inputs;
    }
    /// For a pair with a measured W_app.
    [[nodiscard]] hysteresis::MeasuredWork measured_approach() const {
        return {*measured.approach, measured.approach_inputs};
    }
    [[nodiscard]] std::optional<TracedValue> traced_retraction() const {
        return measured.retraction ? measured.traced_retraction() : measured.traced_pull_off();
    }
    [[nodiscard]] bool ranked() const { return measured.approach && measured.approach->value > 0.0 && retraction(); }
    [[nodiscard]] bool conforms() const {
        return from_roughness->energy_share() <= hysteresis::full_contact_energy_share;
    }
};

/// Pairs with the inputs of models, pairs without them, and the time dependence of their elastomers.
struct PreparedPairs {
    std::deque<PreparedPair> pairs;  ///< whose places do not change
    std::vector<SkippedPair> skipped;
    std::vector<ElastomerTimes> elastomers;
};

[[nodiscard]] PreparedPairs prepared_pairs(const StudyResult& result);

}  // namespace setae::study
