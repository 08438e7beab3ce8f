// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::output {

/// What kinds of alerts say against a conclusion.
struct Bearing {
    std::vector<std::string_view> codes;  ///< kinds that say the same
    const char* sentence;                 ///< {} stands for whom it concerns
};

/// Those of every kind that bears on a conclusion, what misleads most first. The others say what was done or how a file
/// is made, or their matter has a sentence of its own in Verdict::limits: failures, reconstructions, (7) below 0.
[[nodiscard]] const std::vector<Bearing>& bearings();

/// Whom an alert concerns.
struct Subject {
    std::string name;     ///< the measurement or loop where it is one's, else the surface, pair or elastomer
    std::string surface;  ///< of a measurement; else empty
};
[[nodiscard]] Subject subject_of(const study::StudyResult& result, const Alert& alert);

/// Names once each, in order; of more than three measurements those of their surfaces.
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Subject>& subjects);

}  // namespace setae::output
