// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/prediction_test.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include "balances.hpp"
#include "pairs.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::study {
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

/// What a pair's prediction by (7) depends on.
struct Dependence {
    const PairResult* pair;
    const SurfaceResult* surface;
    const ElastomerResult* elastomer;
    double share = 1.0;  ///< of its raw error that the floor at 0 lets through

    [[nodiscard]] double ratio() const { return pair->area_ratio; }
    [[nodiscard]] double energy() const { return surface->used().parameters.elastic_energy_per_modulus; }
};

/// Covariance of two predictions, W_int exact.
double shared_variance(const Dependence& a, const Dependence& b, double work) {
    double variance = 0.0;
    if (a.surface == b.surface) {
        const auto balance = [work](const Dependence& d) {
            return [gain = work - d.elastomer->input.surface_energy.value,
                    modulus = d.elastomer->contact_modulus.value](const SpectralParameters& p) {
                return gain * roughness::gaussian_area_ratio(p.rms_slope) - modulus * p.elastic_energy_per_modulus;
            };
        };
        variance += a.surface->used().spread.covariance(balance(a), balance(b));
    }
    if (a.elastomer == b.elastomer)
        variance += a.energy() * b.energy() * a.elastomer->contact_modulus.variance() +
                    (a.ratio() - 1.0) * (b.ratio() - 1.0) * a.elastomer->input.surface_energy.variance();
    return a.share * b.share * variance;
}

/// 1 above the floor, 0 a standard error and more below it.
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

PredictionCurve prediction_curve(const SurfaceResult& surface, const Estimate& surface_energy,
                                 const Estimate& work_of_adhesion, const Array1D& contact_moduli) {
    PredictionCurve curve{contact_moduli, Array1D(contact_moduli.size()), Array1D(contact_moduli.size()),
                          Array1D(contact_moduli.size())};
    const double reach = normal_quantile(0.975);
    ElastomerResult elastomer;
    elastomer.input.surface_energy = surface_energy;
    for (Index i = 0; i < contact_moduli.size(); ++i) {
        elastomer.contact_modulus = {.value = contact_moduli[i]};
        const auto point = Balances(surface, elastomer, surface.used().parameters).modified();
        const double raw = point.slope * work_of_adhesion.value - point.offset;
        const double error = std::sqrt(point.prediction_variance(work_of_adhesion.value) +
                                       point.slope * point.slope * work_of_adhesion.variance());
        curve.work_of_adhesion[i] = std::max(0.0, raw);
        curve.lower[i] = std::max(0.0, raw - reach * error);
        curve.upper[i] = std::max(0.0, raw + reach * error);
    }
    return curve;
}

void test_predictions(StudyResult& result) {
    using Missing = Outcome<PredictionTest>;
    if (!result.work_of_adhesion) {
        result.prediction_test = Missing::missing(result.work_of_adhesion.reason);
        return;
    }
    const double work = result.work_of_adhesion->value;
    const bool fitted = !result.study.work_of_adhesion;
    std::vector<Dependence> list;
    std::vector<std::string> left_out;
    for (const auto& pair : result.pairs) {
        if (!pair.modified || !pair.approach) continue;
        if (!pair.approach->uncertain()) {
            left_out.push_back(
                fmt::format("{} × {}: no standard error of the measured value", pair.surface, pair.elastomer));
            continue;
        }
        Dependence dependence{&pair, &result.surface(pair.surface), &result.elastomer(pair.elastomer)};
        dependence.share =
            share_through_floor(pair.modified->work.raw, std::sqrt(shared_variance(dependence, dependence, work)));
        list.push_back(dependence);
    }
    const auto n = static_cast<Index>(list.size());
    if (n < (fitted ? 2 : 1)) {
        result.prediction_test = Missing::missing(fmt::format(
            "{} pairs with a prediction and a measured value with its error; a test needs {}", n, fitted ? 2 : 1));
        return;
    }
    Array2D covariance(n, n);
    Array1D slopes(n);
    std::vector<PredictionResidual> pairs;
    for (Index i = 0; i < n; ++i) {
        const auto& own = list[static_cast<std::size_t>(i)];
        slopes[i] = own.pair->modified->work.raw > 0.0 ? own.ratio() : 0.0;
        for (Index j = 0; j < n; ++j) {
            const auto& other = list[static_cast<std::size_t>(j)];
            covariance(i, j) = shared_variance(own, other, work);
            if (!fitted)
                covariance(i, j) +=
                    own.share * other.share * own.ratio() * other.ratio() * result.work_of_adhesion->variance();
        }
        pairs.push_back({own.pair->surface,
                         own.pair->elastomer,
                         *own.pair->approach,
                         {.value = own.pair->modified->work.floored,
                          .standard_error = std::sqrt(covariance(i, i)),
                          .method = "delta"}});
        covariance(i, i) += own.pair->approach->variance();
    }
    try {
        auto test = prediction_test(std::move(pairs), covariance, fitted ? std::optional(slopes) : std::nullopt);
        test.left_out = std::move(left_out);
        result.prediction_test = std::move(test);
    } catch (const Error& error) {
        result.prediction_test = Missing::missing(error.what());
    }
}

}  // namespace setae::study
