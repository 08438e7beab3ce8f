// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::output {

/// The sentences of Verdict::answer.
[[nodiscard]] std::vector<std::string> answer_of(const study::StudyResult& result);

/// W_int of a fit as it is stated first: by generalised least squares.
[[nodiscard]] Estimate work_of(const adhesion::WorkFit& fit);

/// The sentences of Verdict::findings.
[[nodiscard]] std::vector<std::string> findings_of(const study::StudyResult& result);

/// A limit of the conclusions, with the reason.
struct Limit {
    std::string sentence;
    std::string note;      ///< explanation; may be empty
    bool reserves = true;  ///< a reservation that the answer does not state itself
};

/// Those of Verdict::limits, worst first.
[[nodiscard]] std::vector<Limit> limits_of(const study::StudyResult& result);

/// Below this probability a test contradicts.
inline constexpr double improbable = 0.05;

/// "χ² = 193.8 for 15 degrees of freedom, p = 4·10⁻³³".
[[nodiscard]] std::string test_text(const adhesion::PredictionTest& test);

/// "4 pairs".
[[nodiscard]] std::string pairs_text(int n);

/// W_int from the loss minus that of the approach by generalised least squares, with their shared inputs; empty where
/// either is missing.
[[nodiscard]] std::optional<Estimate> loss_minus_approach(const study::StudyResult& result);

/// Whether a difference between the W_int of loss and that of approach half as large as W_int would have shown: a claim
/// that the data could not have refused is none.
[[nodiscard]] bool could_have_refused(const Estimate& difference, const study::StudyResult& result);
/// Whether an interval of a difference holds 0; not where there is no interval.
[[nodiscard]] bool may_be_zero(const Estimate& difference);

/// Surfaces and elastomers of the pairs that have a measured work of adhesion and a prediction.
struct Tested {
    std::set<std::string> surfaces, elastomers;
    std::size_t pairs = 0;
};
[[nodiscard]] Tested tested(const study::StudyResult& result);

/// Balances that the pairs distinguish from the full-contact balance, and those they do not: by ln L of each with its
/// own W_int, spectra as the study takes them.
struct Rivals {
    std::vector<std::string> worse, alike, better;
};
[[nodiscard]] Rivals rivals_of(const study::StudyResult& result);

}  // namespace setae::output
