// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_writer.hpp"
#include "setae/output/field_json.hpp"
#include "surface_fields.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace setae::output {

std::string as_text(const Json& json) {
    std::string text;
    JsonWriter writer([&](std::string_view piece) { text += piece; });
    writer.value(json);
    return text;
}

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
    for (const auto& alert : alerts) list.push_back(described(alert));
    return list;
}

Json to_json(const std::vector<processing::StepRecord>& records) {
    Json list = Json::array();
    for (const auto& record : records) list.push_back(described(record));
    return list;
}

Json to_json(const Quantity& q) {
    const auto& e = q.estimate;
    Json json{{"quantity", q.quantity}, {"symbol", q.symbol}, {"value", number(e.value)}, {"unit", q.unit}};
    if (e.uncertain()) json["standard_error"] = number(e.standard_error);
    if (const auto interval = interval_of(e))
        json["interval"] = {
            {"lower", number(interval->lower)}, {"upper", number(interval->upper)}, {"level", interval->level}};
    if (e.uncertain() || e.interval) {
        if (!e.method.empty()) json["method"] = e.method;
        if (e.degrees_of_freedom) json["degrees_of_freedom"] = number(*e.degrees_of_freedom);
        if (e.seed) json["seed"] = *e.seed;
    }
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
    q.estimate.value = value;
    q.unit = std::move(unit);
    return q;
}

Quantity quantity(std::string name, std::string symbol, const Estimate& estimate, std::string unit) {
    auto q = quantity(std::move(name), std::move(symbol), estimate.value, std::move(unit));
    q.estimate = estimate;
    return q;
}

}  // namespace setae::output
