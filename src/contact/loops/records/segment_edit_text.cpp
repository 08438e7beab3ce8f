// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/loops/segment_edits.hpp"

namespace setae::loops {
namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
    throw InvalidArgument(
        fmt::format("segment '{}': {}; expected for instance loading=120:900, unloading@2=12.5s:20s or ignore=30:35 "
                    "(reason)",
                    text, why));
}

GivenRange range_from(std::string_view range, std::string_view whole) {
    const auto colon = range.find(':');
    if (colon == std::string_view::npos) refuse(whole, "a range needs the form FIRST:LAST");
    const std::string_view first = trimmed(range.substr(0, colon)), last = trimmed(range.substr(colon + 1));
    const auto first_sample = spelled<Index>(first), last_sample = spelled<Index>(last);
    if (first_sample && last_sample) return IndexRange{*first_sample, *last_sample};
    if (first_sample || last_sample)
        refuse(whole, "one end is a sample, the other a time; give both as samples or both as times");
    try {
        return TimeRange{parse_quantity(first, dimension::time), parse_quantity(last, dimension::time)};
    } catch (const InvalidArgument& error) {
        refuse(whole, error.what());
    }
}

/// The segment of a contact with a given name.
template <class Contact>
auto* segment_of(Contact& contact, std::string_view name) {
    if (name == "jump_in") return &contact.jump_in;
    if (name == "loading") return &contact.loading;
    if (name == "hold") return &contact.hold;
    if (name == "unloading") return &contact.unloading;
    if (name == "pull_off") return &contact.pull_off;
    return decltype(&contact.jump_in){nullptr};
}

IgnoredSamples ignored_from(std::string_view value, std::string_view whole) {
    const auto open = value.find('(');
    if (open == std::string_view::npos || value.back() != ')')
        refuse(whole, "ignored samples need a reason in brackets");
    return {.range = range_from(value.substr(0, open), whole),
            .reason = std::string(trimmed(value.substr(open + 1, value.size() - open - 2)))};
}

}  // namespace

void add_segment_edit(SegmentEdits& edits, std::string_view text) {
    const auto equals = text.find('=');
    if (equals == std::string_view::npos) refuse(text, "no '='");
    std::string_view name = trimmed(text.substr(0, equals));
    const std::string_view value = trimmed(text.substr(equals + 1));
    if (value.empty()) refuse(text, "a range is missing after '='");
    if (name == "baseline") {
        edits.baseline_before = range_from(value, text);
        return;
    }
    if (name == "baseline_after") {
        edits.baseline_after = range_from(value, text);
        return;
    }
    if (name == "ignore") {
        edits.ignored.push_back(ignored_from(value, text));
        return;
    }
    std::size_t contact = 1;
    if (const auto at = name.find('@'); at != std::string_view::npos) {
        constexpr Index most = 10000;
        const auto number = spelled<Index>(name.substr(at + 1));
        if (!number || *number < 1 || *number > most) refuse(text, "the number of a contact starts at 1");
        contact = static_cast<std::size_t>(*number);
        name = name.substr(0, at);
    }
    ContactEdits scratch;
    const bool cut = name == "cut";
    if (!cut && segment_of(scratch, name) == nullptr)
        refuse(
            text,
            fmt::format("'{}' is unknown; expected one of baseline, baseline_after, jump_in, loading, hold, unloading, "
                        "pull_off, cut, ignore",
                        name));
    const auto sample = cut ? spelled<Index>(value) : std::nullopt;
    if (cut && !sample) refuse(text, "a cut needs exactly one sample");
    const auto range = cut ? std::nullopt : std::optional(range_from(value, text));
    if (edits.contacts.size() < contact) edits.contacts.resize(contact);
    ContactEdits& edit = edits.contacts[contact - 1];
    if (cut) edit.cuts.push_back(*sample);
    else *segment_of(edit, name) = range;
}

}  // namespace setae::loops
