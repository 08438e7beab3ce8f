// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/prediction_test.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "pair_least_squares.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::adhesion {
namespace {

double chi_squared_of(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& covariance,
                      const std::optional<Array1D>& slopes) {
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    if (factor.info() != Eigen::Success)
        throw UndefinedDataError(
            "the covariance of measured minus predicted is not positive definite; a test needs errors above "
            "0");
    const Eigen::VectorXd weighted = factor.solve(residuals);
    const double all = residuals.dot(weighted);
    if (!slopes) return all;
    const Eigen::VectorXd s = slopes->matrix();
    const double information = s.dot(factor.solve(s));
    return information > 0.0 ? std::max(0.0, all - std::pow(s.dot(weighted), 2) / information) : all;
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
            fmt::format("{} residuals leave no degree of freedom; a test needs at least {}", n, slopes ? 2 : 1));
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

PredictionTest test_predictions(const std::vector<PairPoint>& pairs, const TracedValue& work, bool work_fitted) {
    const auto n = static_cast<Index>(pairs.size());
    const Index least = work_fitted ? 2 : 1;
    if (n < least)
        throw UndefinedDataError(fmt::format(
            "{} pairs have a prediction and a measured value with its error; a test needs at least {}", n, least));
    Array1D slopes(n);
    std::vector<Components> inputs;
    std::vector<PredictionResidual> residuals;
    for (Index i = 0; i < n; ++i) {
        const auto& pair = pairs[static_cast<std::size_t>(i)];
        const double share = share_through_floor(pair, work.value);
        slopes[i] = pair.raw_prediction(work.value) > 0.0 ? pair.slope : 0.0;
        const Components none, &of_work = work_fitted ? none : work.components;
        const auto predicted = combined({{share, pair.prediction_inputs(work.value)}, {share * pair.slope, of_work}});
        inputs.push_back(combined({{1.0, residual_inputs(pair, work.value)}, {-share * pair.slope, of_work}}));
        residuals.push_back({pair.surface,
                             pair.elastomer,
                             pair.measured,
                             {.value = pair.prediction(work.value),
                              .standard_error = std::sqrt(covariance(predicted, predicted)),
                              .method = "delta"}});
    }
    return prediction_test(std::move(residuals), residual_covariance(pairs, inputs).array(),
                           work_fitted ? std::optional(slopes) : std::nullopt);
}

}  // namespace setae::adhesion
