// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/loop_answer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/core/words.hpp"

namespace setae::output {
namespace {

using loops::ForceCurveSummary;
using loops::Outcome;

std::string text_or_reason(const Outcome<Estimate>& outcome, const char* unit) {
    return outcome ? format_uncertain(*outcome, unit) : fmt::format("– ({})", outcome.reason);
}

/// The unit after a number, with its blank.
std::string unit_behind(const std::string& text) { return text.substr(std::min(text.rfind(' '), text.size())); }

/// A number without its unit where that is the unit of another.
std::string without_unit_of(const std::string& other, const std::string& text) {
    const auto unit = unit_behind(text);
    return unit == unit_behind(other) ? text.substr(0, text.size() - unit.size()) : text;
}

/// W of loading, and how far it runs with the samples dropped at the beginning where it does.
std::string work_with_range(const loops::BranchAnalysis& loading) {
    const auto work = format_uncertain(loading.primary().work_of_adhesion, "J/m2");
    std::vector<double> tried;
    for (const auto& beginning : loading.sensitivity)
        if (beginning.fit) tried.push_back(beginning.fit->work_of_adhesion.value);
    if (tried.size() < 2) return work;
    const auto [least, most] = std::minmax_element(tried.begin(), tried.end());
    const auto from = format_value(*least, "J/m2", 3), to = format_value(*most, "J/m2", 3);
    if (from == to) return work;
    return fmt::format("{} ({} to {} for other ranges)", work, without_unit_of(work, from), without_unit_of(work, to));
}

/// " (poor fit, χ²_red 149)" where loading has this warning.
std::string quality_of_loading(const loops::LoopAnalysis& loop) {
    const auto warns = [&](const char* code) {
        return std::any_of(loop.alerts.begin(), loop.alerts.end(), [&](const Alert& alert) {
            return alert.code == code && alert.message.starts_with("loading");
        });
    };
    if (warns("POOR_FIT")) return fmt::format(" (poor fit, χ²_red {:.3g})", loop.loading.primary().chi2_reduced);
    if (warns("BEYOND_NOISE")) return fmt::format(" (χ²_red {:.3g})", loop.loading.primary().chi2_reduced);
    return "";
}

std::string loading_text(const loops::LoopAnalysis& loop) {
    const auto& fit = loop.loading.primary();
    if (!fit.converged) return "E* –, W – on loading (the fit did not converge)";
    return fmt::format("E* {}, W {} on loading{}", format_uncertain(fit.contact_modulus, "Pa"),
                       work_with_range(loop.loading), quality_of_loading(loop));
}

/// Reasons why curves have no E*, the most frequent first.
std::string reasons_text(const study::ForceMap& map) {
    std::map<std::string, int> counts;
    for (const auto& curve : map.curves) {
        const auto& modulus =
            curve.summary ? curve.summary->contact_modulus : Outcome<Estimate>::missing(curve.summary.reason);
        if (!modulus) ++counts[modulus.reason];
    }
    std::vector<std::pair<int, std::string>> ranked;
    std::size_t all = 0;
    for (const auto& [reason, count] : counts) {
        ranked.emplace_back(-count, reason);
        all += static_cast<std::size_t>(count);
    }
    if (all == 0) return "";
    std::sort(ranked.begin(), ranked.end());
    return fmt::format("; {} without E*, most frequent reason: {}", counted(all, "curve", "curves"),
                       ranked.front().second);
}

/// Median and half the range of the middle 68 % of a quantity over the curves.
Outcome<Estimate> middle_of(const study::ForceMap& map, Outcome<Estimate> ForceCurveSummary::*value) {
    std::vector<double> values;
    for (const auto& curve : map.curves)
        if (curve.summary && (*curve.summary).*value) values.push_back(((*curve.summary).*value)->value);
    if (values.empty()) return Outcome<Estimate>::missing("no curve gives a value");
    std::sort(values.begin(), values.end());
    const double below = normal_probability(-1.0);
    const double middle = sorted_quantile(values, 0.5),
                 scatter = 0.5 * (sorted_quantile(values, 1.0 - below) - sorted_quantile(values, below));
    const bool rounding = scatter <= 1e-9 * std::abs(middle);  // one curve, or equal curves
    return Estimate{middle, rounding ? undefined : scatter, "middle 68 %"};
}

}  // namespace

std::string answer(const loops::LoopAnalysis& loop) {
    const auto loss =
        loop.loop ? Outcome<Estimate>(loop.loop->estimate()) : Outcome<Estimate>::missing(loop.loop.reason);
    return fmt::format(
        "{}, {}, loss {}", loading_text(loop),
        loop.pull_off ? fmt::format("{} at pull-off ({})", format_uncertain(loop.pull_off->work_of_adhesion, "J/m2"),
                                    format_uncertain(loop.pull_off->force, "N"))
                      : fmt::format("pull-off – ({})", loop.pull_off.reason),
        text_or_reason(loss, "J"));
}

std::string answer(const ForceCurveSummary& curve) {
    const auto modulus = fmt::format("E* {}{}", text_or_reason(curve.contact_modulus, "Pa"),
                                     curve.fitted_segment.empty() ? "" : " on " + curve.fitted_segment);
    const auto pull_off = text_or_reason(curve.pull_off_force, "N"),
               work = text_or_reason(curve.work_of_adhesion, "J/m2");
    const bool one_reason = curve.work_by_pull_off && !curve.pull_off_force;
    return fmt::format("{}, {}, loss {}", modulus,
                       one_reason
                           ? fmt::format("pull-off and W {}", pull_off)
                           : fmt::format("pull-off {}, W {}{}", pull_off, work,
                                         curve.work_by_pull_off && curve.work_of_adhesion ? " from pull-off" : ""),
                       text_or_reason(curve.energy_loss, "J"));
}

std::string answer(const study::ForceMap& map) {
    const auto grid = map.grid ? fmt::format(" on a grid of {} × {}", map.grid->columns, map.grid->rows) : "";
    const auto value = [&](Outcome<Estimate> ForceCurveSummary::*quantity, const char* unit) {
        return text_or_reason(middle_of(map, quantity), unit);
    };
    return fmt::format("{}{}: E* {}, pull-off {}, W {}, loss {}, median ± scatter{}",
                       counted(map.curves.size(), "curve", "curves"), grid,
                       value(&ForceCurveSummary::contact_modulus, "Pa"), value(&ForceCurveSummary::pull_off_force, "N"),
                       value(&ForceCurveSummary::work_of_adhesion, "J/m2"), value(&ForceCurveSummary::energy_loss, "J"),
                       reasons_text(map));
}

}  // namespace setae::output
