// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace setae::texture {

bool is_requested(const std::vector<std::string>& only, std::initializer_list<std::string_view> symbols) {
    return only.empty() || std::any_of(symbols.begin(), symbols.end(), [&only](std::string_view symbol) {
               return std::find(only.begin(), only.end(), symbol) != only.end();
           });
}

ParameterRows::ParameterRows(Standard standard, std::string filter, Bandwidth bandwidth, std::vector<Alert> alerts,
                             Index points, std::vector<std::string> only, char letter)
    : standard_(standard),
      filter_(std::move(filter)),
      bandwidth_(std::move(bandwidth)),
      alerts_(std::move(alerts)),
      points_(points),
      only_(std::move(only)),
      letter_(letter) {}

void ParameterRows::add(std::string_view symbol, Estimate estimate, std::vector<Alert> alerts) {
    if (!is_requested(only_, {symbol})) return;
    const auto& definition = parameter(symbol);
    Quantity quantity;
    quantity.quantity = definition.name;
    quantity.symbol = definition.symbol;
    if (letter_ != 0) quantity.symbol[0] = letter_;
    quantity.unit = definition.unit;
    quantity.band = bandwidth_.band;
    quantity.n = static_cast<int>(points_);
    quantity.source =
        fmt::format("{}, {}: {}", standard_ == Standard::iso25178 ? "ISO 25178-2:2021" : "ISO 21920-2:2021",
                    definition.clause, definition.formula);
    if (std::isnan(estimate.value) && alerts.empty())
        alerts.push_back({"UNDEFINED", quantity.symbol, "the parameter has no value for these heights",
                          "read the definition of the parameter; it needs heights that are not all equal"});
    quantity.alerts = std::move(alerts);
    quantity.alerts.insert(quantity.alerts.end(), alerts_.begin(), alerts_.end());
    if (depends_on_short_waves(symbol))
        quantity.alerts.insert(quantity.alerts.end(), bandwidth_.alerts.begin(), bandwidth_.alerts.end());
    quantity.estimate = std::move(estimate);
    rows_.push_back({std::move(quantity), filter_});
}

}  // namespace setae::texture
