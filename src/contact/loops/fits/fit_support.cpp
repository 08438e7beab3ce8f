// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_support.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/contact/elasticity.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {

void require_data(const BranchData& data, const LensAndCounterBody& bodies, const Wanted& wanted) {
    if (!(bodies.radius > 0.0) || std::isinf(bodies.radius))
        throw InvalidArgument(fmt::format("sphere radius must be > 0 m and finite, got {}", bodies.radius));
    const auto check = [&](const Array1D& series, const char* name, bool needed) {
        if (series.size() == 0 && needed && data.force.size() > 0)
            throw UndefinedDataError(fmt::format("this fit needs the {}, which was not measured", name));
        if (series.size() != 0 && series.size() != data.force.size())
            throw InvalidArgument(
                fmt::format("{} has {} samples, force has {}", name, series.size(), data.force.size()));
    };
    check(data.contact_radius, "contact radius", wanted.contact_radius);
    check(data.displacement, "displacement", wanted.displacement);
    if (data.force.size() < wanted.fewest)
        throw UndefinedDataError(
            fmt::format("{} samples, this fit needs at least {}", data.force.size(), wanted.fewest));
}

double force_scale(const BranchData& data) {
    const double scale = data.force.abs().maxCoeff();
    if (!(scale > 0.0)) throw UndefinedDataError("all forces of the branch are zero; a fit needs a force that changes");
    return scale;
}

void require_modulus(double contact_modulus) {
    if (contact_modulus > 0.0 && std::isfinite(contact_modulus)) return;
    throw UndefinedDataError(
        "the contact shrinks as the force rises along the branch, or does not change; expected an "
        "elastic contact that grows; check the segments and the signs of the columns");
}

double square_standard_error(double root, double root_standard_error, double factor) {
    const double variance = root_standard_error * root_standard_error;
    return factor * std::sqrt(4.0 * root * root * variance + 2.0 * variance * variance);
}

WorkFromRoot work_from_root(const Eigen::Vector2d& modulus_and_root, const Eigen::MatrixXd& covariance) {
    const double modulus = modulus_and_root[0], root = modulus_and_root[1];
    const double work = root * std::abs(root) / modulus;
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols());
    slopes(1, 0) = -work / modulus;
    slopes(1, 1) = 2.0 * std::abs(root) / modulus;
    WorkFromRoot result{.work_of_adhesion = work, .covariance = slopes * covariance * slopes.transpose()};
    // the second-order term keeps the error finite at W = 0
    const double second = covariance(1, 1) / modulus;
    result.standard_error = std::sqrt(result.covariance(1, 1) + 2.0 * second * second);
    return result;
}

Array1D shape_candidates() {
    constexpr Index steps = 20;
    Array1D candidates(steps + 1);
    candidates[0] = 0.0;
    candidates.tail(steps) = pow(10.0, Array1D::LinSpaced(steps, -1.5, 1.0));
    return candidates;
}

Estimate youngs_modulus(const Estimate& contact_modulus, const LensAndCounterBody& bodies) {
    const contact::ElasticSolid counter = bodies.counter_body();
    const bool rigid = std::isinf(counter.youngs_modulus);
    const double stiffest = rigid ? INFINITY : contact::contact_modulus(counter, {.youngs_modulus = INFINITY});
    if (!(contact_modulus.value > 0.0 && contact_modulus.value < stiffest)) return {undefined};
    const double modulus = contact::youngs_modulus_from(contact_modulus.value, bodies.lens_poisson_ratio, counter);
    // dE/dE* = (E/E*)² / (1 − ν²)
    const double ratio = modulus / contact_modulus.value;
    const double compliance = 1.0 - bodies.lens_poisson_ratio * bodies.lens_poisson_ratio;
    Estimate result = contact_modulus;
    result.value = modulus;
    result.standard_error *= ratio * ratio / compliance;
    result.interval.reset();
    return result;
}

namespace {

/// Interval from 0 to the largest W that is compatible with 0, where the best W is below 0.
void bound_interval(JkrFit& fit) {
    if (!fit.unbounded_work) return;
    Estimate zero = fit.work_of_adhesion;
    zero.interval.reset();
    if (const auto around = interval_of(zero))
        fit.work_of_adhesion.interval = Interval{.lower = 0.0, .upper = around->upper, .level = around->level};
}

/// W ∝ p|p|, and the sum of squares is a parabola in p: at p = 0 the other parameters have changed by
/// −cov(x, p) p/var p = −2 cov(x, W) W/var W.
void keep_work_positive(JkrFit& fit) {
    const double work = fit.work_of_adhesion.value;
    if (!(work < 0.0)) return;
    fit.unbounded_work = fit.work_of_adhesion;
    const auto moved = [&](double value, Index parameter) {
        const double change = -2.0 * fit.covariance(parameter, 1) * work / fit.covariance(1, 1);
        return std::isfinite(change) ? value + change : value;
    };
    const double modulus = moved(fit.contact_modulus.value, 0);
    if (modulus > 0.0) fit.contact_modulus.value = modulus;
    if (fit.covariance.rows() > 2) fit.contact_point.value = moved(fit.contact_point.value, 2);
    fit.work_of_adhesion.value = 0.0;
    bound_interval(fit);
}

}  // namespace

namespace {

double neighbours_correlation(const Array1D& residuals) {
    const Index n = residuals.size();
    if (n < 3) return 0.0;
    const Array1D rest = residuals - residuals.mean();
    return (rest.head(n - 1) * rest.tail(n - 1)).sum() / rest.square().sum();
}

}  // namespace

void complete(JkrFit& fit, const LensAndCounterBody& bodies, double fitted_range) {
    // records without noise leave residuals of rounding, which are not the error of the fit
    constexpr double accuracy = 1e-6;
    for (Estimate* estimate : {&fit.contact_modulus, &fit.work_of_adhesion})
        if (std::isfinite(estimate->standard_error))
            estimate->standard_error = std::max(estimate->standard_error, accuracy * std::abs(estimate->value));
    keep_work_positive(fit);
    fit.youngs_modulus = youngs_modulus(fit.contact_modulus, bodies);
    fit.correlation = fit.covariance(0, 1) / std::sqrt(fit.covariance(0, 0) * fit.covariance(1, 1));
    fit.converged = fit.converged && fit.covariance.allFinite();
    fit.n = fit.residuals.size();
    fit.runs = runs_test(fit.residuals);
    fit.rms_residual = std::sqrt(fit.residuals.square().mean());
    fit.relative_residual = fit.rms_residual / fitted_range;
    constexpr double largest_chi2 = 4.0, largest_correlation = 0.5;
    if (std::isfinite(fit.chi2_reduced))
        fit.within_noise =
            !(fit.chi2_reduced > largest_chi2 && neighbours_correlation(fit.residuals) > largest_correlation);
}

void add_force_zero_error(JkrFit& fit, const JkrFit& shifted, const LensAndCounterBody& bodies) {
    Eigen::VectorXd change(fit.covariance.rows());
    change[0] = shifted.contact_modulus.value - fit.contact_modulus.value;
    change[1] = shifted.work_of_adhesion.value - fit.work_of_adhesion.value;
    if (change.size() > 2) change[2] = shifted.contact_point.value - fit.contact_point.value;
    if (!change.allFinite() || !shifted.converged) return;
    fit.covariance += change * change.transpose();
    fit.contact_modulus.standard_error = std::hypot(fit.contact_modulus.standard_error, change[0]);
    fit.work_of_adhesion.standard_error = std::hypot(fit.work_of_adhesion.standard_error, change[1]);
    if (change.size() > 2) fit.contact_point.standard_error = std::hypot(fit.contact_point.standard_error, change[2]);
    bound_interval(fit);
    fit.youngs_modulus = youngs_modulus(fit.contact_modulus, bodies);
    fit.correlation = fit.covariance(0, 1) / std::sqrt(fit.covariance(0, 0) * fit.covariance(1, 1));
}

Array1D block_means(const Array1D& series, Index neighbours) {
    const Index blocks = series.size() / neighbours;
    return Eigen::Map<const Array2D>(series.data(), blocks, neighbours).rowwise().mean();
}

Index neighbours_of_a_first_solution(Index samples) {
    constexpr Index enough = 64;
    return std::max<Index>(1, samples / enough);
}

double reduced_chi2(const ArrayView1D& residuals, const ArrayView1D& variances, Index parameters) {
    const Index freedom = residuals.size() - parameters;
    if (freedom <= 0 || !(variances.minCoeff() > 0.0)) return undefined;
    return (residuals.square() / variances).sum() / static_cast<double>(freedom);
}

}  // namespace setae::loops
