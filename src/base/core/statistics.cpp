// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "setae/core/errors.hpp"

namespace setae {
namespace {

void require_probability(double probability) {
    if (!(probability > 0.0 && probability < 1.0))
        throw InvalidArgument(
            fmt::format("probability {} of a quantile; expected a number between 0 and 1", probability));
}

}  // namespace

double normal_quantile(double probability) {
    require_probability(probability);
    return boost::math::quantile(boost::math::normal(), probability);
}

double normal_probability(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

double student_t_quantile(double probability, double degrees_of_freedom) {
    require_probability(probability);
    if (!(degrees_of_freedom > 0.0))
        throw InvalidArgument(fmt::format("{} degrees of freedom; expected more than 0", degrees_of_freedom));
    if (std::isinf(degrees_of_freedom)) return normal_quantile(probability);
    return boost::math::quantile(boost::math::students_t(degrees_of_freedom), probability);
}

double student_t_probability(double t, double degrees_of_freedom) {
    if (!(degrees_of_freedom > 0.0))
        throw InvalidArgument(fmt::format("{} degrees of freedom; expected more than 0", degrees_of_freedom));
    if (std::isinf(degrees_of_freedom)) return normal_probability(t);
    return boost::math::cdf(boost::math::students_t(degrees_of_freedom), t);
}

double chi_squared_exceedance(double x, double degrees_of_freedom) {
    if (!(x >= 0.0 && degrees_of_freedom > 0.0))
        throw InvalidArgument(
            fmt::format("chi-squared of {} at {} degrees of freedom; expected a number >= 0 and more than 0 degrees of "
                        "freedom",
                        x, degrees_of_freedom));
    if (std::isinf(x)) return 0.0;
    return boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees_of_freedom), x));
}

double f_exceedance(double ratio, double numerator_degrees_of_freedom, double denominator_degrees_of_freedom) {
    if (!(ratio >= 0.0 && numerator_degrees_of_freedom > 0.0 && denominator_degrees_of_freedom > 0.0))
        throw InvalidArgument(fmt::format("an F ratio must be >= 0 and its degrees of freedom > 0, got {}, {} and {}",
                                          ratio, numerator_degrees_of_freedom, denominator_degrees_of_freedom));
    const boost::math::fisher_f distribution(numerator_degrees_of_freedom, denominator_degrees_of_freedom);
    return boost::math::cdf(boost::math::complement(distribution, ratio));
}

double satterthwaite_degrees_of_freedom(std::span<const VarianceTerm> terms) {
    double sum = 0.0, squares = 0.0;
    for (const auto& term : terms) {
        sum += term.variance;
        squares += term.variance * term.variance / term.degrees_of_freedom;
    }
    return sum * sum / squares;
}

double sorted_quantile(std::span<const double> increasing, double probability) {
    if (increasing.empty()) throw InvalidArgument("a quantile needs at least one number");
    if (!(probability >= 0.0 && probability <= 1.0))
        throw InvalidArgument(fmt::format("probability {} of a quantile; expected a number from 0 to 1", probability));
    const double order = probability * static_cast<double>(increasing.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(order), increasing.size() - 1);
    const auto above = std::min(below + 1, increasing.size() - 1);
    return increasing[below] + (order - static_cast<double>(below)) * (increasing[above] - increasing[below]);
}

namespace {

/// f(x + s e_i) − f(x − s e_i), halved: change of f for one standard error of the input.
double half_difference(const std::function<double(const Array1D&)>& function, const Array1D& inputs, Index i,
                       double error) {
    Array1D above = inputs, below = inputs;
    above[i] += error;
    below[i] -= error;
    return 0.5 * (function(above) - function(below));
}

}  // namespace

Estimate propagated(const std::function<double(const Array1D&)>& function, const Array1D& inputs,
                    const Array2D& covariance) {
    const Index n = inputs.size();
    if (covariance.rows() != n || covariance.cols() != n)
        throw InvalidArgument(fmt::format("{} inputs with a covariance of {} x {}; expected {} x {}", n,
                                          covariance.rows(), covariance.cols(), n, n));
    Array1D gradient = Array1D::Zero(n);
    for (Index i = 0; i < n; ++i) {
        const double error = std::sqrt(covariance(i, i));
        if (error > 0.0) gradient[i] = half_difference(function, inputs, i, error) / error;
    }
    double variance = 0.0;
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            if (gradient[i] != 0.0 && gradient[j] != 0.0) variance += gradient[i] * covariance(i, j) * gradient[j];
    return {function(inputs), std::sqrt(std::max(0.0, variance)), "delta"};
}

Estimate propagated(const std::function<double(const Array1D&)>& function, std::span<const Estimate> inputs) {
    Array1D values(static_cast<Index>(inputs.size()));
    for (std::size_t i = 0; i < inputs.size(); ++i) values[static_cast<Index>(i)] = inputs[i].value;
    std::vector<VarianceTerm> terms;
    double variance = 0.0;
    bool limited = false;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (!inputs[i].uncertain()) continue;
        const double moved = half_difference(function, values, static_cast<Index>(i), inputs[i].standard_error);
        terms.push_back(
            {moved * moved, inputs[i].degrees_of_freedom.value_or(std::numeric_limits<double>::infinity())});
        variance += moved * moved;
        limited = limited || (inputs[i].degrees_of_freedom && moved != 0.0);
    }
    Estimate result{function(values), std::sqrt(variance), "delta"};
    if (limited) result.degrees_of_freedom = satterthwaite_degrees_of_freedom(terms);
    return result;
}

}  // namespace setae
