// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_rows.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace setae::texture {

ParameterRows::ParameterRows(Standard standard, std::string filter, Bandwidth bandwidth, std::vector<Alert> alerts,
                             Index points, char letter)
    : standard_(standard),
      filter_(std::move(filter)),
      bandwidth_(std::move(bandwidth)),
      alerts_(std::move(alerts)),
      points_(points),
      letter_(letter) {}

void ParameterRows::add(std::string_view symbol, Estimate estimate, std::vector<Alert> alerts) {
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
        alerts.push_back(
            {"UNDEFINED", quantity.symbol, "has no value for these heights", "see the parameter's definition"});
    quantity.alerts = std::move(alerts);
    quantity.alerts.insert(quantity.alerts.end(), alerts_.begin(), alerts_.end());
    if (rests_on_short_waves(symbol))
        quantity.alerts.insert(quantity.alerts.end(), bandwidth_.alerts.begin(), bandwidth_.alerts.end());
    quantity.estimate = std::move(estimate);
    rows_.push_back({std::move(quantity), filter_});
}

}  // namespace setae::texture
