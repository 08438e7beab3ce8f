// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "setae/loops/loop.hpp"

namespace setae::loops {

/// From one time to another [s], both included.
struct TimeRange {
    double first = 0.0;
    double last = 0.0;

    friend bool operator==(const TimeRange&, const TimeRange&) = default;
};

/// A section of a record as given by a user, by sample or by time.
using GivenRange = std::variant<IndexRange, TimeRange>;

/// Segments of one contact that replace those found.
struct ContactEdits {
    std::optional<GivenRange> jump_in;
    std::optional<GivenRange> loading;
    std::optional<GivenRange> hold;
    std::optional<GivenRange> unloading;
    std::optional<GivenRange> pull_off;
    /// samples at which one cycle ends and the next begins, in order; empty: the cycles found
    std::vector<Index> cuts;

    friend bool operator==(const ContactEdits&, const ContactEdits&) = default;
};

/// Samples that no fit uses, with the reason.
struct IgnoredSamples {
    GivenRange range;
    std::string reason;

    friend bool operator==(const IgnoredSamples&, const IgnoredSamples&) = default;
};

/// Corrections by a user to find_segments: ranges that replace those found, contact by contact.
struct SegmentEdits {
    std::optional<GivenRange> baseline_before;
    std::optional<GivenRange> baseline_after;
    std::vector<ContactEdits> contacts;  ///< edits of contacts 0, 1, …; further ones stay as found
    std::vector<IgnoredSamples> ignored;

    [[nodiscard]] bool empty() const { return *this == SegmentEdits{}; }
    friend bool operator==(const SegmentEdits&, const SegmentEdits&) = default;
};

struct Segments;

/// The segments found, with the edits applied: baselines are measured again, parts of contacts that are not named are
/// kept, cycles follow the given loading, unloading and cuts. Forces are relative to the resulting baseline. @throws
/// InvalidArgument, naming the range and the reason, for a range outside the record, one that ends before it begins, a
/// time where the record has none, segments out of order or overlapping, cuts outside the contact, edits of a contact
/// that was not found, and samples ignored without a reason.
[[nodiscard]] Segments apply(const SegmentEdits& edits, Segments segments, const Loop& loop);

/// The samples of a record in a range. @throws InvalidArgument as apply; `name` is its name in the message.
[[nodiscard]] IndexRange samples_of(const GivenRange& range, const Loop& loop, const std::string& name);

/// Adds an edit written as text:
///
///   loading=120:900            samples 120 … 900 of the first contact
///   unloading@2=12.5s:20s      times, of the second contact
///   baseline=0s:12.5s          before contact; baseline_after=… after it
///   cut@1=400                  a boundary between cycles, after those given before
///   ignore=30:35 (door slammed)
///
/// Names: baseline, baseline_after, jump_in, loading, hold, unloading, pull_off, cut, ignore. Contacts are counted from
/// 1. @throws InvalidArgument for text of another form, with that text.
void add_segment_edit(SegmentEdits& edits, std::string_view text);

}  // namespace setae::loops
