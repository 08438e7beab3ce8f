// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::study {

/// A kind of input without a standard error in a study, with its items: the uncertainty of dependent results is
/// incomplete.
struct ExactInputs {
    std::string what;                ///< "sphere radius", "calibration of heights and lengths"
    std::vector<std::string> names;  ///< elastomers or instruments; empty where it is of all loops
};

/// In the order in which they move W_int most, as a rule: surface energy and modulus of elastomers, sphere radius,
/// calibrations of instruments and of loops, tips.
[[nodiscard]] std::vector<ExactInputs> exact_inputs(const Study& study);
/// The exact inputs without those for which containers give a standard error.
[[nodiscard]] std::vector<ExactInputs> exact_inputs(const StudyResult& result);

}  // namespace setae::study
