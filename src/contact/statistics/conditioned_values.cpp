// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/statistics/conditioned_values.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::statistics {

ConditionedValues::ConditionedValues(const std::vector<TracedValue>& residuals) {
    Index width = 0;
    for (const auto& residual : residuals)
        for (const auto& [name, component] : residual.components) {
            const auto [place, is_new] = places_.try_emplace(name, width, component.directions.size());
            if (is_new) width += component.directions.size();
            if (component.directions.size() != place->second.second)
                throw InternalError(fmt::format("input '{}' has {} and {} directions; expected the same number", name,
                                                place->second.second, component.directions.size()));
        }
    const auto n = static_cast<Index>(residuals.size());
    Eigen::MatrixXd sensitivities = Eigen::MatrixXd::Zero(n, width);
    Eigen::VectorXd values(n);
    basis_.resize(width, 0);
    for (Index i = 0; i < n; ++i) {
        const auto& residual = residuals[static_cast<std::size_t>(i)];
        sensitivities.row(i) = directions_of(residual).transpose();
        values[i] = residual.value;
    }
    // in units of each residual's own error, so that rounding is independent of units such as J and J/m²
    const Eigen::VectorXd scale = sensitivities.rowwise().norm();
    if (!(scale.minCoeff() > 0.0))
        throw UndefinedDataError("a residual without any standard error fixes its inputs; give the residual an error");
    const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * sensitivities;
    const Eigen::VectorXd scaled_values = values.cwiseQuotient(scale);
    const auto root = numerics::cholesky(numerics::product(scaled, scaled.transpose()));
    if (!root) throw UndefinedDataError("residuals that are linearly dependent cannot be fitted together");
    // Cᵀ = Q R: P = 1 − Q Qᵀ keeps digits that S⁻¹ would lose where an input is known much better afterwards
    basis_ = numerics::orthonormal(scaled.transpose());
    const Eigen::VectorXd along = numerics::solved(numerics::product(scaled, basis_), scaled_values);
    shift_ = -numerics::product(basis_, along);
    chi2_ = along.squaredNorm();
    const double log_determinant = 2.0 * root->diagonal().array().log().sum() + 2.0 * scale.array().log().sum();
    log_likelihood_ = -0.5 * (static_cast<double>(n) * std::log(2.0 * pi) + log_determinant + chi2_);
    for (const auto& [name, place] : places_) moves_[name] = shift_.segment(place.first, place.second).norm();
}

Eigen::VectorXd ConditionedValues::directions_of(const TracedValue& value) const {
    Eigen::VectorXd directions = Eigen::VectorXd::Zero(basis_.rows());
    for (const auto& [name, component] : value.components) {
        const auto place = places_.find(name);
        if (place == places_.end()) continue;
        if (component.directions.size() != place->second.second)
            throw InternalError(fmt::format("input '{}' has {} and {} directions; expected the same number", name,
                                            place->second.second, component.directions.size()));
        directions.segment(place->second.first, place->second.second) = component.directions.matrix();
    }
    return directions;
}

TracedValue ConditionedValues::updated(const TracedValue& value) const {
    const Eigen::VectorXd directions = directions_of(value);
    const Eigen::VectorXd left =
        directions - numerics::product(basis_, numerics::transposed_product(basis_, directions)).col(0);
    TracedValue result(value.value + directions.dot(shift_), value.components);
    for (const auto& [name, place] : places_) {
        auto& component = result.components[name];  // an input of which the value was independent may correlate now
        component.directions = left.segment(place.first, place.second).array();
    }
    return result;
}

}  // namespace setae::statistics
