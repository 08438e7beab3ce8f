// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "setae/core/errors.hpp"
#include "setae/loops/segments.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::segment_edits_property_test {
namespace {

GivenRange some_range(Index samples) {
    const auto first = *rc::gen::inRange<Index>(-2, samples), last = *rc::gen::inRange<Index>(-2, samples + 2);
    if (*rc::gen::inRange(0, 4) == 0)
        return TimeRange{0.1 * static_cast<double>(first), 0.1 * static_cast<double>(last)};
    return IndexRange{first, last};
}

SegmentEdits some_edits(Index samples) {
    const auto maybe = [&](std::optional<GivenRange>& range) {
        if (*rc::gen::inRange(0, 3) == 0) range = some_range(samples);
    };
    SegmentEdits edits;
    maybe(edits.baseline_before);
    maybe(edits.baseline_after);
    ContactEdits contact;
    for (auto* range : {&contact.jump_in, &contact.loading, &contact.hold, &contact.unloading, &contact.pull_off})
        maybe(*range);
    if (*rc::gen::inRange(0, 2) == 0) contact.cuts.push_back(*rc::gen::inRange<Index>(0, samples));
    if (contact != ContactEdits{}) edits.contacts.push_back(contact);
    if (*rc::gen::inRange(0, 2) == 0) edits.ignored.push_back({some_range(samples), "a reason"});
    return edits;
}

RC_GTEST_PROP(SegmentEditsProperty, AreRefusedOrKeepSegmentsInOrder, ()) {
    static const Loop loop = tests::SyntheticLoop{.samples = 60}.make();
    static const Segments found = find_segments(loop);
    const Index n = loop.force.size();
    Segments segments;
    try {
        segments = apply(some_edits(n), found, loop);
    } catch (const InvalidArgument&) {
        return;
    }
    const ContactSegments& contact = segments.contacts[0];
    Index at = contact.extent.first;
    const auto follows = [&](const std::optional<IndexRange>& range) {
        if (!range) return;
        RC_ASSERT(range->first >= at);
        RC_ASSERT(range->last >= range->first);
        at = range->last;
    };
    follows(contact.jump_in);
    follows(contact.loading);
    follows(contact.unloading);
    follows(contact.pull_off);
    RC_ASSERT(at <= contact.extent.last);
    RC_ASSERT(contact.extent.first >= 0);
    RC_ASSERT(contact.extent.last < n);
    for (const Cycle& cycle : segments.cycles) {
        RC_ASSERT(cycle.loading.first <= cycle.loading.last);
        RC_ASSERT(cycle.unloading.first <= cycle.unloading.last);
        RC_ASSERT(cycle.loading.first >= contact.loading.first);
        RC_ASSERT(cycle.unloading.last <= contact.unloading->last);
    }
}

}  // namespace
}  // namespace setae::loops::segment_edits_property_test
