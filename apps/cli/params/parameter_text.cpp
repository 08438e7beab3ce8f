// SPDX-License-Identifier: GPL-3.0-or-later
#include "params/parameter_text.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/constants.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::cli {
namespace {

using answers::MeasuredTexture;
using texture::Standard;
using texture::TextureParameter;

std::string status(const TextureParameter& row) {
    std::string text = row.ok() ? "ok" : "warn:";
    for (const auto& alert : row.quantity.alerts) text += " " + alert.code;
    return text;
}

std::string value_text(const TextureParameter& row) {
    const auto& quantity = row.quantity;
    return quantity.estimate.uncertain() ? format_uncertain(quantity.estimate, quantity.unit)
                                         : format_value(quantity.estimate.value, quantity.unit, 5);
}

/// The bandwidth as wavelengths.
std::string band_text(const TextureParameter& row) {
    if (!row.quantity.band) return "–";
    return format_value(2.0 * pi / row.quantity.band->upper, "m", 3) + " … " +
           format_value(2.0 * pi / row.quantity.band->lower, "m", 3);
}

std::string title(const MeasuredTexture& measured) {
    return measured.file + (measured.measurement.empty() || measured.measurement == measured.file
                                ? ""
                                : " (" + measured.measurement + ")");
}

std::string points_text(const TextureParameter& row) { return row.quantity.n ? std::to_string(*row.quantity.n) : "–"; }

constexpr std::array columns{"symbol", "quantity", "value", "wavelengths", "filter", "points", "status"};

std::vector<std::string> cells(const TextureParameter& row) {
    return {row.quantity.symbol, row.quantity.quantity, value_text(row), band_text(row),
            row.filter,          points_text(row),      status(row)};
}

std::string as_markdown(const MeasuredTexture& measured) {
    std::string text = "### " + title(measured) + "\n\n|", rule = "|";
    for (const auto* column : columns) {
        text += fmt::format(" {} |", column);
        rule += "---|";
    }
    text += "\n" + rule + "\n";
    for (const auto& row : measured.parameters) {
        text += "|";
        for (const auto& cell : cells(row)) text += " " + cell + " |";
        text += "\n";
    }
    return text + "\n";
}

/// Text with the special characters of TeX escaped.
std::string tex(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '_' || c == '%' || c == '&' || c == '#' || c == '$') result += '\\';
        result += c;
    }
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"±", "$\\pm$"},
                                   {"µ", "$\\mu$"},
                                   {"…", "\\dots{}"},
                                   {"–", "--"},
                                   {"²", "$^2$"}})
        for (auto at = result.find(from); at != std::string::npos; at = result.find(from, at + to.size()))
            result.replace(at, from.size(), to);
    return result;
}

std::string as_latex(const MeasuredTexture& measured) {
    std::string text = "% " + title(measured) + "\n\\begin{tabular}{lllllrl}\n";
    std::string head;
    for (const auto* column : columns) head += (head.empty() ? "" : " & ") + std::string(column);
    text += head + " \\\\\n\\hline\n";
    for (const auto& row : measured.parameters) {
        std::string line;
        for (const auto& cell : cells(row)) line += (line.empty() ? "" : " & ") + tex(cell);
        text += line + " \\\\\n";
    }
    return text + "\\end{tabular}\n";
}

std::string number(double value) { return std::isnan(value) ? std::string() : fmt::format("{}", value); }

std::string as_tsv(const std::vector<MeasuredTexture>& list) {
    constexpr std::array names{"file",   "measurement",    "quantity",        "symbol", "value",  "stderr", "unit",
                               "filter", "band_low [1/m]", "band_high [1/m]", "n",      "status", "alert",  "source"};
    std::string text = fmt::format("{}\n", fmt::join(names, "\t"));
    for (const auto& measured : list)
        for (const auto& row : measured.parameters) {
            const auto& q = row.quantity;
            std::string codes;
            for (const auto& alert : q.alerts) codes += (codes.empty() ? "" : " ") + alert.code;
            text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", measured.file,
                                measured.measurement, q.quantity, q.symbol, number(q.estimate.value),
                                number(q.estimate.standard_error), q.unit, row.filter,
                                q.band ? number(q.band->lower) : "", q.band ? number(q.band->upper) : "",
                                q.n ? std::to_string(*q.n) : "", row.ok() ? "ok" : "warn", codes, q.source);
        }
    return text;
}

std::string as_text(const MeasuredTexture& measured, std::size_t width) {
    tables::TidyTable table{title(measured), {columns.begin(), columns.end()}, {}};
    for (const auto& row : measured.parameters) {
        const auto texts = cells(row);
        table.rows.emplace_back(texts.begin(), texts.end());
    }
    return tables::as_text_within(tables::constants_in_title(table), width) + "\n";
}

constexpr std::string_view marker =
    "<!-- the tables above are made by `setae params --documentation docs/reference/parameters.md` -->\n";

std::string rows_of(Standard standard) {
    std::string text = "| symbol | name | formula | unit | clause | validated against |\n|---|---|---|---|---|---|\n";
    for (const auto& row : texture::parameters()) {
        if (row.standard != standard) continue;
        std::string formula(row.formula);
        for (auto at = formula.find('|'); at != std::string::npos; at = formula.find('|', at + 2))
            formula.insert(at, "\\");
        text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", row.symbol, row.name, formula, row.unit, row.clause,
                            row.validated);
    }
    return text + "\n";
}

}  // namespace

std::string parameter_text(const std::vector<MeasuredTexture>& list, const std::string& format, std::size_t width) {
    if (format == "tsv") return as_tsv(list);
    std::string text;
    for (const auto& measured : list)
        text += format == "md"      ? as_markdown(measured)
                : format == "latex" ? as_latex(measured)
                                    : as_text(measured, width);
    return text;
}

std::string parameter_page() {
    return "# Parameters of surface texture\n\n"
           "*Reference · [all documents](../README.md)*\n\n"
           "`setae params FILE --standard iso25178` prints the first table for a map. `--standard iso21920` prints the second table for a line (for a map:\n"
           "mean over the scan lines). Every row has filter, bandwidth, number of points and warnings. `--format md|tsv|latex|json` chooses another format.\n"
           "`--only \"Sq, Sdr\"` computes only these parameters.\n\n"
           "z is the height over the mean (the mean line), and <…> is the average over the area or the evaluation length. P(h) is the share at or above\n"
           "h, and H(p) is the inverse of P. Both are exact on two triangles per pixel (lines: segments), or on points with `--between nothing`. c is\n"
           "--material-height and p is --material-ratio. With `--profile primary|waviness|roughness` the first letter of a symbol is P, W or R. Volumes are\n"
           "per area. Ratios are 0 … 1, not per cent.\n\n"
           "## Areal, ISO 25178-2:2021\n\n" +
           rows_of(Standard::iso25178) + "## Profile, ISO 21920-2:2021\n\n" + rows_of(Standard::iso21920) +
           std::string(marker);
}

std::string parameter_page(const std::string& existing) {
    const auto at = existing.find(marker);
    return parameter_page() + (at == std::string::npos ? std::string() : existing.substr(at + marker.size()));
}

}  // namespace setae::cli
