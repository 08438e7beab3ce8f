// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/traced_value.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae {

TracedValue::TracedValue(const Estimate& input, const std::string& name) : value(input.value) {
    if (!input.uncertain()) return;
    components[name] = {Array1D::Constant(1, input.standard_error),
                        input.degrees_of_freedom.value_or(std::numeric_limits<double>::infinity()),
                        input.method == "rectangular"};
}

double TracedValue::variance() const { return covariance(components, components); }

double TracedValue::standard_error() const { return std::sqrt(variance()); }

Estimate TracedValue::estimate(std::string method) const {
    Estimate result{.value = value, .method = std::move(method)};
    if (components.empty()) return result;
    std::vector<VarianceTerm> terms;
    for (const auto& [input, component] : components)
        terms.push_back({component.variance(), component.degrees_of_freedom});
    result.standard_error = standard_error();
    const double freedom = satterthwaite_degrees_of_freedom(terms);
    if (std::isfinite(freedom)) result.degrees_of_freedom = freedom;
    return result;
}

double covariance(const Components& a, const Components& b) {
    double sum = 0.0;
    for (const auto& [input, component] : a)
        if (const auto other = b.find(input); other != b.end()) {
            if (other->second.directions.size() != component.directions.size())
                throw InvalidArgument(
                    fmt::format("input '{}' has {} directions in one value and {} in another; expected the same number",
                                input, component.directions.size(), other->second.directions.size()));
            sum += (component.directions * other->second.directions).sum();
        }
    return sum;
}

Components combined(std::span<const Dependence> parts) {
    Components sum;
    for (const auto& part : parts)
        for (const auto& [input, component] : part.on) {
            const auto [at, fresh] = sum.try_emplace(
                input,
                Component{part.derivative * component.directions, component.degrees_of_freedom, component.rectangular});
            if (fresh) continue;
            if (at->second.directions.size() != component.directions.size())
                throw InvalidArgument(
                    fmt::format("input '{}' has {} directions in one value and {} in another; expected the same number",
                                input, at->second.directions.size(), component.directions.size()));
            at->second.directions += part.derivative * component.directions;
        }
    return sum;
}

TracedValue propagated(const std::function<double(const std::vector<double>&)>& function,
                       const std::vector<TracedValue>& inputs) {
    constexpr double min_left = 1e-3;  // of an input that an error would make negative
    std::vector<double> centre;
    for (const auto& input : inputs) centre.push_back(input.value);
    std::vector<Dependence> parts;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double error = inputs[i].standard_error();
        if (!(error > 0.0)) continue;
        auto more = centre, less = centre;
        more[i] += error;
        less[i] = centre[i] > 0.0 ? std::max(centre[i] - error, min_left * centre[i]) : centre[i] - error;
        parts.push_back({(function(more) - function(less)) / (more[i] - less[i]), inputs[i].components});
    }
    return {function(centre), combined(parts)};
}

std::vector<BudgetRow> budget_of(const TracedValue& value,
                                 const std::function<std::string(const std::string&)>& row_of) {
    const double variance = value.variance();
    std::map<std::string, double> own_variances;
    for (const auto& [input, component] : value.components)
        own_variances[row_of ? row_of(input) : input] += component.variance();
    std::vector<BudgetRow> rows;
    for (const auto& [row, own] : own_variances)
        if (own > 0.0)
            rows.push_back({row, std::sqrt(own), own / variance, std::sqrt(std::max(0.0, variance - 0.75 * own))});
    std::stable_sort(rows.begin(), rows.end(),
                     [](const BudgetRow& a, const BudgetRow& b) { return a.standard_error > b.standard_error; });
    return rows;
}

}  // namespace setae
