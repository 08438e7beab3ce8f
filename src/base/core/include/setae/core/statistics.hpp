// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/estimate.hpp"

namespace setae {

/// x with P(X <= x) = probability, X normal with mean 0 and variance 1.
/// @throws InvalidArgument unless 0 < probability < 1.
[[nodiscard]] double normal_quantile(double probability);

/// P(X <= x), X normal with mean 0 and variance 1.
[[nodiscard]] double normal_probability(double x);

/// x with P(T <= x) = probability, T distributed as Student's t; the normal quantile for infinitely many degrees of
/// freedom.
/// @throws InvalidArgument unless 0 < probability < 1 and degrees_of_freedom > 0.
[[nodiscard]] double student_t_quantile(double probability, double degrees_of_freedom);

/// P(T <= t), T distributed as Student's t; the normal probability for infinitely many degrees of freedom.
/// @throws InvalidArgument unless degrees_of_freedom > 0.
[[nodiscard]] double student_t_probability(double t, double degrees_of_freedom);

/// P(X >= x), X distributed as χ² with degrees_of_freedom.
/// @throws InvalidArgument unless x >= 0 and degrees_of_freedom > 0.
[[nodiscard]] double chi_squared_exceedance(double x, double degrees_of_freedom);

/// P(X > ratio), X distributed as Fisher's F: probability that chance gives this ratio of two mean squares or a larger
/// one.
/// @throws InvalidArgument unless ratio >= 0 and both degrees of freedom are > 0.
[[nodiscard]] double f_exceedance(double ratio, double numerator_degrees_of_freedom,
                                  double denominator_degrees_of_freedom);

/// An independent contribution to a variance, with the degrees of freedom of its estimate.
struct VarianceTerm {
    double variance = 0.0;
    double degrees_of_freedom = std::numeric_limits<double>::infinity();
};

/// Degrees of freedom of a sum of variances: ν = (Σ v)²/Σ (v²/ν_i).
/// Source: Satterthwaite, Biometrics Bull. 2 (1946) 110; Welch, Biometrika 34 (1947) 28.
[[nodiscard]] double satterthwaite_degrees_of_freedom(std::span<const VarianceTerm> terms);

/// p-quantile of numbers in increasing order, linear between them: order (n − 1) p (type 7 of Hyndman and Fan 1996).
/// @throws InvalidArgument for an empty list or p outside [0, 1].
[[nodiscard]] double sorted_quantile(std::span<const double> increasing, double probability);

/// Median of n > 0 numbers in any order; the mean of the two middle numbers for even n. Reorders the numbers.
[[nodiscard]] inline double median(std::span<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// The number that exceeds exactly `rank` others.
template <class Value>
[[nodiscard]] Value number_of_rank(std::vector<Value> values, std::size_t rank) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// p-quantile of n > 0 numbers in any order, without interpolation, rounded down: rank ⌊(n − 1) p⌋.
template <class Value>
[[nodiscard]] Value lower_quantile(std::vector<Value> values, double probability) {
    const auto rank = static_cast<std::size_t>(probability * static_cast<double>(values.size() - 1));
    return number_of_rank(std::move(values), rank);
}

/// p-quantile of n > 0 numbers in any order, without interpolation, rounded up: rank ⌊n p⌋; the largest for p = 1.
template <class Value>
[[nodiscard]] Value upper_quantile(std::vector<Value> values, double probability) {
    const auto rank = static_cast<std::size_t>(probability * static_cast<double>(values.size()));
    const auto last = values.size() - 1;
    return number_of_rank(std::move(values), std::min(rank, last));
}

/// The upper of the two middle numbers; 0 for an empty list.
template <class Value>
[[nodiscard]] Value upper_median(std::vector<Value> values) {
    return values.empty() ? Value(0) : upper_quantile(std::move(values), 0.5);
}

/// Value of a function, with linear propagation of the covariance of its inputs.
///
///   Var f = gᵀ Σ g,  g_i = (f(x + s_i e_i) − f(x − s_i e_i))/(2 s_i),  s_i = √Σ_ii
///
/// The central difference over ± one standard error removes the even part of f. Inputs without variance are left out.
/// function: f of the inputs. inputs: x. covariance: Σ, symmetric, of the size of the inputs.
/// @throws InvalidArgument if the sizes differ.
/// Cost: two evaluations per uncertain input.
[[nodiscard]] Estimate propagated(const std::function<double(const Array1D&)>& function, const Array1D& inputs,
                                  const Array2D& covariance);

/// Linear propagation for independent inputs; degrees of freedom by Satterthwaite's formula if an input has them.
[[nodiscard]] Estimate propagated(const std::function<double(const Array1D&)>& function,
                                  std::span<const Estimate> inputs);

}  // namespace setae
