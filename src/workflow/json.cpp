// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/workflow/json.hpp"

#include <cmath>

namespace setae::workflow {

Json number(double value) {
    if (std::isnan(value)) return nullptr;
    if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
    return value;
}

Json numbers(const ArrayView1D& values) {
    Json list = Json::array();
    for (Index i = 0; i < values.size(); ++i) list.push_back(number(values[i]));
    return list;
}

Json to_json(const std::vector<Alert>& alerts) {
    Json list = Json::array();
    for (const auto& alert : alerts)
        list.push_back({{"code", alert.code}, {"subject", alert.subject}, {"message", alert.message}, {"action", alert.action}});
    return list;
}

Json to_json(const Quantity& q) {
    Json json{{"quantity", q.quantity}, {"symbol", q.symbol}, {"value", number(q.value)}, {"unit", q.unit}};
    if (q.standard_error) json["standard_error"] = number(*q.standard_error);
    if (q.interval) json["interval"] = {{"lower", number(q.interval->lower)}, {"upper", number(q.interval->upper)}, {"level", q.interval->level}};
    if (q.band) json["band"] = {{"lower", number(q.band->lower)}, {"upper", number(q.band->upper)}, {"unit", "1/m"}};
    if (q.n) json["n"] = *q.n;
    if (!q.source.empty()) json["source"] = q.source;
    if (!q.alerts.empty()) json["alerts"] = to_json(q.alerts);
    return json;
}

Quantity quantity(std::string name, std::string symbol, double value, std::string unit) {
    Quantity q;
    q.quantity = std::move(name);
    q.symbol = std::move(symbol);
    q.value = value;
    q.unit = std::move(unit);
    return q;
}

Quantity quantity(std::string name, std::string symbol, const UncertainValue& value, std::string unit) {
    auto q = quantity(std::move(name), std::move(symbol), value.value, std::move(unit));
    if (value.standard_error > 0.0) q.standard_error = value.standard_error;
    return q;
}

}  // namespace setae::workflow
