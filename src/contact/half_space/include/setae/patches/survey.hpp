// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "setae/patches/patch_contact.hpp"

namespace setae::patches {

/// Patches of several designs, each drawn several times.
struct SurveyDesign {
    std::vector<PatchDesign> designs;  ///< seeds are set by the survey
    int seeds = 8;                     ///< patches of each design
    std::uint64_t first_seed = 1;
    ContactProtocol protocol;
    parallel::Threads threads;
    /// Called after each patch with how many of how many are done, from one thread at a time.
    std::function<void(std::size_t done, std::size_t of)> progress;
};

/// Mean over patches, and its standard error; 0 for one patch.
struct PatchMean {
    double value = 0.0, standard_error = 0.0;
};

/// A design, drawn several times.
struct SurveyRow {
    PatchDesign design;
    double range_over_height = 0.0;
    int patches = 0;
    PatchMean area_from_far, gain_from_far, area_after_preload, gain_after_preload;
    int closed = 0;              ///< number of patches closed by the pressures of the protocol
    PatchMean closing_pressure;  ///< closing pressure of those, divided by h'_rms E*
    PatchMean opening_tension;   ///< divided by σ
    // for loops, on request
    PatchMean approach_work, separation_work, loss, greatest_tension;  ///< divided by w; tension divided by σ
    PatchMean large_jumps;                                             ///< share of the loss in jumps above w/100
    std::vector<JumpClass> approach_jumps, separation_jumps;           ///< per patch
    bool converged = true;                                             ///< for every state and loop
};

/// One row per design. Equal bytes for any number of threads: each patch is computed on one thread.
/// @throws InvalidArgument for no design or seed, and as bring_into_contact().
[[nodiscard]] std::vector<SurveyRow> survey(const SurveyDesign& design);

}  // namespace setae::patches
