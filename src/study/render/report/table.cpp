// SPDX-License-Identifier: GPL-3.0-or-later
#include "table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "fold.hpp"
#include "markup.hpp"
#include "setae/core/words.hpp"

namespace setae::report {
namespace {

using output::Json;

std::string with_minus(std::string text) { return text.starts_with('-') ? "−" + text.substr(1) : text; }

/// The number of a JSON entry; empty for null and text such as "infinity".
std::optional<double> number_of(const Json& json) {
    return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

double value_or_zero(const Json& json) { return number_of(json).value_or(0.0); }

/// JSON pointers of the numbers in a cell, each with its label.
struct Part {
    std::string name, pointer;
};

std::vector<Part> parts_of(const Cell& cell, const Json& study) {
    if (const auto* number = std::get_if<NumberCell>(&cell)) return {{"value", number->pointer}};
    if (const auto* band = std::get_if<BandCell>(&cell)) {
        if (!entry(study, band->pointer).is_object()) return {};
        return {{"lower", joined(band->pointer, "lower")}, {"upper", joined(band->pointer, "upper")}};
    }
    const auto* quantity = std::get_if<QuantityCell>(&cell);
    if (!quantity) return {};
    const auto& json = entry(study, quantity->pointer);
    if (!json.is_object()) return {};
    std::vector<Part> parts{{"value", joined(quantity->pointer, "value")}};
    if (json.contains("standard_error"))
        parts.push_back({"standard_error", joined(quantity->pointer, "standard_error")});
    if (json.contains("interval")) {
        parts.push_back({"interval_low", joined(quantity->pointer, "interval/lower")});
        parts.push_back({"interval_high", joined(quantity->pointer, "interval/upper")});
    }
    return parts;
}

/// An end of a band of wavevectors, which span many decades: "10⁵", "1.257×10⁴".
std::string as_power(double value) {
    auto text = fmt::format("{:.3e}", value);
    const auto split = text.find('e');
    auto digits = text.substr(0, split);
    digits.erase(digits.find_last_not_of("0.") + 1);
    return (digits == "1" ? "" : digits + "×") + "10" + raised(std::to_string(std::stoi(text.substr(split + 1))));
}

std::string span(const Json& study, const std::string& pointer, const std::string& part, const std::string& text) {
    const auto& json = entry(study, pointer);
    const std::string full = json.is_string() ? json.get<std::string>()
                             : json.is_null() ? ""
                                              : json.dump(-1, ' ', false, output::Json::error_handler_t::replace);
    return fmt::format("<span data-pointer=\"{}\" data-part=\"{}\" data-value=\"{}\">{}</span>", escaped(pointer), part,
                       escaped(full), text);
}

/// Value, standard error and interval by the names of their parts.
std::string cell_html(const Cell& cell, const Json& study, const DisplayUnit& unit) {
    if (const auto* text = std::get_if<TextCell>(&cell)) return "<td>" + escaped(text->text) + "</td>";
    if (const auto* sentence = std::get_if<ProseCell>(&cell)) return "<td>" + prose(sentence->text) + "</td>";
    const auto parts = parts_of(cell, study);
    if (parts.empty() || entry(study, parts.front().pointer).is_null()) return "<td class=\"number\">–</td>";
    std::map<std::string, std::string> pointers;
    for (const auto& part : parts) pointers[part.name] = part.pointer;
    const auto html = [&](const std::string& part, int decimals) {
        return number_html(study, pointers.at(part), unit, decimals, part);
    };
    std::string inner;
    if (std::holds_alternative<BandCell>(cell)) {
        const auto end = [&](const std::string& part) {
            return span(study, pointers.at(part), part, as_power(value_or_zero(entry(study, pointers.at(part)))));
        };
        inner = end("lower") + " … " + end("upper");
    } else if (std::holds_alternative<NumberCell>(cell)) {
        const auto& json = entry(study, pointers.at("value"));
        inner = html("value", json.is_number_integer() ? 0 : decimals_of(value_or_zero(json) / unit.factor, 0.0));
    } else {
        const double error = pointers.contains("standard_error")
                                 ? value_or_zero(entry(study, pointers.at("standard_error"))) / unit.factor
                                 : 0.0;
        const int decimals = decimals_of(value_or_zero(entry(study, pointers.at("value"))) / unit.factor, error);
        inner = html("value", decimals);
        if (pointers.contains("standard_error")) inner += " ± " + html("standard_error", decimals);
        if (pointers.contains("interval_low"))
            inner += " <span class=\"interval\">[" + html("interval_low", decimals) + ", " +
                     html("interval_high", decimals) + "]</span>";
    }
    return "<td class=\"number\">" + inner + "</td>";
}

std::span<const std::vector<Cell>> shown_rows(const DataTable& table) {
    return std::span(table.rows).first(std::min(table.most, table.rows.size()));
}

DisplayUnit unit_of_column(const DataTable& table, std::size_t column, const Json& study) {
    double largest = 0.0;
    if (!table.rows.empty() && std::holds_alternative<BandCell>(table.rows.front()[column]))
        return {table.columns[column].unit, 1.0};
    for (const auto& row : shown_rows(table))
        for (const auto& part : parts_of(row[column], study))
            if (part.name == "value") largest = std::max(largest, std::abs(value_or_zero(entry(study, part.pointer))));
    return display_unit(table.columns[column].unit, largest);
}

}  // namespace

DisplayUnit display_unit(const std::string& si_unit, double largest) {
    static const std::map<std::string, std::vector<DisplayUnit>> scales{
        {"m", {{"pm", 1e-12}, {"nm", 1e-9}, {"µm", 1e-6}, {"mm", 1e-3}, {"m", 1.0}}},
        {"m2", {{"nm2", 1e-18}, {"µm2", 1e-12}, {"mm2", 1e-6}, {"m2", 1.0}}},
        {"1/m", {{"1/m", 1.0}, {"1/mm", 1e3}, {"1/µm", 1e6}, {"1/nm", 1e9}}},
        {"J/m2", {{"µJ/m2", 1e-6}, {"mJ/m2", 1e-3}, {"J/m2", 1.0}}},
        {"J", {{"fJ", 1e-15}, {"pJ", 1e-12}, {"nJ", 1e-9}, {"µJ", 1e-6}, {"mJ", 1e-3}, {"J", 1.0}}},
        {"N", {{"nN", 1e-9}, {"µN", 1e-6}, {"mN", 1e-3}, {"N", 1.0}}},
        {"Pa", {{"Pa", 1.0}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}}},
    };
    const auto found = scales.find(si_unit);
    if (found == scales.end()) return {si_unit, 1.0};
    auto chosen = found->second.front();
    for (const auto& scale : found->second)
        if (largest >= 0.9999995 * scale.factor) chosen = scale;
    return largest > 0.0 ? chosen : DisplayUnit{si_unit, 1.0};
}

std::string shown(double value, int decimals) {
    const double size = std::abs(value);
    // small numbers in fixed point only where their digits are significant
    if (size < 1e5 && (size >= 1e-3 || decimals <= 6))
        return with_minus(fmt::format("{:.{}f}", value, std::clamp(decimals, 0, 9)));
    if (size == 0.0) return "0";
    auto text = fmt::format("{:.3e}", value);
    const auto split = text.find('e');
    return with_minus(text.substr(0, split)) + "×10" + raised(std::to_string(std::stoi(text.substr(split + 1))));
}

int decimals_of(double value, double standard_error) {
    const double leading = standard_error > 0.0 ? standard_error : std::abs(value);
    if (!(leading > 0.0) || !std::isfinite(leading)) return 1;
    const int digits = standard_error > 0.0 ? 2 : 4;
    return std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(leading))));
}

std::string joined(const std::string& pointer, const std::string& path) { return pointer + "/" + path; }

std::string named(const std::string& pointer, const std::string& key) {
    std::string step;
    for (const char c : key) step += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return pointer + "/" + step;
}

const Json& entry(const Json& study, const std::string& pointer) {
    static const Json none;
    const Json::json_pointer place(pointer);
    return study.contains(place) ? study.at(place) : none;
}

std::string number_html(const Json& study, const std::string& pointer, const DisplayUnit& unit, int decimals,
                        const std::string& part) {
    const auto& json = entry(study, pointer);
    const auto value = number_of(json);
    const std::string text = value              ? shown(*value / unit.factor, decimals)
                             : json.is_string() ? escaped(json.get<std::string>())
                                                : "–";
    return span(study, pointer, part, text);
}

std::string quantity_html(const Json& study, const std::string& pointer, bool with_interval) {
    const auto& json = entry(study, pointer);
    if (!json.is_object()) return "–";
    const auto unit = display_unit(json.at("unit").get<std::string>(), std::abs(value_or_zero(json.at("value"))));
    const auto name = typeset_unit(unit.name);
    const auto suffix = name.empty() ? "" : "\u00A0" + name;
    const double error = json.contains("standard_error") ? value_or_zero(json.at("standard_error")) / unit.factor : 0.0;
    const int decimals = decimals_of(value_or_zero(json.at("value")) / unit.factor, error);
    const auto html = [&](const std::string& key, const std::string& part) {
        return number_html(study, joined(pointer, key), unit, decimals, part);
    };
    std::string text = html("value", "value");
    if (json.contains("standard_error")) text += " ± " + html("standard_error", "standard_error");
    text += suffix;
    if (with_interval && json.contains("interval"))
        text += fmt::format(" ({:g} % interval {} to {}{})", 100.0 * json.at("interval").at("level").get<double>(),
                            html("interval/lower", "interval_low"), html("interval/upper", "interval_high"), suffix);
    return text;
}

std::string as_html(const DataTable& table, const Json& study) {
    if (table.rows.empty()) return "";
    const auto title = escaped(table.title);
    std::string html;
    if (!table.note.empty()) html += "<p class=\"note\">" + table.note + "</p>";
    const auto rows = shown_rows(table);
    if (rows.size() < table.rows.size())
        html +=
            fmt::format("<p class=\"note\">The table shows the first {} of {} rows. The file {} contains all rows.</p>",
                        rows.size(), table.rows.size(), escaped(table.file));
    html += fmt::format(
        "<div class=\"tools\"><button type=\"button\" class=\"copy\" aria-label=\"Copy table: {0}\">Copy</button>"
        "<span class=\"notice\" role=\"status\"></span></div>"
        "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"Table: {0}\"><table><thead><tr>",
        title);
    std::vector<DisplayUnit> units;
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        const auto& [heading, unit] = table.columns[column];
        units.push_back(unit_of_column(table, column, study));
        const auto name = typeset_unit(units.back().name);
        html += fmt::format(
            "<th scope=\"col\" aria-sort=\"none\" data-name=\"{}\" data-unit=\"{}\"{}><button type=\"button\">{}{}</button></th>",
            plain(heading), escaped(unit), unit.empty() ? "" : " class=\"number\"", typeset(heading),
            name.empty() ? "" : " [" + name + "]");
    }
    html += "</tr></thead><tbody>\n";
    for (const auto& row : rows) {
        html += "<tr>";
        for (std::size_t column = 0; column < row.size(); ++column)
            html += cell_html(row[column], study, units[column]);
        html += "</tr>\n";
    }
    html += "</tbody></table></div>";
    return as_html(Fold{.identifier = "table-" + table.identifier,
                        .kind = "table",
                        .title = title,
                        .remark = counted(table.rows.size(), "row", "rows"),
                        .html = html,
                        .open = table.open});
}

}  // namespace setae::report
