// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/loops/analysis.hpp"
#include "setae/loops/crack_speed_fit.hpp"
#include "setae/loops/global_fit.hpp"
#include "setae/loops/profile_likelihood.hpp"

namespace setae::study {

/// Fits that are requested in addition to JKR.
struct LoopModelOptions {
    std::vector<std::string> models;  ///< names of contact models; "all" compares them
    loops::LoopBranch branch = loops::LoopBranch::loading;
    loops::FitErrors errors = loops::FitErrors::orthogonal_distance;
    std::optional<double> contact_point;    ///< [m] fixed; else fitted
    std::optional<double> cohesive_stress;  ///< [Pa] fixed in Maugis–Dugdale's model; else fitted
    bool profile = false;                   ///< intervals of E* and W by profile likelihood
    bool crack_speed = false;               ///< G(v) of the retracting edge
    std::optional<double> exponent;         ///< n of G(v) fixed; else fitted
    bool share_contact_modulus = false;     ///< one fit of several loops with one E*
    bool share_work_of_adhesion = false;    ///< one fit of several loops with one W

    [[nodiscard]] bool any() const { return !models.empty() || profile || crack_speed; }
    [[nodiscard]] bool shared() const { return share_contact_modulus || share_work_of_adhesion; }
    /// Model of the fit of several loops: the named model where there is only one, else JKR.
    [[nodiscard]] loops::ContactModel shared_model() const;
};

/// "orthogonal_distance", "effective_variance", "force_only". @throws InvalidArgument for another name.
[[nodiscard]] loops::FitErrors fit_errors_named(const std::string& name);

/// Results of these fits for one loop.
struct LoopModels {
    std::vector<loops::ModelFit> fits;
    std::optional<loops::ModelComparison> comparison;
    std::optional<loops::ProfileLikelihood> profile;
    std::optional<loops::CrackSpeedFit> crack_speed;
    std::vector<std::string> failures;  ///< one sentence for each failed fit
};

/// Never throws for data that do not allow a fit: see `failures`.
[[nodiscard]] LoopModels loop_models(const loops::LoopAnalysis& analysis, const loops::LensAndCounterBody& bodies,
                                     const loops::AnalysisOptions& analysis_options, const LoopModelOptions& options);

/// One loop of a shared fit.
/// @throws UndefinedDataError where it has no such branch.
[[nodiscard]] loops::GlobalBranch branch_to_share(const std::string& name, const loops::LoopAnalysis& analysis,
                                                  const loops::LensAndCounterBody& bodies,
                                                  const loops::AnalysisOptions& analysis_options,
                                                  const LoopModelOptions& options);

/// One fit of several loops, by shared_model().
/// @throws UndefinedDataError for fewer than two loops; as loops::fit_globally.
[[nodiscard]] loops::GlobalFit shared_fit(const std::vector<loops::GlobalBranch>& loops,
                                          const LoopModelOptions& options);

}  // namespace setae::study
