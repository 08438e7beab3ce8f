// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/report.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "setae/core/constants.hpp"

namespace setae::validation {
namespace {

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }

/// Rows by method, and the place of each quantity on the axis of names: the first one on top.
struct Chart {
    std::vector<std::string> quantities;
    std::map<std::string, std::vector<const SummaryRow*>> methods;

    explicit Chart(const std::vector<SummaryRow>& rows) {
        for (const auto& row : rows) {
            if (std::find(quantities.begin(), quantities.end(), row.quantity) == quantities.end())
                quantities.push_back(row.quantity);
            methods[row.method].push_back(&row);
        }
        std::reverse(quantities.begin(), quantities.end());
    }
    /// Methods are next to each other, not on top of each other.
    [[nodiscard]] double place(const SummaryRow& row) const {
        constexpr double share_of_a_place = 0.6;
        const auto at = std::find(quantities.begin(), quantities.end(), row.quantity) - quantities.begin();
        const auto method = std::distance(methods.begin(), methods.find(row.method));
        const auto count = static_cast<double>(methods.size());
        return static_cast<double>(at) - share_of_a_place * (static_cast<double>(method) - 0.5 * (count - 1.0)) / count;
    }
    [[nodiscard]] std::vector<std::string> names() const {
        auto names = quantities;
        for (auto& name : names) std::replace(name.begin(), name.end(), '_', ' ');
        return names;
    }
};

using Value = double (*)(const SummaryRow&);

figures::Panel panel(const Chart& chart, const std::string& title, const std::string& quantity, const std::string& unit,
                     Value centre, Value lower, Value upper) {
    figures::Panel panel{
        .title = title, .x = {.quantity = quantity, .unit = unit}, .y = {.tick_labels = chart.names()}};
    for (const auto& [method, rows] : chart.methods) {
        const auto n = static_cast<Index>(rows.size());
        figures::Series series{.label = method,
                               .x = Array1D(n),
                               .y = Array1D(n),
                               .mark = figures::Mark::points,
                               .left = Array1D(n),
                               .right = Array1D(n)};
        for (Index i = 0; i < n; ++i) {
            const auto& row = *rows[static_cast<std::size_t>(i)];
            series.x[i] = centre(row);
            series.y[i] = chart.place(row);
            series.left[i] = lower(row);
            series.right[i] = upper(row);
        }
        panel.series.push_back(std::move(series));
    }
    return panel;
}

/// Factor and name of the unit deviations are printed in.
std::pair<double, std::string> printed_unit(const SummaryRow& row) {
    if (row.measure == Deviation::relative) return {100.0, "%"};
    if (row.unit == "J/m2") return {1e3, "mJ/m2"};
    return {1.0, row.unit};
}

constexpr double two_sided = 1.96;

}  // namespace

std::string summary_table(const std::vector<SummaryRow>& rows) {
    std::string text =
        fmt::format("{:<28} {:<10} {:>5} {:>6} {:>9} {:>8} {:>9} {:>9} {:>8}  {}\n", "quantity", "method", "n", "in",
                    "bias", "±", "scatter", "stated", "worst", "95 % interval covers the true value in");
    for (const auto& row : rows) {
        const auto [factor, unit] = printed_unit(row);
        text += fmt::format(
            "{:<28} {:<10} {:>5} {:>6} {:>+9.3f} {:>8.3f} {:>9.3f} {:>9.3f} {:>+8.2f}  {:5.1f} % ({:.0f} to {:.0f})\n",
            row.quantity, row.method, row.count, unit, factor * row.bias, factor * row.bias_error, factor * row.scatter,
            factor * row.stated, factor * row.worst, 100.0 * row.coverage, 100.0 * row.coverage_interval.lower,
            100.0 * row.coverage_interval.upper);
    }
    return text;
}

std::string bias_table(const std::vector<SummaryRow>& rows) {
    std::vector<std::string> quantities, methods;
    const auto add = [](std::vector<std::string>& names, const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    for (const auto& row : rows) {
        add(quantities, row.quantity);
        add(methods, row.method);
    }
    std::string text = fmt::format("{:<28} {:>6}", "bias", "in");
    for (const auto& method : methods) text += fmt::format(" {:>16}", method);
    for (const auto& quantity : quantities) {
        std::string line;
        for (const auto& method : methods) {
            const auto row = std::find_if(rows.begin(), rows.end(), [&](const SummaryRow& r) {
                return r.quantity == quantity && r.method == method;
            });
            if (row == rows.end()) {
                line += fmt::format(" {:>16}", "");
                continue;
            }
            const auto [factor, unit] = printed_unit(*row);
            if (line.empty()) line = fmt::format("\n{:<28} {:>6}", quantity, unit);
            line += fmt::format(" {:>+16.2f}", factor * row->bias);
        }
        text += line;
    }
    return text + "\n";
}

std::string comparisons_csv(const std::vector<Comparison>& comparisons) {
    std::string text =
        "run,item,quantity,unit,method,planted,found,standard_error,interval_lower,interval_upper,covered\n";
    for (const auto& c : comparisons) {
        const auto interval = interval_of(c.found);
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", c.run, c.item, c.quantity, c.unit, c.method,
                            cell(c.true_value), cell(c.found.value), cell(c.found.standard_error),
                            cell(interval ? interval->lower : undefined), cell(interval ? interval->upper : undefined),
                            c.covered() ? 1 : 0);
    }
    return text;
}

figures::Figure validation_figure(const std::vector<SummaryRow>& rows) {
    std::vector<SummaryRow> relative;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(relative),
                 [](const SummaryRow& row) { return row.measure == Deviation::relative; });
    const auto bias = panel(
        Chart(relative), "A", "bias", "%", [](const SummaryRow& r) { return 100.0 * r.bias; },
        [](const SummaryRow& r) { return 100.0 * (r.bias - two_sided * r.bias_error); },
        [](const SummaryRow& r) { return 100.0 * (r.bias + two_sided * r.bias_error); });
    auto coverage = panel(
        Chart(rows), "B", "coverage of 95 % intervals", "%", [](const SummaryRow& r) { return 100.0 * r.coverage; },
        [](const SummaryRow& r) { return 100.0 * r.coverage_interval.lower; },
        [](const SummaryRow& r) { return 100.0 * r.coverage_interval.upper; });
    coverage.legend = false;
    return {.panels = {bias, coverage}, .columns = 2, .width_mm = 178.0, .height_mm = 140.0};
}

}  // namespace setae::validation
