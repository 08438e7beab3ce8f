// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/alert_groups.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "setae/core/words.hpp"
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

/// Kinds before these: whether numbers of a file are heights at all.
constexpr std::array<std::string_view, 9> of_heights{"HEIGHTS_IMPLAUSIBLE", "CONSTANT",     "GAP_BRIDGED",
                                                     "NO_DATA_SUSPECTED",   "NO_DATA",      "LABELS_NOT_HEIGHTS",
                                                     "POSITIONS_REPEATED",  "ROWS_MISSING", "PASSES_SPLIT"};

/// Kinds that describe the surface or the method.
constexpr std::array<std::string_view, 17> general{"UNKNOWN_FIELD",
                                                   "NAME_MISSING",
                                                   "NO_PROCESSED_COPY",
                                                   "PIXELS_NOT_SQUARE",
                                                   "SIZE_BETWEEN_POINTS",
                                                   "TWO_EDGES",
                                                   "CLOSED_OUTLINE",
                                                   "CONTOUR_STEPS",
                                                   "ONE_DIRECTION",
                                                   "NON_GAUSSIAN",
                                                   "MEASURED_SLOPES",
                                                   "ONE_PLACE",
                                                   "SINGLE_INSTRUMENT_DECADE",
                                                   "SINGLE_MEASUREMENT_DECADE",
                                                   "STD_WITHOUT_DIRECTION",
                                                   "COLUMN_UNUSED",
                                                   "TWO_CONTACTS"};

template <std::size_t n>
std::size_t place_in(const std::array<std::string_view, n>& kinds, const std::string& code) {
    return static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), code) - kinds.begin());
}

std::size_t rank_of(const AlertGroup& group) {
    const auto first = place_in(of_heights, group.code);
    return first < of_heights.size() ? first : first + place_in(telling, group.code);
}

void add_once(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

std::vector<AlertGroup> grouped_alerts(const std::vector<Alert>& alerts) {
    std::vector<AlertGroup> groups;
    for (const auto& alert : alerts) {
        auto group =
            std::find_if(groups.begin(), groups.end(), [&](const auto& known) { return known.code == alert.code; });
        if (group == groups.end()) group = groups.insert(groups.end(), {alert.code, {}});
        group->alerts.push_back(alert);
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const auto& a, const auto& b) { return rank_of(a) < rank_of(b); });
    return groups;
}

std::vector<AlertGroup> grouped_alerts(const study::StudyResult& result) {
    std::vector<Alert> alerts;
    for (const auto& row : alert_table(result).rows) {
        const auto text = [&row](std::size_t column) { return std::get<std::string>(row[column]); };
        alerts.push_back({text(0), text(1), text(2), text(3)});
    }
    return grouped_alerts(alerts);
}

bool is_general_warning(const std::string& code) { return place_in(general, code) < general.size(); }

std::string warning_line(const Alert& alert) {
    return fmt::format("{}: {}: {}{}{}", alert.code, alert.subject, alert.message, alert.action.empty() ? "" : "; ",
                       alert.action);
}

std::vector<std::string> warning_lines(const std::vector<Alert>& alerts, std::string (*line_of)(const Alert&)) {
    constexpr std::size_t several = 3;
    std::vector<std::string> lines, kinds;
    std::size_t folded = 0;
    for (const auto& [code, group] : grouped_alerts(alerts)) {
        if (is_general_warning(code)) {
            kinds.push_back(code);
            folded += group.size();
            continue;
        }
        std::vector<std::string> subjects;
        for (const auto& alert : group) add_once(subjects, alert.subject);
        if (subjects.size() < several) {
            for (const auto& alert : group) lines.push_back(line_of(alert));
            continue;
        }
        subjects.erase(subjects.begin());
        lines.push_back(fmt::format("{}; also {}; --all shows each", line_of(group.front()), listed(subjects)));
    }
    if (folded > 0)
        lines.push_back(fmt::format("{} ({}); --all shows {}", counted(folded, "general warning", "general warnings"),
                                    listed(kinds), folded == 1 ? "it" : "them"));
    return lines;
}

}  // namespace setae::output
