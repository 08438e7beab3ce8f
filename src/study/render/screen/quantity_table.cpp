// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/quantity_table.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {
namespace {

constexpr int digits_without_error = 5;

std::string value_of(const Quantity& q) {
    if (q.estimate.uncertain() || q.estimate.interval) return format_full(q.estimate, q.unit);
    return format_value(q.estimate.value, q.unit, digits_without_error);
}

/// "298.8 µm … 390.6 pm": the wavelengths of a band, the longest first.
std::string waves_of(const Quantity& q) {
    if (!q.band) return "";
    return format_value(2.0 * pi / q.band->lower, "m", 4) + " … " + format_value(2.0 * pi / q.band->upper, "m", 4);
}

std::string count_of(const Quantity& q) { return q.n ? fmt::format("{}", *q.n) : ""; }

/// "jackknife t on ln, delta": where intervals come from, each once.
std::string methods_of(const std::vector<Quantity>& list) {
    std::vector<std::string> methods;
    for (const auto& q : list)
        if (interval_of(q.estimate) && std::find(methods.begin(), methods.end(), q.estimate.method) == methods.end())
            methods.push_back(q.estimate.method);
    return fmt::format("{}", fmt::join(methods, ", "));
}

/// Common value of a property of all quantities that have it; empty where they differ.
template <class Property>
std::optional<std::string> shared(const std::vector<Quantity>& list, Property property) {
    std::string common;
    for (const auto& q : list) {
        const auto text = property(q);
        if (!text.empty() && !common.empty() && text != common) return std::nullopt;
        if (!text.empty()) common = text;
    }
    return common;
}

struct Column {
    const char* head;    ///< heading of the column
    const char* before;  ///< the text that all rows share
    std::string (*property)(const Quantity&);
};

constexpr Column properties[]{{"wavelengths", "waves ", waves_of}, {"n", "n = ", count_of}};

}  // namespace

std::string quantity_table(const std::string& title, const std::vector<Quantity>& list, std::size_t width) {
    tables::TidyTable table{"", {"quantity", "symbol", "value ± [95 %]"}, {}};
    std::vector<std::string> said;
    std::vector<const Column*> differing;
    for (const auto& column : properties) {
        const auto common = shared(list, column.property);
        if (!common) differing.push_back(&column);
        else if (!common->empty()) said.push_back(column.before + *common);
    }
    if (const auto methods = methods_of(list); !methods.empty()) said.push_back("95 % by " + methods);
    for (const auto* column : differing) table.columns.emplace_back(column->head);
    for (const auto& q : list) {
        std::vector<tables::TidyTable::Cell> row{q.quantity, q.symbol, value_of(q)};
        std::transform(differing.begin(), differing.end(), std::back_inserter(row),
                       [&q](const Column* column) { return column->property(q); });
        table.rows.push_back(std::move(row));
    }
    table.title = wrapped(
        fmt::format("{}{}{}", title, title.empty() || said.empty() ? "" : ": ", fmt::join(said, "; ")), width, 2);
    return tables::as_text_within(table, width);
}

}  // namespace setae::output
