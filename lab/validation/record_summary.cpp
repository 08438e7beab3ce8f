// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/statistics.hpp"
#include "setae/validation/record_trials.hpp"

namespace setae::validation {
namespace {

double median_of(std::vector<double> values) { return values.empty() ? undefined : median(values); }

/// Deviation from the true value; for a true value of 0 relative to the work of retraction.
double relative_deviation(const RecordRoute& route, const RecordTrial& trial) {
    double scale = route.known;
    for (const auto& other : trial.routes)
        if (!(scale > 0.0) && other.name == "W_ret") scale = other.known;
    return (route.found.value - route.known) / scale;
}

bool covers(const RecordRoute& route) {
    const auto interval = interval_of(route.found);
    return interval && interval->lower <= route.known && route.known <= interval->upper;
}

/// Off by more than four standard errors and 2 %.
bool is_off(const RecordRoute& route, const RecordTrial& trial) {
    constexpr double deviations = 4.0, share = 0.02;
    return std::abs(route.found.value - route.known) > deviations * std::sqrt(route.found.variance()) &&
           std::abs(relative_deviation(route, trial)) > share;
}

std::string joined(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, " + ")); }

std::string cell(const RouteSummary& route) {
    if (route.count == 0) return "–";
    return fmt::format("{:+.2f} %, {:+.2f} ±, {:.0f} %", 100.0 * route.bias, route.bias_in_errors,
                       100.0 * route.coverage);
}

std::string warnings_of(const RecordSummary& row) {
    std::vector<std::pair<int, std::string>> ranked;
    for (const auto& [code, n] : row.warnings) ranked.emplace_back(-n, code);
    std::sort(ranked.begin(), ranked.end());
    std::vector<std::string> texts;
    constexpr std::size_t most = 4;
    for (std::size_t i = 0; i < std::min(most, ranked.size()); ++i)
        texts.push_back(fmt::format("{} {}", ranked[i].second, -ranked[i].first));
    return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace

RecordSummary summary(const std::vector<RecordTrial>& trials, const std::string& together) {
    RecordSummary row{.kinds = together, .count = static_cast<int>(trials.size())};
    for (const auto& trial : trials) {
        row.refused += !trial.refused.empty();
        row.named += trial.cause_named;
        row.silent += !trial.cause_named && std::any_of(trial.routes.begin(), trial.routes.end(),
                                                        [&](const RecordRoute& route) { return is_off(route, trial); });
        std::vector<std::string> codes = trial.warnings;
        std::sort(codes.begin(), codes.end());
        codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
        for (const auto& code : codes) ++row.warnings[code];
    }
    for (const auto name : route_names) {
        RouteSummary route{.name = std::string(name)};
        std::vector<double> deviations, pulls;
        double covered = 0.0;
        for (const auto& trial : trials)
            for (const auto& found : trial.routes) {
                if (found.name != name || !found.found.uncertain()) continue;
                deviations.push_back(relative_deviation(found, trial));
                pulls.push_back((found.found.value - found.known) / found.found.standard_error);
                covered += covers(found);
            }
        route.count = static_cast<int>(pulls.size());
        if (route.count > 0) route.coverage = covered / route.count;
        route.bias = median_of(deviations);
        route.bias_in_errors = median_of(pulls);
        row.routes.push_back(route);
    }
    return row;
}

std::vector<RecordSummary> summary(const std::vector<RecordTrial>& trials) {
    std::vector<RecordSummary> rows;
    std::vector<RecordTrial> same;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        same.push_back(trials[i]);
        if (i + 1 < trials.size() && trials[i + 1].kinds == trials[i].kinds) continue;
        rows.push_back(summary(same, joined(same.front().kinds)));
        same.clear();
    }
    return rows;
}

std::string record_table(const std::vector<RecordSummary>& rows) {
    std::string text = "| records | n | refused | cause named | silently wrong |";
    for (const auto name : route_names) text += fmt::format(" {} |", name);
    text += " warnings |\n|";
    for (std::size_t i = 0; i < 6 + route_names.size(); ++i) text += "---|";
    text += "\n";
    for (const auto& row : rows) {
        text += fmt::format("| {} | {} | {} | {} | {} |", row.kinds, row.count, row.refused, row.named, row.silent);
        for (const auto& route : row.routes) text += fmt::format(" {} |", cell(route));
        text += fmt::format(" {} |\n", warnings_of(row));
    }
    return text;
}

std::string record_csv(const std::vector<RecordTrial>& trials) {
    std::string text = "kinds,seed,route,known,found,standard_error,lower,upper,cause_named,warnings,refused\n";
    const auto row = [&](const RecordTrial& trial, const std::string& numbers) {
        std::string reason = trial.refused;
        std::replace(reason.begin(), reason.end(), '"', '\'');
        text += fmt::format("{},{},{},{},{},\"{}\"\n", joined(trial.kinds), trial.seed, numbers,
                            trial.cause_named ? "yes" : "no", fmt::join(trial.warnings, " "), reason);
    };
    for (const auto& trial : trials) {
        if (trial.routes.empty()) row(trial, ",,,,,");
        for (const auto& route : trial.routes) {
            const auto interval = interval_of(route.found);
            row(trial,
                fmt::format("{},{},{},{},{},{}", route.name, route.known, route.found.value, route.found.standard_error,
                            interval ? interval->lower : undefined, interval ? interval->upper : undefined));
        }
    }
    return text;
}

}  // namespace setae::validation
