// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "setae/validation/contour_trials.hpp"

namespace setae::validation {

/// A number over the runs of a kind; NaN where no run has it, the standard error also where only one run has it.
struct OverRuns {
    int count = 0;
    double mean = 0.0, standard_error = 0.0;
    double worst = 0.0;  ///< largest deviation from the expected value
    int worst_run = 0;
};

/// All trials of one kind of picture.
struct ContourRow {
    std::string kind;
    bool judged = true;
    int runs = 0, refused = 0, vacuum_mistaken = 0;
    OverRuns segments, completeness, rms_error, largest_error, offset, within_two_errors, rms_height_ratio, floor_ratio,
        overhang_depth_ratio;
    std::array<OverRuns, 5> spectrum_ratio;
    int overhangs = 0, overhangs_found = 0, overhangs_false = 0;
};

/// One row per kind, in the order of their first appearance.
[[nodiscard]] std::vector<ContourRow> contour_summary(const std::vector<ContourTrial>& trials);

/// A criterion for traces, and whether it is met.
struct ContourVerdict {
    std::string kind, criterion;  ///< "rms error below 0.5 px in every run"
    bool passed = false;
    std::string found;  ///< "0.41 px on average, 0.47 px in run 12"
};

/// For judged kinds: no picture refused; vacuum distinguished from the sample; rms error below 0.5 px in every run;
/// overhangs all found and none false; where the profile is judged, Rq within 2 % in every run and C1D within 10 % in
/// each half decade on average.
[[nodiscard]] std::vector<ContourVerdict> contour_verdicts(const std::vector<ContourRow>& rows);

/// Rows as aligned text, then their spectra, then verdicts: those that failed, and how many passed.
[[nodiscard]] std::string contour_table(const std::vector<ContourRow>& rows);

/// Every trial as CSV.
[[nodiscard]] std::string contour_trials_csv(const std::vector<ContourTrial>& trials);

}  // namespace setae::validation
