// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/replicate_report.hpp"
#include "setae/core/uncertain_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "json/json_support.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/units.hpp"
#include "table_support.hpp"

namespace setae::output {
namespace {

using statistics::MixedModel;
using statistics::ReplicateData;

constexpr const char* source =
    "linear mixed model, restricted likelihood, Satterthwaite's degrees of freedom; docs/guides/replicates.md";

const statistics::Exclusion* exclusion_of(const ReplicateData& data, std::size_t row) {
    const auto found =
        std::find_if(data.exclusions.begin(), data.exclusions.end(), [row](const auto& e) { return e.row == row; });
    return found == data.exclusions.end() ? nullptr : &*found;
}

Json interval_json(const std::optional<Interval>& interval, const std::string& unit) {
    if (!interval) return nullptr;
    return {{"lower", number(interval->lower)},
            {"upper", number(interval->upper)},
            {"level", interval->level},
            {"unit", unit}};
}

Json fit_json(const statistics::VarianceFit& fit, const std::string& unit) {
    Json json{{"surfaces", fit.surfaces},           {"components", Json::array()},
              {"not_estimable", fit.not_estimable}, {"n", fit.n},
              {"converged", fit.converged},         {"log_likelihood", number(fit.log_likelihood)}};
    for (const auto& c : fit.components) {
        // of a root the error is that of the square over twice the root
        const double deviation = std::sqrt(c.variance);
        Json entry{{"level", c.level},
                   {"includes", c.includes},
                   {"degrees_of_freedom", c.degrees_of_freedom},
                   {"at_bound", c.at_bound},
                   {"variance", number(c.variance)},
                   {"variance_standard_error", number(c.standard_error)}};
        add(entry, quantity("standard_deviation", "s",
                            {.value = deviation,
                             .standard_error = deviation > 0.0 ? 0.5 * c.standard_error / deviation : undefined,
                             .method = "delta"},
                            unit));
        json["components"].push_back(std::move(entry));
    }
    json["within_fits"] = to_json(quantity("standard_deviation_within_fits", "s", std::sqrt(fit.known_variance), unit));
    return json;
}

Json surface_json(const ReplicateData& data, const statistics::SurfaceMean& surface) {
    Json json{{"surface", surface.surface}};
    auto mean = quantity("mean", data.quantity, surface.mean, data.unit);
    mean.n = surface.n;
    mean.source = source;
    add(json, mean);
    json["prediction_interval"] = interval_json(surface.prediction, data.unit);
    json["with_excluded"] =
        surface.with_excluded
            ? to_json(quantity("mean_with_excluded", data.quantity, *surface.with_excluded, data.unit))
            : Json(nullptr);
    if (const auto& h = surface.heterogeneity)
        json["heterogeneity"] = {{"Q", number(h->Q)},
                                 {"degrees_of_freedom", h->degrees_of_freedom},
                                 {"probability", number(h->probability)},
                                 {"I2", number(h->I2)}};
    else json["heterogeneity"] = nullptr;
    for (std::size_t k = 1; k < data.levels.size(); ++k) json["groups"][data.levels[k]] = surface.groups[k - 1];
    json["n"] = surface.n;
    json["excluded"] = surface.excluded;
    json["influence"] = Json::array();
    for (const auto& i : surface.influence) {
        Json entry{{"level", i.level}, {"group", i.group}};
        entry["mean"] =
            i.mean ? to_json(quantity("mean_without_it", data.quantity, *i.mean, data.unit)) : Json(nullptr);
        add(entry, quantity("shift", "Δ" + data.quantity, i.shift, data.unit));
        json["influence"].push_back(std::move(entry));
    }
    json["notes"] = surface.notes;
    return json;
}

std::string between(const std::optional<Interval>& interval, const std::string& unit) {
    return interval ? format_value(interval->lower, unit) + " … " + format_value(interval->upper, unit) : "–";
}

}  // namespace

Json rows_json(const ReplicateData& data) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < data.rows.size(); ++i) {
        const auto& row = data.rows[i];
        Json entry{{"name", row.name}};
        for (std::size_t k = 0; k < data.levels.size(); ++k) entry["groups"][data.levels[k]] = row.groups[k];
        add(entry, quantity("value", data.quantity,
                            {.value = row.value, .standard_error = row.standard_error, .method = "fit"}, data.unit));
        const auto* exclusion = exclusion_of(data, i);
        entry["excluded"] = exclusion ? Json(exclusion->reason) : Json(nullptr);
        rows.push_back(std::move(entry));
    }
    return rows;
}

Json to_json(const ReplicateData& data, const MixedModel& model) {
    Json json{{"quantity", data.quantity},
              {"unit", data.unit},
              {"levels", data.levels},
              {"pooling", model.pooling == statistics::Pooling::surfaces ? "surfaces" : "none"},
              {"surfaces", Json::array()},
              {"variances", Json::array()},
              {"differences", Json::array()},
              {"rows", Json::array()},
              {"notes", model.notes}};
    for (const auto& surface : model.surfaces) json["surfaces"].push_back(surface_json(data, surface));
    for (const auto& fit : model.fits) json["variances"].push_back(fit_json(fit, data.unit));
    for (const auto& d : model.differences) {
        Json entry{{"later", d.later}, {"earlier", d.earlier}};
        add(entry, quantity("difference", "Δ" + data.quantity, d.difference, data.unit));
        entry["probability"] = number(d.probability);
        json["differences"].push_back(std::move(entry));
    }
    json["rows"] = rows_json(data);
    return json;
}

tables::TidyTable replicate_table(const ReplicateData& data) {
    tables::TidyTable table{"", {"name"}, {}};
    append(table.columns, data.levels);
    append(table.columns, {"quantity", "value", "standard_error", "unit", "excluded"});
    for (std::size_t i = 0; i < data.rows.size(); ++i) {
        const auto& row = data.rows[i];
        Cells cells{row.name};
        for (const auto& group : row.groups) cells.emplace_back(group);
        const auto* exclusion = exclusion_of(data, i);
        add_cells(cells, data.quantity, row.value, row.standard_error, data.unit,
                  exclusion ? exclusion->reason : std::string());
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
