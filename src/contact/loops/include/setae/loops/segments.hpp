// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/loops/force_drift.hpp"
#include "setae/loops/loop.hpp"
#include "setae/loops/segment_edits.hpp"

namespace setae::loops {

/// A section of free flight: zero of force, and noise of the record.
struct Baseline {
    std::optional<IndexRange> range;       ///< empty without free flight, or where the zero of force was given
    double force = 0.0;                    ///< median [N]; without a range the given zero of force
    double force_standard_error = 0.0;     ///< standard error of the median [N]
    double force_noise = 0.0;              ///< σ_F of one sample [N], with a slope subtracted
    double force_noise_correlation = 0.0;  ///< φ of neighbouring samples, ρ_k = φ^k; 0 where they give none
    double displacement_noise = 0.0;       ///< σ_δ of one sample [m], with a slope subtracted
    double displacement_noise_correlation = 0.0;
    double force_displacement_covariance = 0.0;  ///< [N m]: a deflection sensor enters both channels
};

/// One loading and unloading within a contact.
struct Cycle {
    IndexRange loading;             ///< from jump-in or the last reversal to the largest force
    IndexRange unloading;           ///< from there to the next reversal or the pull-off minimum
    Index contact = 0;              ///< number of the contact in the record, counted from 0
    bool ends_in_pull_off = false;  ///< false for a partial release
};

/// One contact, from jump-in to pull-off.
struct ContactSegments {
    IndexRange extent;                    ///< including the free flight around it, up to a sample between two contacts
    std::optional<IndexRange> jump_in;    ///< last free sample … force minimum
    IndexRange loading;                   ///< first sample in contact … largest force
    std::optional<IndexRange> hold;       ///< around the largest force, in the range of nearly constant force
    std::optional<IndexRange> unloading;  ///< end of the last loading … smallest force, or last sample in contact
    std::optional<IndexRange> pull_off;   ///< force minimum … first free sample
    std::vector<Index> cycles;            ///< into Segments::cycles
};

struct Segments {
    Baseline before;  ///< without a range where the record begins in contact; the noise is then that after contact
    std::optional<Baseline> after;  ///< none where the record ends in contact
    std::vector<ContactSegments> contacts;
    std::vector<Cycle> cycles;
    std::vector<IndexRange> ignored;  ///< samples no fit uses: those of the edits, and those of a saturated force
    std::vector<ForceStep> steps;  ///< steps at which free flight was split; the part next to contact is the baseline
};

struct SegmentOptions {
    std::optional<double>
        baseline_share;  ///< share of the record, from its start, that is free flight; else it is determined
    std::optional<double> force_baseline;      ///< zero of force [N] where known; no drift is subtracted then
    DriftModel drift = DriftModel::automatic;  ///< drift of the zero of force; contact is found without it
    double feature_factor = 6.0;  ///< a feature deeper than this multiple of the scatter of free flight is real
    double turning_share = 0.01;  ///< a reversal smaller than this share of the force range is noise
    SegmentEdits edits;           ///< corrections by the user, applied after the segments are found
};

/// Finds free flight, jump-in, loading, hold, unloading and pull-off of each contact, and the cycles within.
///
/// Free flight is found first, by slopes and jumps of the force, which are independent of an offset and a drift of its
/// zero; where the displacement shows no contact, by the contact radius. It is split at sudden steps of the force. Its
/// drift is subtracted, then the other segments are found; for this a noisy force is averaged over neighbours.
///
/// Without contact radius a contact is identified by its adhesion: a force below zero after approach (jump-in) or
/// before separation (pull-off). With it, by a > 0. A reversal of force is a cycle only where the displacement (else
/// the contact radius) reverses with it, so that a slip is no cycle.
/// @throws InvalidArgument for series of different length, an undefined force or displacement, or fewer than 20
/// samples.
/// @throws ChannelFaultError for a record that is consistent with another sign of force or displacement, or with both
/// exchanged. @throws UndefinedDataError for a constant force, a record without contact, one without free flight whose
/// zero of force is not given, and a "contact" whose force decreases as the displacement increases.
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
