// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/estimate.hpp"

namespace setae {

/// Contribution of one input to the error of a value.
///
///   u_d = ∂f/∂x_d · u(x_d)
///
/// One number per independent direction of the error of the input: one for a radius, many for a spectrum. Directions
/// have variance 1 and are independent of each other and of the directions of all other inputs.
struct Component {
    Array1D directions;
    double degrees_of_freedom = std::numeric_limits<double>::infinity();  ///< of the input's standard error
    bool rectangular = false;  ///< the one direction has a uniform distribution within ±√3; otherwise normal

    [[nodiscard]] double variance() const { return directions.square().sum(); }
};

/// Components by the name of the input: two values that depend on one input use the same name.
using Components = std::map<std::string, Component>;

/// A value and its dependence on inputs: value and sparse Jacobian, every derivative times the standard error of its
/// input.
///
/// Source: JCGM 100:2008, 5.1.3, 5.2.2; Hall, Metrologia 43 (2006) L56 (uncertain numbers).
struct TracedValue {
    double value = 0.0;
    Components components;

    TracedValue() = default;
    /// A value without error.
    TracedValue(double exact) : value(exact) {}
    TracedValue(double of, Components from) : value(of), components(std::move(from)) {}
    /// An input. Without a standard error > 0 it has no component.
    TracedValue(const Estimate& input, const std::string& name);

    [[nodiscard]] double variance() const;
    [[nodiscard]] double standard_error() const;
    /// Value, standard error, and degrees of freedom by the Welch–Satterthwaite formula over inputs; standard error NaN
    /// if no component is known.
    [[nodiscard]] Estimate estimate(std::string method = "delta") const;
};

/// Σ over common inputs and their directions of the products of components.
[[nodiscard]] double covariance(const Components& a, const Components& b);
[[nodiscard]] inline double covariance(const TracedValue& a, const TracedValue& b) {
    return covariance(a.components, b.components);
}

/// A value and the derivative of another value with respect to it.
struct Dependence {
    double derivative = 0.0;
    const Components& on;
};

/// Components of a function of values: Σ derivative × component, input by input.
/// @throws InvalidArgument if two values have one input with different numbers of directions.
[[nodiscard]] Components combined(std::span<const Dependence> parts);
[[nodiscard]] inline Components combined(std::initializer_list<Dependence> parts) {
    return combined(std::span(parts.begin(), parts.size()));
}

/// A function of inputs, with its dependence on them. Derivatives are central differences over the standard errors of
/// the inputs; a positive input stays positive.
[[nodiscard]] TracedValue propagated(const std::function<double(const std::vector<double>&)>& function,
                                     const std::vector<TracedValue>& inputs);

/// One row of an uncertainty budget: the contribution of one input to the variance of a value, and the standard error
/// of the value if that of the input is halved.
struct BudgetRow {
    std::string input;
    double standard_error = 0.0;  ///< from this input only
    double share = 0.0;           ///< of the variance
    double halved = 0.0;          ///< standard error of the value with half the standard error of the input
};

/// Rows of a value, the largest first. row_of: the row of an input, if several inputs share a row; without row_of each
/// input has its own row.
[[nodiscard]] std::vector<BudgetRow> budget_of(const TracedValue& value,
                                               const std::function<std::string(const std::string&)>& row_of = {});

}  // namespace setae
