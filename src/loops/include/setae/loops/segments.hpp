// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/loops/loop.hpp"
#include "setae/loops/segment_edits.hpp"

namespace setae::loops {

/// A stretch of free flight: where the zero of force is, and how noisy the record.
struct Baseline {
    std::optional<IndexRange> range;       ///< none where the zero of force was given, not measured
    double force = 0.0;                    ///< median [N]
    double force_standard_error = 0.0;     ///< of the median [N]
    double force_noise = 0.0;              ///< σ_F of one sample [N], a slope taken off
    double force_noise_correlation = 0.0;  ///< φ of neighbouring samples, ρ_k = φ^k; 0 where they tell none
    double displacement_noise = 0.0;       ///< σ_δ of one sample [m], likewise
    double displacement_noise_correlation = 0.0;
    double force_displacement_covariance = 0.0;  ///< [N m]: a deflection sensor enters both channels
    double force_scatter = 0.0;                  ///< standard deviation about the median [N], slow wander included
    double force_slope = 0.0;  ///< of the force along the stretch [N a unit of its clock: s, else sample]
    double force_slope_standard_error = 0.0;
};

/// One press and release within a contact.
struct Cycle {
    IndexRange loading;             ///< from jump-in or the last reversal to the largest force
    IndexRange unloading;           ///< from there to the next reversal or the pull-off minimum
    Index contact = 0;              ///< which of the record's contacts it belongs to, from 0
    bool ends_in_pull_off = false;  ///< false for a partial release
};

/// One touch, from jump-in to pull-off.
struct ContactSegments {
    IndexRange extent;                    ///< with the free flight around it, up to a sample between two contacts
    std::optional<IndexRange> jump_in;    ///< last free sample … force minimum
    IndexRange loading;                   ///< first sample in contact … largest force
    std::optional<IndexRange> hold;       ///< around the largest force, where it hardly changes
    std::optional<IndexRange> unloading;  ///< last press … smallest force, or last sample in contact
    std::optional<IndexRange> pull_off;   ///< force minimum … first free sample
    std::vector<Index> cycles;            ///< into Segments::cycles
};

struct Segments {
    Baseline before;
    std::optional<Baseline> after;  ///< none where the record ends in contact
    std::vector<ContactSegments> contacts;
    std::vector<Cycle> cycles;
    std::vector<IndexRange> ignored;  ///< samples no fit uses: those of the edits, and those of a saturated force
};

struct SegmentOptions {
    double baseline_share = 0.05;          ///< share of the record, from its start, taken as free flight
    std::optional<double> force_baseline;  ///< zero of force [N] where known; nothing is then read from the start
    double feature_factor = 6.0;           ///< a feature deeper than this many baseline scatters is real
    double turning_share = 0.01;           ///< a reversal smaller than this share of the force range is noise
    SegmentEdits edits;                    ///< what the user knows better, applied on top of what is found
};

/// Finds free flight, jump-in, loading, hold, unloading and pull-off of each contact, and the cycles within.
///
/// Without contact radius a contact is known by its adhesion: a force below the baseline after approach (jump-in) or
/// before separation (pull-off). With it, by a > 0. A reversal of force counts as a cycle only where the displacement
/// (else the contact radius) turns with it, so that a slip is no cycle.
/// @throws InvalidArgument for series of different length, an undefined force or displacement, or fewer than 20
/// samples.
/// @throws UndefinedDataError for a constant force, a record without contact, a start that is no free flight, and a
/// "contact" whose force falls as the displacement grows.
[[nodiscard]] Segments find_segments(const Loop& loop, const SegmentOptions& options = {});

}  // namespace setae::loops
