// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/budget.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/layout.hpp"
#include "setae/core/units.hpp"
#include "setae/core/words.hpp"
#include "setae/output/study_tables.hpp"
#include "table_support.hpp"

namespace setae::output {
namespace {

/// Noise that no two measured values share, as one row: it is not halved pair by pair.
std::vector<BudgetRow> with_noise_as_one(const TracedValue& value) {
    const auto is_noise = [](const std::string& input) { return input.starts_with(adhesion::own_noise_of); };
    const auto count = std::count_if(value.components.begin(), value.components.end(),
                                     [&](const auto& entry) { return is_noise(entry.first); });
    const auto noise =
        fmt::format("noise of {}", counted(static_cast<std::size_t>(count), "measured value", "measured values"));
    return budget_of(value, [&](const std::string& input) { return is_noise(input) ? noise : input; });
}

std::string place_of(const QuotedBudget& budget) {
    return budget.surface.empty() ? budget.symbol
                                  : fmt::format("{} of {} on {}", budget.symbol, budget.elastomer, budget.surface);
}

}  // namespace

std::vector<QuotedBudget> budgets_of(const study::Conclusions& conclusions) {
    std::vector<QuotedBudget> list;
    const auto add = [&](const char* quantity, const char* symbol, const char* unit, const study::PairResult* pair,
                         const TracedValue& value) {
        auto rows = with_noise_as_one(value);
        if (rows.empty()) return;
        list.push_back({quantity, symbol, pair ? pair->surface : "", pair ? pair->elastomer : "", unit,
                        value.standard_error(), std::move(rows)});
    };
    if (conclusions.work_of_adhesion)
        add("intrinsic_work_of_adhesion", "W_int", "J/m2", nullptr, conclusions.traced_work_of_adhesion);
    for (const auto& pair : conclusions.pairs) {
        if (!pair.modified) continue;
        add("predicted_work_of_adhesion", "W_app (7)", "J/m2", &pair, pair.modified->traced);
        if (pair.predicted_loss) add("predicted_energy_loss", "E_loss (10)", "J", &pair, *pair.predicted_loss);
    }
    return list;
}

std::string budget_sentence(const QuotedBudget& budget) {
    if (budget.rows.empty()) return "";
    const auto& first = budget.rows.front();
    const auto error = [&](double value) { return format_value(value, budget.unit, 2); };
    const bool is_error = first.input.starts_with("scatter of") || first.input.starts_with("noise of");
    const bool described = first.input.find(' ') != std::string::npos;  // else a name, such as "lab.surface_energy"
    return fmt::format(
        "The {}{} contributes {:.0f} % of the variance of {}. Halving {} would reduce the standard error from {} to {}",
        described ? "" : "input ", first.input, 100.0 * first.share, place_of(budget), is_error ? "it" : "its ±",
        error(budget.standard_error), error(first.halved));
}

std::string budget_text(const study::StudyResult& result, std::size_t width) {
    std::string text;
    for (const auto& budget : budgets_of(result)) {
        tables::TidyTable table{
            fmt::format("± of {}: {}", place_of(budget), format_value(budget.standard_error, budget.unit, 2)),
            {"input", "± from it", "share of the variance", "± if it is halved"},
            {}};
        for (const auto& row : budget.rows)
            table.rows.push_back({row.input, format_value(row.standard_error, budget.unit, 2),
                                  fmt::format("{:.1f} %", 100.0 * row.share),
                                  format_value(row.halved, budget.unit, 2)});
        text += tables::as_text_within(table, width) + "\n";
    }
    return text;
}

tables::TidyTable budget_table(const study::StudyResult& result) {
    tables::TidyTable table{
        "",
        {"quantity", "surface", "elastomer", "method", "unit", "standard_error", "input",
         "standard_error of the input alone", "share_of_variance", "standard_error with half of it"},
        {}};
    for (const auto* conclusions : by_method(result))
        for (const auto& budget : budgets_of(*conclusions))
            for (const auto& row : budget.rows)
                table.rows.push_back({budget.quantity, budget.surface, budget.elastomer,
                                      method_name(result, *conclusions), budget.unit, budget.standard_error, row.input,
                                      row.standard_error, row.share, row.halved});
    return table;
}

tables::TidyTable left_out_table(const study::StudyResult& result) {
    tables::TidyTable table{
        "",
        {"left_out", "surface", "elastomer", "method", "W_app measured [J/m2]", "W_app measured standard_error [J/m2]",
         "W_app (7) by the others [J/m2]", "W_app (7) by the others standard_error [J/m2]", "residual [J/m2]",
         "residual standard_error [J/m2]", "within the 95 % interval"},
        {}};
    for (const auto* conclusions : by_method(result))
        for (const auto& p : conclusions->left_out)
            table.rows.push_back({p.surface_left_out ? std::string("surface") : std::string("elastomer"), p.surface,
                                  p.elastomer, method_name(result, *conclusions), p.measured.value,
                                  p.measured.standard_error, p.predicted.value, p.predicted.standard_error, p.residual,
                                  p.standard_error, p.within_interval ? std::string("yes") : std::string("no")});
    return table;
}

tables::TidyTable profile_table(const study::StudyResult& result) {
    tables::TidyTable table{
        "",
        {"input", "method", "shift [standard errors]", "W_int [J/m2]", "W_int standard_error [J/m2]", "log likelihood",
         "input by the pairs [standard errors]", "input by the pairs standard_error"},
        {}};
    for (const auto* conclusions : by_method(result))
        for (const auto& profile : conclusions->profiles)
            for (const auto& point : profile.points)
                table.rows.push_back({profile.input, method_name(result, *conclusions), point.shift,
                                      point.work_of_adhesion.value, point.work_of_adhesion.standard_error,
                                      point.log_likelihood, profile.by_pairs.value, profile.by_pairs.standard_error});
    return table;
}

}  // namespace setae::output
