// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/estimate.hpp"

namespace setae::statistics {

/// Result of the comparison of a difference and its uncertainty with a margin of equivalence.
enum class Verdict {
    equivalent,  ///< shown to be within the margin
    different,   ///< shown to be beyond the margin, on one side
    undecided,   ///< neither: more measurements or a wider margin are needed
};

/// Two one-sided tests of a difference d ± s against a margin Δ:
///
///   p = max(P(T >= (Δ + d)/s), P(T >= (Δ − d)/s)),  T Student's t with the estimate's degrees of freedom, else normal
///
/// p < α where the interval of level 1 − 2α lies within (−Δ, Δ).
/// Source: Schuirmann, J. Pharmacokinet. Biopharm. 15 (1987) 657.
struct Equivalence {
    Estimate difference;
    double margin = 0.0;               ///< Δ, in the difference's unit
    double probability = undefined;    ///< p; NaN where the difference has no standard error
    std::optional<Interval> interval;  ///< interval of level 1 − 2α
    Verdict verdict = Verdict::undecided;
};

/// @throws InvalidArgument unless margin > 0 and 0 < significance < 0.5.
[[nodiscard]] Equivalence test_equivalence(const Estimate& difference, double margin, double significance = 0.05);

/// "equivalent", "different", "undecided".
[[nodiscard]] const char* name(Verdict verdict);

}  // namespace setae::statistics
