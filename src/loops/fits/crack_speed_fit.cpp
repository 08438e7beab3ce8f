// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/crack_speed_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Core>
#include <Eigen/LU>

#include "least_squares.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::loops {
namespace {

namespace law = contact::crack_speed;

/// Points that recede, and the least-squares problem in ln G0, ln c and ln n of G = G0 + c (v/v_ref)^n.
struct LawProblem {
    Array1D log_speed;  ///< ln(v/v_ref), v_ref the geometric mean
    Array1D rate;
    Array1D weight;  ///< 1/σ of each rate
    double reference = 0.0;
    bool exponent_free = true;

    [[nodiscard]] Index unknowns() const { return exponent_free ? 3 : 2; }

    /// The best of many exponents, G0 and c by linear regression. @throws UndefinedDataError where G does not rise.
    [[nodiscard]] Eigen::Vector3d start(double given_exponent) const {
        Eigen::Vector3d best = Eigen::Vector3d::Constant(undefined);
        double least = std::numeric_limits<double>::infinity();
        double steepest = 0.0;  // slope of the best rise, G0 whatever its sign
        for (int k = 0; k <= 60; ++k) {
            const double exponent = exponent_free ? 0.03 * std::pow(100.0, k / 60.0) : given_exponent;
            Eigen::MatrixXd design(rate.size(), 2);
            design << weight, weight * (exponent * log_speed).exp();
            const Eigen::Vector2d linear = numerics::least_squares(design, weight * rate);
            steepest = std::max(steepest, linear[1]);
            const double cost = (design * linear - (weight * rate).matrix()).squaredNorm();
            if (linear[0] > 0.0 && linear[1] > 0.0 && cost < least) {
                least = cost;
                best = {std::log(linear[0]), std::log(linear[1]), std::log(exponent)};
            }
            if (!exponent_free) break;
        }
        if (best.allFinite()) return best;
        if (!(steepest > 0.0))
            throw UndefinedDataError(
                "the energy release rate does not rise with the speed of the edge: it holds no crack-speed law; check "
                "the sign of the speed and that E* is that of the branch");
        throw UndefinedDataError(
            "the energy release rate goes to zero with the speed of the edge: its threshold G0 is not above 0 within "
            "these data; take slower samples into the fit");
    }

    [[nodiscard]] ResidualFunction function(double log_exponent) const {
        return {.residuals = rate.size(),
                .parameters = unknowns(),
                .evaluate = [this, log_exponent](const Eigen::VectorXd& at, Eigen::VectorXd& residuals,
                                                 Eigen::MatrixXd* jacobian) {
                    const double exponent = std::exp(exponent_free ? at[2] : log_exponent);
                    const Array1D rise = (at[1] + exponent * log_speed).exp();
                    residuals = weight * (rate - std::exp(at[0]) - rise);
                    if (!jacobian) return;
                    jacobian->col(0) = -weight * std::exp(at[0]);
                    jacobian->col(1) = -weight * rise;
                    if (exponent_free) jacobian->col(2) = -weight * rise * exponent * log_speed;
                }};
    }

    [[nodiscard]] law::Law law_at(const Eigen::Vector3d& at) const {
        // c = G0 (v_ref/v0)^n
        return {.threshold = std::exp(at[0]),
                .reference_speed = reference * std::exp((at[0] - at[1]) / std::exp(at[2])),
                .exponent = std::exp(at[2])};
    }
};

void require_points(const CrackSpeedPoints& points, const CrackSpeedOptions& options) {
    const auto same = [&](const Array1D& series, const char* name, bool needed) {
        if ((needed || series.size() > 0) && series.size() != points.speed.size())
            throw InvalidArgument(
                fmt::format("{} has {} points, speed has {}", name, series.size(), points.speed.size()));
    };
    same(points.energy_release_rate, "energy release rate", true);
    same(points.speed_standard_error, "standard error of speed", false);
    same(points.energy_release_rate_standard_error, "standard error of the energy release rate", false);
    if (options.exponent && !(*options.exponent > 0.0))
        throw InvalidArgument(fmt::format("exponent of the crack-speed law must be > 0, got {}", *options.exponent));
}

std::vector<Index> receding(const CrackSpeedPoints& points) {
    std::vector<Index> kept;
    for (Index i = 0; i < points.speed.size(); ++i)
        if (points.speed[i] > 0.0 && points.energy_release_rate[i] > 0.0 &&
            std::isfinite(points.speed[i] + points.energy_release_rate[i]))
            kept.push_back(i);
    return kept;
}

}  // namespace

EdgeSpeeds speeds_of_edge(const ArrayView1D& time, const ArrayView1D& contact_radius, Index window) {
    const Index n = time.size();
    if (contact_radius.size() != n)
        throw InvalidArgument(fmt::format("contact radius has {} samples, time has {}", contact_radius.size(), n));
    if (window < 5 || window % 2 == 0)
        throw InvalidArgument(fmt::format("window must be odd and >= 5 samples, got {}", window));
    if (n < window) throw UndefinedDataError(fmt::format("{} samples are fewer than the window of {}", n, window));
    for (Index i = 1; i < n; ++i)
        if (!(time[i] > time[i - 1]))
            throw InvalidArgument(
                fmt::format("time must rise: sample {} at {} s follows {} s", i, time[i], time[i - 1]));
    if (!contact_radius.allFinite())
        throw InvalidArgument("contact radii must be defined; leave samples without one out");
    EdgeSpeeds edge{.speed = Array1D(n), .standard_error = Array1D(n), .window = window};
    double scatter = 0.0;
    for (Index i = 0; i < n; ++i) {
        const Index first = std::clamp<Index>(i - window / 2, 0, n - window);
        const double scale = time[first + window - 1] - time[first];
        const Array1D steps = (time.segment(first, window) - time[i]) / scale;
        Eigen::MatrixXd design(window, 3);
        design << Array1D::Ones(window), steps, steps.square();
        const Eigen::VectorXd radii = contact_radius.segment(first, window);
        const Eigen::Vector3d parabola = numerics::least_squares(design, radii);
        const Eigen::Matrix3d inverse = Eigen::Matrix3d(numerics::transposed_product(design, design)).inverse();
        edge.speed[i] = -parabola[1] / scale;
        edge.standard_error[i] = std::sqrt(inverse(1, 1)) / scale;  // per unit of noise
        scatter += (radii - design * parabola).squaredNorm() / static_cast<double>(window - 3);
    }
    edge.contact_radius_noise = std::sqrt(scatter / static_cast<double>(n));
    edge.standard_error *= edge.contact_radius_noise;
    return edge;
}

CrackSpeedFit fit_crack_speed(const CrackSpeedPoints& points, const CrackSpeedOptions& options) {
    require_points(points, options);
    const std::vector<Index> kept = receding(points);
    const auto n = static_cast<Index>(kept.size());
    CrackSpeedFit fit{.n = n, .left_out = points.speed.size() - n};
    const Index fewest = options.exponent ? 3 : 4;
    if (n < fewest)
        throw UndefinedDataError(
            fmt::format("the contact edge recedes at {} of {} points; a crack-speed law needs at least {}", n,
                        points.speed.size(), fewest));
    const Array1D speed = points.speed(kept), rate = points.energy_release_rate(kept);
    fit.speed_ratio = speed.maxCoeff() / speed.minCoeff();
    if (!(fit.speed_ratio >= options.least_speed_ratio))
        throw UndefinedDataError(fmt::format(
            "speeds of the edge run from {:.3g} to {:.3g} m/s, a factor {:.2g}; a crack-speed law needs {:.2g} or "
            "more: unload at several speeds",
            speed.minCoeff(), speed.maxCoeff(), fit.speed_ratio, options.least_speed_ratio));
    LawProblem problem{.rate = rate, .reference = std::exp(speed.log().mean()), .exponent_free = !options.exponent};
    problem.log_speed = (speed / problem.reference).log();
    const bool known = points.energy_release_rate_standard_error.size() > 0;
    // without errors of G: relative ones, of equal size
    const Array1D rate_error = known ? Array1D(points.energy_release_rate_standard_error(kept)) : rate;
    if (!(rate_error.minCoeff() > 0.0)) throw InvalidArgument("standard errors of the energy release rate must be > 0");
    problem.weight = rate_error.inverse();

    Eigen::Vector3d at = problem.start(options.exponent.value_or(0.0));
    const double log_exponent = options.exponent ? std::log(*options.exponent) : 0.0;
    const bool speed_errors = points.speed_standard_error.size() > 0;
    LeastSquaresSolution solution;
    const int rounds = speed_errors ? 10 : 1;
    for (int round = 0; round < rounds; ++round) {
        solution = solve_nonlinear(problem.function(log_exponent), at.head(problem.unknowns()));
        fit.iterations += solution.iterations;
        at.head(problem.unknowns()) = solution.parameters;
        if (round + 1 == rounds || !speed_errors) break;
        const law::Law now = problem.law_at(at);
        for (Index i = 0; i < n; ++i) {
            const double slope = law::energy_release_rate_derivative(speed[i], now);
            const double scale = known ? 1.0 : solution.residuals.norm() / std::sqrt(static_cast<double>(n));
            problem.weight[i] =
                1.0 / std::hypot(rate_error[i] * (scale > 0.0 ? scale : 1.0),
                                 slope * points.speed_standard_error[kept[static_cast<std::size_t>(i)]]);
        }
    }

    fit.law = problem.law_at(at);
    // ln v0 = ln v_ref + (ln G0 − ln c)/n
    const double exponent = fit.law.exponent;
    Eigen::Matrix3d slopes;
    slopes << fit.law.threshold, 0.0, 0.0, fit.law.reference_speed / exponent, -fit.law.reference_speed / exponent,
        -fit.law.reference_speed * (at[0] - at[1]) / exponent, 0.0, 0.0, exponent;
    const Index p = problem.unknowns();
    fit.covariance = slopes.leftCols(p) * solution.uncertainty.covariance * slopes.leftCols(p).transpose();
    const auto estimate = [&](double value, Index k) {
        return solution.estimate(value, std::sqrt(fit.covariance(k, k)));
    };
    fit.threshold = estimate(fit.law.threshold, 0);
    fit.reference_speed = estimate(fit.law.reference_speed, 1);
    fit.exponent = options.exponent ? Estimate{.value = exponent, .standard_error = 0.0, .method = "given"}
                                    : estimate(exponent, 2);
    fit.converged = solution.converged && fit.covariance.allFinite();
    if (!(solution.uncertainty.covariance(0, 0) <= 1.0) || fit.law.threshold < 1e-6 * rate.minCoeff())
        throw UndefinedDataError(
            fmt::format("the threshold G0 = {:.2g} J/m² is known to no better than its own size: all samples are fast "
                        "against v0; take slower samples into the fit or give the exponent",
                        fit.law.threshold));
    fit.residuals = rate - law::energy_release_rate(speed, fit.law);
    fit.relative_residual = std::sqrt((fit.residuals / rate).square().mean());
    fit.chi2_reduced = known && n > p ? solution.residuals.squaredNorm() / static_cast<double>(n - p) : undefined;
    return fit;
}

CrackSpeedPoints crack_speed_points(const ArrayView1D& time, const ArrayView1D& contact_radius,
                                    const ArrayView1D& energy_release_rate, Index window) {
    if (energy_release_rate.size() != time.size())
        throw InvalidArgument(
            fmt::format("energy release rate has {} samples, time has {}", energy_release_rate.size(), time.size()));
    EdgeSpeeds edge = speeds_of_edge(time, contact_radius, window);
    return {.speed = std::move(edge.speed),
            .energy_release_rate = energy_release_rate,
            .speed_standard_error = std::move(edge.standard_error)};
}

}  // namespace setae::loops
