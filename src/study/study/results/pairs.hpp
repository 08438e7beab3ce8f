// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/study/study_result.hpp"

namespace setae::study {

/// Names of the measured quantities of loops.
inline constexpr const char* work_of_approach = "work_of_adhesion_approach";
inline constexpr const char* work_of_pull_off = "work_of_adhesion_pull_off";
inline constexpr const char* work_of_retraction = "work_of_adhesion_retraction";
inline constexpr const char* energy_loss = "energy_loss";

/// An elastomer with the modulus that the study or its loops give, which are analysed.
[[nodiscard]] ElastomerResult elastomer_result(const ElastomerInput& input, const StudyResult& result);

/// Mixed models of every quantity, for the elastomers whose loops name a lens, a spot or an exclusion.
[[nodiscard]] std::vector<ElastomerReplicates> elastomer_replicates(const StudyResult& result);

/// "rough × soft".
[[nodiscard]] std::string pair_name(const PairResult& pair);

/// Every surface × elastomer pair with its measured values, from loops or published tables.
[[nodiscard]] std::vector<PairResult> measured_pairs(const StudyResult& result);

/// Loss [J] of an ideal smooth sphere of this W and modulus under fixed grips; empty where radius or modulus is
/// unknown.
[[nodiscard]] std::optional<double> ideal_loss(const ElastomerResult& elastomer, double work_of_adhesion);

/// Both works of the smooth references on an elastomer that state both, their means.
struct ReferenceWorks {
    Estimate approach, retraction;  ///< [J/m²]
    double jumps_per_area = 0.0;  ///< loss of an ideal sphere's jumps per area [J/m²]; 0 where loss or area is unknown
};
[[nodiscard]] std::optional<ReferenceWorks> reference_works(const StudyResult& result, const std::string& elastomer);

/// W_app of the smooth references on an elastomer, their mean, as an input of its own; empty without a reference.
[[nodiscard]] std::optional<TracedValue> reference_work(const StudyResult& result, const std::string& elastomer);

/// Smooth references and their change between "before" and "after".
void evaluate_references(StudyResult& result);

/// Fits of W_int over all pairs of `conclusions`, predictions at the study's W_int, and their test.
void conclude(const StudyResult& result, Conclusions& conclusions);

}  // namespace setae::study
