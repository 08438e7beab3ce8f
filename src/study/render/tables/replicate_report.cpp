// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/replicate_report.hpp"
#include "setae/core/uncertain_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "setae/core/constants.hpp"
#include "setae/core/units.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/replicate_fields.hpp"
#include "table_support.hpp"

namespace setae::output {
namespace {

using statistics::MixedModel;
using statistics::ReplicateData;

std::string between(const std::optional<Interval>& interval, const std::string& unit) {
    return interval ? format_value(interval->lower, unit) + " … " + format_value(interval->upper, unit) : "–";
}

}  // namespace

Json to_json(const ReplicateData& data, const MixedModel& model) { return described(ReplicateMeans{&data, &model}); }

tables::TidyTable replicate_table(const ReplicateData& data) {
    tables::TidyTable table{"", {"name"}, {}};
    append(table.columns, data.levels);
    append(table.columns, {"quantity", "value", "standard_error", "unit", "excluded"});
    for (std::size_t i = 0; i < data.rows.size(); ++i) {
        const auto& row = data.rows[i];
        Cells cells{row.name};
        for (const auto& group : row.groups) cells.emplace_back(group);
        add_cells(cells, data.quantity, row.value, row.standard_error, data.unit,
                  ReplicateRow{&data, i}.exclusion().value_or(""));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

tables::TidyTable replicate_mean_table(const ReplicateData& data, const MixedModel& model) {
    tables::TidyTable table{"", {"surface", "quantity", "mean"}, {}};
    append(table.columns, uncertainty_columns("", ""));
    append(table.columns, {"degrees_of_freedom", "prediction_low", "prediction_high", "mean_with_excluded", "unit", "n",
                           "excluded", "Q", "Q_probability", "I2", "notes"});
    for (const auto& s : model.surfaces) {
        Cells cells;
        add_cells(cells, s.surface, data.quantity, s.mean.value);
        append(cells, uncertainty_cells(s.mean));
        add_cells(cells, s.mean.degrees_of_freedom.value_or(undefined), s.prediction ? s.prediction->lower : undefined,
                  s.prediction ? s.prediction->upper : undefined, s.with_excluded ? s.with_excluded->value : undefined,
                  data.unit, static_cast<double>(s.n), static_cast<double>(s.excluded),
                  s.heterogeneity ? s.heterogeneity->Q : undefined,
                  s.heterogeneity ? s.heterogeneity->probability : undefined,
                  s.heterogeneity ? s.heterogeneity->I2 : undefined, fmt::format("{}", fmt::join(s.notes, "; ")));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

std::string summary(const ReplicateData& data, const MixedModel& model, std::size_t width) {
    const auto& unit = data.unit;
    const auto percent = [](double level) { return fmt::format("{:.0f} %", 100.0 * level); };
    tables::TidyTable means{
        "",
        {data.levels[0], "n", "excluded", data.quantity, "interval", "another one", "with excluded", "I²", "p of Q"},
        {}};
    for (const auto& s : model.surfaces) {
        if (const auto interval = s.mean.interval) means.columns[4] = percent(interval->level) + " interval";
        means.rows.push_back({s.surface, fmt::format("{}", s.n), fmt::format("{}", s.excluded),
                              format_uncertain(s.mean, unit), between(s.mean.interval, unit),
                              between(s.prediction, unit),
                              s.with_excluded ? format_uncertain(*s.with_excluded, unit) : "–",
                              s.heterogeneity ? percent(s.heterogeneity->I2) : "–",
                              s.heterogeneity ? fmt::format("{:.2g}", s.heterogeneity->probability) : "–"});
    }
    std::string text = tables::as_text_within(means, width);
    tables::TidyTable variances{
        "\nStandard deviations between", {"level", data.quantity, "degrees of freedom", data.levels[0]}, {}};
    std::string remarks;
    for (const auto& fit : model.fits) {
        const auto where = model.fits.size() == 1 ? fmt::format("all, pooled") : fit.surfaces.front();
        for (const auto& c : fit.components)
            variances.rows.push_back({fmt::format("{}", fmt::join(c.includes, " and ")),
                                      c.at_bound ? "0 (at its bound)" : format_value(std::sqrt(c.variance), unit, 3),
                                      fmt::format("{}", c.degrees_of_freedom), where});
        if (!std::isnan(fit.known_variance))
            variances.rows.push_back(
                {"within fits (known)", format_value(std::sqrt(fit.known_variance), unit, 3), "–", where});
        for (const auto& sentence : fit.not_estimable)
            remarks += fmt::format("  {}{}\n", model.fits.size() == 1 ? "" : where + ": ", sentence);
    }
    if (!variances.rows.empty()) text += tables::as_text_within(variances, width);
    if (!model.differences.empty()) {
        tables::TidyTable table{"\nDifferences", {"", data.quantity, "interval", "p"}, {}};
        for (const auto& d : model.differences)
            table.rows.push_back({d.later + " − " + d.earlier, format_uncertain(d.difference, unit),
                                  between(d.difference.interval, unit),
                                  std::isnan(d.probability) ? "–" : fmt::format("{:.2g}", d.probability)});
        text += tables::as_text_within(table, width);
    }
    tables::TidyTable influence{"\nWithout one group", {data.levels[0], "without", data.quantity, "shift"}, {}};
    for (const auto& s : model.surfaces)
        for (const auto& i : s.influence)
            influence.rows.push_back({s.surface, i.level + " " + i.group,
                                      i.mean ? format_uncertain(*i.mean, unit) : "–",
                                      std::isnan(i.shift) ? "–" : format_value(i.shift, unit, 3)});
    if (!influence.rows.empty()) text += tables::as_text_within(influence, width);
    if (!data.exclusions.empty()) {
        tables::TidyTable table{"\nExcluded", {"row", data.levels[0], data.quantity, "reason"}, {}};
        for (const auto& e : data.exclusions)
            table.rows.push_back(
                {data.rows[e.row].name, data.rows[e.row].groups[0],
                 format_uncertain({.value = data.rows[e.row].value, .standard_error = data.rows[e.row].standard_error},
                                  unit),
                 e.reason});
        text += tables::as_text_within(table, width);
    }
    for (const auto& s : model.surfaces)
        for (const auto& note : s.notes) remarks += fmt::format("  {}: {}\n", s.surface, note);
    for (const auto& note : model.notes) remarks += "  " + note + "\n";
    return remarks.empty() ? text : text + "\nRemarks\n" + remarks;
}

}  // namespace setae::output
