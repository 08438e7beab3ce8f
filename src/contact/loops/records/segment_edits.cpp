// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/segment_edits.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "baseline.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/segments.hpp"

namespace setae::loops {
namespace {

std::string described(const IndexRange& range) { return fmt::format("samples {} to {}", range.first, range.last); }

[[noreturn]] void refuse_edit(const std::string& name, const std::string& why) {
    throw InvalidArgument(fmt::format("{}: {}", name, why));
}

/// One section of a contact in its order, found or given.
struct Part {
    std::string name;
    std::optional<IndexRange> range;
    bool given = false;
    bool needed = false;
};

/// Shortens found parts in favour of given ones; two given ones may share one sample.
void fit_together(std::vector<Part>& parts) {
    Part* before = nullptr;
    for (Part& part : parts) {
        if (!part.range) continue;
        if (before != nullptr && before->range->last > part.range->first) {
            if (before->given && part.given)
                refuse_edit(part.name, fmt::format("{} overlap those of {}, {}", described(*part.range), before->name,
                                                   described(*before->range)));
            if (part.given) before->range->last = part.range->first;
            else part.range->first = before->range->last;
            for (Part* shortened : {before, &part}) {
                if (shortened->range->first <= shortened->range->last) continue;
                if (shortened->needed)
                    refuse_edit(part.given ? part.name : before->name,
                                fmt::format("{} leave no samples for {}; give that range as well",
                                            described(part.given ? *part.range : *before->range), shortened->name));
                shortened->range.reset();
            }
        }
        if (part.range) before = &part;
    }
}

Index index_of_largest(const Array1D& values, const IndexRange& range) {
    Index at = 0;
    values.segment(range.first, range.count()).maxCoeff(&at);
    return range.first + at;
}

Index end_of(const ContactSegments& contact) {
    if (contact.pull_off) return contact.pull_off->last;
    return contact.unloading ? contact.unloading->last : contact.loading.last;
}

Index start_of(const ContactSegments& contact) {
    return contact.jump_in ? contact.jump_in->first : contact.loading.first;
}

std::vector<Cycle> cycles_between(const std::vector<Index>& cuts, const ContactSegments& contact, const Loop& loop,
                                  const std::string& name) {
    std::vector<Cycle> cycles;
    const Index end = contact.unloading ? contact.unloading->last : contact.loading.last;
    Index start = contact.loading.first;
    const auto add = [&](Index stop, bool last) {
        const Index peak = index_of_largest(loop.force, {start, stop});
        cycles.push_back({.loading = {start, peak},
                          .unloading = {peak, stop},
                          .ends_in_pull_off = last && contact.pull_off.has_value()});
        start = stop;
    };
    for (const Index cut : cuts) {
        if (cut <= start || cut >= end)
            refuse_edit(name, fmt::format("sample {} must lie between samples {} and {}, and cuts must increase", cut,
                                          start, end));
        add(cut, false);
    }
    add(end, true);
    return cycles;
}

/// The cycles found, limited to the present loading and unloading.
std::vector<Cycle> cycles_within(std::vector<Cycle> cycles, const ContactSegments& contact) {
    if (!contact.unloading) return {};
    std::erase_if(cycles, [&](const Cycle& c) {
        return c.unloading.last <= contact.loading.first || c.loading.last >= contact.unloading->last;
    });
    if (cycles.empty())
        return {{.loading = contact.loading,
                 .unloading = *contact.unloading,
                 .ends_in_pull_off = contact.pull_off.has_value()}};
    Cycle &first = cycles.front(), &last = cycles.back();
    first.loading.first = contact.loading.first;
    if (cycles.size() == 1) first.loading.last = std::max(contact.loading.last, first.loading.first);
    last.unloading.last = contact.unloading->last;
    last.unloading.first = std::max(contact.unloading->first, last.loading.first);
    last.ends_in_pull_off = contact.pull_off.has_value();
    return cycles;
}

void edit_contact(ContactSegments& contact, const ContactEdits& edits, const Loop& loop, const std::string& suffix) {
    const auto given = [&](const std::optional<GivenRange>& range, const std::string& name) {
        return range ? std::optional(samples_of(*range, loop, name)) : std::nullopt;
    };
    const auto part = [&](const char* name, const std::optional<GivenRange>& edit,
                          const std::optional<IndexRange>& found, bool needed) {
        Part made{.name = name + suffix, .range = found, .given = edit.has_value(), .needed = needed};
        if (edit) made.range = given(edit, made.name);
        return made;
    };
    std::vector<Part> parts{part("jump_in", edits.jump_in, contact.jump_in, false),
                            part("loading", edits.loading, contact.loading, true),
                            part("unloading", edits.unloading, contact.unloading, true),
                            part("pull_off", edits.pull_off, contact.pull_off, false)};
    fit_together(parts);
    contact.jump_in = parts[0].range;
    contact.loading = *parts[1].range;
    contact.unloading = parts[2].range;
    contact.pull_off = parts[3].range;
    const IndexRange pressed{contact.loading.first, contact.unloading ? contact.unloading->last : contact.loading.last};
    if (const auto hold = given(edits.hold, "hold" + suffix)) {
        if (!pressed.contains(hold->first) || !pressed.contains(hold->last))
            refuse_edit("hold" + suffix, fmt::format("{} do not lie within loading and unloading, {}", described(*hold),
                                                     described(pressed)));
        contact.hold = hold;
    } else if (contact.hold && !(pressed.contains(contact.hold->first) && pressed.contains(contact.hold->last))) {
        contact.hold.reset();
    }
    contact.extent.first = std::min(contact.extent.first, start_of(contact));
    contact.extent.last = std::max(contact.extent.last, end_of(contact));
}

/// Contacts follow each other; free flight between them belongs to the earlier one.
void part_contacts(std::vector<ContactSegments>& contacts) {
    for (std::size_t k = 0; k + 1 < contacts.size(); ++k) {
        if (end_of(contacts[k]) >= start_of(contacts[k + 1]))
            refuse_edit(fmt::format("contact {}", k + 1),
                        fmt::format("ends at sample {}, after the start of contact {} at sample {}",
                                    end_of(contacts[k]), k + 2, start_of(contacts[k + 1])));
        contacts[k].extent.last =
            std::clamp(contacts[k].extent.last, end_of(contacts[k]), start_of(contacts[k + 1]) - 1);
        contacts[k + 1].extent.first = contacts[k].extent.last + 1;
    }
}

}  // namespace

IndexRange samples_of(const GivenRange& given, const Loop& loop, const std::string& name) {
    const Index n = loop.force.size();
    IndexRange range;
    if (const auto* times = std::get_if<TimeRange>(&given)) {
        if (loop.time.size() != n)
            refuse_edit(name, fmt::format("{} s to {} s: the record has no time; give sample numbers", times->first,
                                          times->last));
        if (!(times->first <= times->last))
            refuse_edit(name, fmt::format("{} s to {} s ends before it begins", times->first, times->last));
        range = {.first = n, .last = -1};
        for (Index i = 0; i < n; ++i)
            if (loop.time[i] >= times->first && loop.time[i] <= times->last) {
                range.first = std::min(range.first, i);
                range.last = i;
            }
        if (range.last < 0)
            refuse_edit(name, fmt::format("{} s to {} s contains no sample; the record runs from {} s to {} s",
                                          times->first, times->last, loop.time[0], loop.time[n - 1]));
        return range;
    }
    range = std::get<IndexRange>(given);
    if (range.last < range.first) refuse_edit(name, described(range) + " end before they begin");
    if (range.first < 0 || range.last >= n)
        refuse_edit(name, fmt::format("{} lie outside the record, which has samples 0 to {}", described(range), n - 1));
    return range;
}

Segments apply(const SegmentEdits& edits, Segments segments, const Loop& loop) {
    if (edits.empty()) return segments;
    if (edits.baseline_before) segments.before = given_baseline(loop, *edits.baseline_before, "baseline");
    if (edits.baseline_after) segments.after = given_baseline(loop, *edits.baseline_after, "baseline_after");
    if (edits.contacts.size() > segments.contacts.size())
        throw InvalidArgument(fmt::format("segments are given for contact {}, but the record has {}",
                                          edits.contacts.size(), segments.contacts.size()));
    for (std::size_t k = 0; k < edits.contacts.size(); ++k)
        edit_contact(segments.contacts[k], edits.contacts[k], loop, k == 0 ? "" : fmt::format("@{}", k + 1));
    part_contacts(segments.contacts);
    const std::vector<Cycle> found = std::exchange(segments.cycles, {});
    for (std::size_t k = 0; k < segments.contacts.size(); ++k) {
        ContactSegments& contact = segments.contacts[k];
        std::vector<Cycle> cycles;
        for (const Index i : std::exchange(contact.cycles, {})) cycles.push_back(found[static_cast<std::size_t>(i)]);
        if (k < edits.contacts.size() && edits.contacts[k] != ContactEdits{}) {
            const auto& cuts = edits.contacts[k].cuts;
            cycles = cuts.empty() ? cycles_within(std::move(cycles), contact)
                                  : cycles_between(cuts, contact, loop, fmt::format("cut@{}", k + 1));
        }
        for (Cycle& cycle : cycles) {
            cycle.contact = static_cast<Index>(k);
            contact.cycles.push_back(static_cast<Index>(segments.cycles.size()));
            segments.cycles.push_back(cycle);
        }
    }
    for (const IgnoredSamples& ignored : edits.ignored) {
        segments.ignored.push_back(samples_of(ignored.range, loop, "ignore"));
        if (ignored.reason.empty())
            refuse_edit("ignore",
                        described(segments.ignored.back()) + " need a reason, such as ignore=30:35 (door slammed)");
    }
    const auto& after = edits.baseline_after;
    if (after && segments.after->range->first <= end_of(segments.contacts.back()))
        refuse_edit("baseline_after", fmt::format("{} begin before contact ends at sample {}",
                                                  described(*segments.after->range), end_of(segments.contacts.back())));
    if (edits.baseline_before && segments.before.range->last > start_of(segments.contacts.front()))
        refuse_edit("baseline", fmt::format("{} reach into contact, which begins at sample {}",
                                            described(*segments.before.range), start_of(segments.contacts.front())));
    return segments;
}

}  // namespace setae::loops
