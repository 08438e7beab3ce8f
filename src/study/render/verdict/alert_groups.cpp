// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string_view>

#include "setae/output/study_tables.hpp"
#include "setae/output/verdict.hpp"

namespace setae::output {
namespace {

/// Kinds that put a number in doubt, worst first; others follow in the order they were found.
constexpr std::array<std::string_view, 24> telling{
    "INPUT_CHANGED",     "UNITS_IMPLAUSIBLE",    "PART_FAILED",       "LIKELIHOOD_FAILED",
    "NOT_CONVERGED",     "FILES_LEFT_OUT",       "UNREADABLE_MEMBER", "UNIT_MISMATCH",
    "SIZE_MISMATCH",     "INSTRUMENTS_DISAGREE", "NO_INSTRUMENT",     "NO_TIP_RADIUS",
    "SAME_MEASUREMENT",  "UNIT_GUESSED",         "UNIT_ASSUMED",      "SPECTRUM_CONVENTION",
    "WAVES_BEYOND_DATA", "BAND_LIMITED",         "ONE_PLACE",         "HEIGHT_UNKNOWN",
    "WILL_NOT_CONFORM",  "MEASUREMENTS_SCATTER", "MEASURED_SLOPES",   "SINGLE_INSTRUMENT_DECADE"};

/// Kinds before these: which numbers of a file are heights at all.
constexpr std::array<std::string_view, 9> of_heights{"HEIGHTS_IMPLAUSIBLE", "CONSTANT",     "GAP_BRIDGED",
                                                     "NO_DATA_SUSPECTED",   "NO_DATA",      "LABELS_NOT_HEIGHTS",
                                                     "POSITIONS_REPEATED",  "ROWS_MISSING", "PASSES_SPLIT"};

template <std::size_t n>
std::size_t place_in(const std::array<std::string_view, n>& kinds, const std::string& code) {
    return static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), code) - kinds.begin());
}

std::size_t rank_of(const AlertGroup& group) {
    const auto first = place_in(of_heights, group.code);
    return first < of_heights.size() ? first : first + place_in(telling, group.code);
}

}  // namespace

std::vector<AlertGroup> grouped_alerts(const study::StudyResult& result) {
    std::vector<AlertGroup> groups;
    for (const auto& row : alert_table(result).rows) {
        const auto text = [&row](std::size_t column) { return std::get<std::string>(row[column]); };
        auto group =
            std::find_if(groups.begin(), groups.end(), [&](const auto& known) { return known.code == text(0); });
        if (group == groups.end()) group = groups.insert(groups.end(), {text(0), {}});
        group->alerts.push_back({text(0), text(1), text(2), text(3)});
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const auto& a, const auto& b) { return rank_of(a) < rank_of(b); });
    return groups;
}

}  // namespace setae::output
