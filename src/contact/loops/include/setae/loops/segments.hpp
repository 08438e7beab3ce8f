// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/loops/force_drift.hpp"
#include "setae/loops/loop.hpp"
#include "setae/loops/segment_edits.hpp"

namespace setae::loops {

/// A stretch of free flight: where the zero of force is, and how noisy the record.
struct Baseline {
    std::optional<IndexRange> range;       ///< none where there is none, or where the zero of force was given
    double force = 0.0;                    ///< median [N]; without a range the zero of force given
    double force_standard_error = 0.0;     ///< of the median [N]
    double force_noise = 0.0;              ///< σ_F of one sample [N], a slope taken off
    double force_noise_correlation = 0.0;  ///< φ of neighbouring samples, ρ_k = φ^k; 0 where they tell none
    double displacement_noise = 0.0;       ///< σ_δ of one sample [m], likewise
    double displacement_noise_correlation = 0.0;
    double force_displacement_covariance = 0.0;  ///< [N m]: a deflection sensor enters both channels
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
    Baseline before;  ///< without a range where the record begins in contact; then the noise is that after
    std::optional<Baseline> after;  ///< none where the record ends in contact
    std::vector<ContactSegments> contacts;
    std::vector<Cycle> cycles;
    std::vector<IndexRange> ignored;  ///< samples no fit uses: those of the edits, and those of a saturated force
    std::vector<ForceStep> steps;     ///< at which free flight was cut; the part next to contact is the baseline
};

struct SegmentOptions {
    std::optional<double>
        baseline_share;  ///< share of the record, from its start, that is free flight; else it is found
    std::optional<double> force_baseline;      ///< zero of force [N] where known; no drift is then taken off
    DriftModel drift = DriftModel::automatic;  ///< of the zero of force; contact is found without it
    double feature_factor = 6.0;               ///< a feature deeper than this many scatters of free flight is real
    double turning_share = 0.01;               ///< a reversal smaller than this share of the force range is noise
    SegmentEdits edits;                        ///< what the user knows better, applied on top of what is found
};

/// Finds free flight, jump-in, loading, hold, unloading and pull-off of each contact, and the cycles within.
///
/// Free flight is found first, by slopes and jumps of the force, which an offset and a drift of its zero do not change;
/// where the displacement shows no contact, by the contact radius. It is cut at sudden steps of the force. The drift
/// that it shows is taken off, then the rest is found: a force noisy against what it has to show is averaged over
/// neighbours for that.
///
/// Without contact radius a contact is known by its adhesion: a force below zero after approach (jump-in) or before
/// separation (pull-off). With it, by a > 0. A reversal of force counts as a cycle only where the displacement (else
/// the contact radius) turns with it, so that a slip is no cycle.
/// @throws InvalidArgument for series of different length, an undefined force or displacement, or fewer than 20
/// samples.
/// @throws ChannelFaultError for a record that makes sense with another sign of force or displacement, or with both
/// exchanged. @throws UndefinedDataError for a constant force, a record without contact, one without free flight whose
/// zero of force is not given, and a "contact" whose force falls as the displacement grows.
[[nodiscard]] Segments find_segments(const Loop& loop, const SegmentOptions& options = {});

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::ContactSegments> {
    using T = loops::ContactSegments;
    static constexpr std::array rows{
        field<&T::extent>("extent", "samples in contact"),
        field<&T::jump_in>("jump_in", "samples of the jump into contact").or_null(),
        field<&T::loading>("loading", "loading branch"),
        field<&T::hold>("hold", "changes while the load is held").or_null(),
        field<&T::unloading>("unloading", "unloading branch; null where there is none").or_null(),
        field<&T::pull_off>("pull_off", "smallest force").or_null(),
        inner<&T::cycles>(),
    };
    static constexpr Description description{"", "segments of one contact", rows};
};
static_assert(complete<loops::ContactSegments>);

template <>
struct Described<loops::Segments> {
    using T = loops::Segments;
    static constexpr std::array rows{
        made<T>("baseline_before", "samples before contact", [](const T& of) { return of.before.range; }).or_null(),
        made<T>("baseline_after", "samples after contact",
                [](const T& of) { return of.after ? of.after->range : std::nullopt; })
            .or_null(),
        field<&T::contacts>("contacts", "one entry per contact"),
        field<&T::ignored>("ignored", "samples that were left out"),
        inner<&T::before>(),
        inner<&T::after>(),
        inner<&T::cycles>(),
        inner<&T::steps>(),
    };
    static constexpr Description description{"segments", "segments of a record", rows};
};
static_assert(complete<loops::Segments>);

}  // namespace setae::fields
