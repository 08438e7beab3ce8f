// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::study {

/// A quantity of loops, where a loop has it, and the corresponding quantity of pairs.
struct LoopQuantity {
    const char* name;
    const char* symbol;
    const char* unit;
    std::function<std::optional<Estimate>(const loops::LoopAnalysis&)> of;
    Components LoopDependence::*dependence;
    std::optional<Estimate> PairResult::*of_pair;
    Components PairResult::*inputs_of_pair;
};

/// W_app, W_po, W_ret and E_loss.
[[nodiscard]] const std::vector<LoopQuantity>& loop_quantities();

/// Loops that have a quantity, their values, and the weight of each in the mean.
struct LoopsInMean {
    std::vector<const ExperimentResult*> loops;
    std::vector<Estimate> values;
    Array1D weights;
};

/// Loops with a quantity, without weights, that are on an elastomer and, where one is named, a surface. Excluded ones
/// are included on request.
[[nodiscard]] LoopsInMean loops_with(const StudyResult& result, const LoopQuantity& quantity,
                                     const std::string& elastomer, const std::optional<std::string>& surface,
                                     bool excluded);

/// Sets the inputs of a mean of loops for a pair and, for W_app where the elastomer's modulus comes from loops, their
/// fits.
void take_dependence(PairResult& pair, const LoopQuantity& quantity, const LoopsInMean& mean, bool modulus_from_loops);

/// Own noise of fits in a weighted mean of their results: `of_fit` is E or W.
[[nodiscard]] Components fits_in_mean(const LoopsInMean& mean, Component FitNoise::*of_fit);

/// Inputs of loops in a weighed mean of one of their numbers.
[[nodiscard]] Components inputs_in_mean(const LoopsInMean& mean, Components LoopDependence::*number);

}  // namespace setae::study
