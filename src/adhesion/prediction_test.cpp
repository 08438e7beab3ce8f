// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/prediction_test.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::adhesion {
namespace {

using roughness::SpectralParameters;

double chi_squared_of(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& covariance,
                      const std::optional<Array1D>& slopes) {
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    if (factor.info() != Eigen::Success)
        throw UndefinedDataError(
            "the covariance of measured minus predicted is not positive definite: errors that are 0 test nothing");
    const Eigen::VectorXd weighted = factor.solve(residuals);
    const double all = residuals.dot(weighted);
    if (!slopes) return all;
    const Eigen::VectorXd s = slopes->matrix();
    const double information = s.dot(factor.solve(s));
    return information > 0.0 ? std::max(0.0, all - std::pow(s.dot(weighted), 2) / information) : all;
}

double area_ratio(const MeasuredPair& pair) { return pair.rough.parameters.area_ratio(); }

/// Covariance of two raw predictions, W_int exact.
double shared_variance(const MeasuredPair& a, const MeasuredPair& b, double work) {
    double variance = 0.0;
    if (a.rough.name == b.rough.name) {
        const auto balance = [work](const MeasuredPair& pair) {
            return [gain = work - pair.soft.surface_energy.value,
                    modulus = pair.soft.contact_modulus.value](const SpectralParameters& p) {
                return gain * p.area_ratio() - modulus * p.elastic_energy_per_modulus;
            };
        };
        variance += a.rough.spread.covariance(balance(a), balance(b));
    }
    if (a.soft.name == b.soft.name)
        variance += a.rough.parameters.elastic_energy_per_modulus * b.rough.parameters.elastic_energy_per_modulus *
                        a.soft.contact_modulus.variance() +
                    (area_ratio(a) - 1.0) * (area_ratio(b) - 1.0) * a.soft.surface_energy.variance();
    return variance;
}

/// Share of a raw error that the floor at 0 lets through: 1 above it, 0 a standard error and more below.
double share_through_floor(double raw, double standard_error) {
    if (raw >= 0.0) return 1.0;
    return standard_error > 0.0 ? std::max(0.0, 1.0 + raw / standard_error) : 0.0;
}

}  // namespace

PredictionTest prediction_test(std::vector<PredictionResidual> pairs, const Array2D& covariance,
                               const std::optional<Array1D>& slopes) {
    const auto n = static_cast<Index>(pairs.size());
    if (covariance.rows() != n || covariance.cols() != n || (slopes && slopes->size() != n))
        throw InvalidArgument(
            fmt::format("{} residuals with a covariance of {} x {}; expected as many rows and columns", n,
                        covariance.rows(), covariance.cols()));
    PredictionTest test{.work_fitted = slopes.has_value(), .n = static_cast<int>(n)};
    test.degrees_of_freedom = test.n - (slopes && (*slopes != 0.0).any() ? 1 : 0);
    if (test.degrees_of_freedom < 1)
        throw InvalidArgument(
            fmt::format("{} residuals leave no degree of freedom; a test needs {}", n, slopes ? 2 : 1));
    Eigen::VectorXd residuals(n);
    for (Index i = 0; i < n; ++i) {
        auto& pair = pairs[static_cast<std::size_t>(i)];
        pair.residual = pair.measured.value - pair.predicted.value;
        pair.standard_error = std::sqrt(covariance(i, i));
        residuals[i] = pair.residual;
    }
    const auto with_scatter = [&](double scatter) {
        Eigen::MatrixXd wider = covariance.matrix();
        wider.diagonal().array() += scatter * scatter;
        return chi_squared_of(residuals, wider, slopes);
    };
    const double freedom = test.degrees_of_freedom;
    test.chi_squared = test.chi_squared_with_scatter = with_scatter(0.0);
    if (test.chi_squared > freedom) {
        double low = 0.0, high = residuals.norm();
        while (with_scatter(high) > freedom) high *= 2.0;
        for (int step = 0; step < 100; ++step) {
            const double middle = 0.5 * (low + high);
            (with_scatter(middle) > freedom ? low : high) = middle;
        }
        test.extra_scatter = high;
        test.chi_squared_with_scatter = with_scatter(high);
    }
    test.probability = chi_squared_exceedance(test.chi_squared, freedom);
    test.probability_with_scatter = chi_squared_exceedance(test.chi_squared_with_scatter, freedom);
    test.pairs = std::move(pairs);
    return test;
}

PredictionTest test_predictions(const std::vector<MeasuredPair>& pairs, const Estimate& work, bool work_fitted) {
    const auto n = static_cast<Index>(pairs.size());
    const Index least = work_fitted ? 2 : 1;
    if (n < least)
        throw UndefinedDataError(
            fmt::format("{} pairs with a prediction and a measured value with its error; a test needs {}", n, least));
    Array1D shares(n), slopes(n);
    for (Index i = 0; i < n; ++i) {
        const auto& pair = pairs[static_cast<std::size_t>(i)];
        shares[i] = share_through_floor(pair.predicted.raw, std::sqrt(shared_variance(pair, pair, work.value)));
        slopes[i] = pair.predicted.raw > 0.0 ? area_ratio(pair) : 0.0;
    }
    Array2D covariance(n, n);
    std::vector<PredictionResidual> residuals;
    for (Index i = 0; i < n; ++i) {
        const auto& own = pairs[static_cast<std::size_t>(i)];
        for (Index j = 0; j < n; ++j) {
            const auto& other = pairs[static_cast<std::size_t>(j)];
            covariance(i, j) = shares[i] * shares[j] * shared_variance(own, other, work.value);
            if (!work_fitted)
                covariance(i, j) += shares[i] * shares[j] * area_ratio(own) * area_ratio(other) * work.variance();
        }
        residuals.push_back(
            {own.rough.name,
             own.soft.name,
             own.measured,
             {.value = own.predicted.floored, .standard_error = std::sqrt(covariance(i, i)), .method = "delta"}});
        covariance(i, i) += own.measured.variance();
    }
    return prediction_test(std::move(residuals), covariance, work_fitted ? std::optional(slopes) : std::nullopt);
}

}  // namespace setae::adhesion
