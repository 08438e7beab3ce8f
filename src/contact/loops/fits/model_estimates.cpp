// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_estimates.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fit_support.hpp"
#include "setae/contact/maugis_dugdale.hpp"
#include "setae/contact/transition.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::loops {
namespace {

// a parameter known to no better than this factor e^(1/2) is none
constexpr double max_log_error = 0.5;
// beyond, Maugis–Dugdale's curve is that of DMT or JKR to a percent and less
constexpr double min_lambda = 0.02, max_lambda = 50.0;

/// Covariance of all four slots, 0 for fixed ones.
Eigen::Matrix4d slot_covariance(const PreparedFit& prepared, const LeastSquaresSolution& solution) {
    Eigen::Matrix4d all = Eigen::Matrix4d::Zero();
    for (std::size_t i = 0; i < prepared.free.size(); ++i)
        for (std::size_t k = 0; k < prepared.free.size(); ++k)
            all(prepared.free[i], prepared.free[k]) =
                solution.uncertainty.covariance(static_cast<Index>(i), static_cast<Index>(k));
    return all;
}

Estimate given(double value) { return {.value = value, .standard_error = 0.0, .method = "given"}; }

struct TransitionContact {
    double contact_modulus, work_of_adhesion;
    double cohesive_stress = undefined;
};

contact::transition::RadiusCurve curve_of_slots(const FitParameters& at) {
    return {.zero_load_radius = std::exp(at[0]),
            .pull_off_force = -std::exp(at[1]),
            .transition_share = 1.0 / (1.0 + std::exp(-at[2]))};
}

// share for which α gives no useful λ
constexpr double min_share = 0.01, max_share = 0.98;

/// The contact of a transition curve; its limits are JKR's and DMT's.
TransitionContact transition_contact(const FitParameters& at, double radius) {
    const contact::transition::RadiusCurve curve = curve_of_slots(at);
    if (curve.transition_share > min_share && curve.transition_share < max_share) {
        const auto contact = contact::transition::contact_of(curve, radius);
        return {contact.contact_modulus, contact.work_of_adhesion, contact.cohesive_stress};
    }
    const bool sticky = curve.transition_share >= max_share;
    const double pull = -curve.pull_off_force, cube = std::pow(curve.zero_load_radius, 3);
    // a0³ = 3R/(4E*) · 4P of JKR, P = −Fc; 3R/(4E*) (−Fc) of DMT
    return {0.75 * radius * pull * (sticky ? 4.0 : 1.0) / cube, pull / ((sticky ? 1.5 : 2.0) * pi * radius)};
}

void fill_transition(ModelFit& fit, const PreparedFit& prepared, const FitSolution& solution) {
    const double radius = prepared.problem.curve().radius();
    const Eigen::Matrix3d slots = slot_covariance(prepared, solution.least_squares).topLeftCorner<3, 3>();
    const auto curve = curve_of_slots(solution.at);
    const TransitionContact contact = transition_contact(solution.at, radius);
    const auto estimate = [&](double value, double error) { return solution.least_squares.estimate(value, error); };
    const double share = curve.transition_share, share_error = share * (1.0 - share) * std::sqrt(slots(2, 2));
    fit.zero_load_radius = estimate(curve.zero_load_radius, curve.zero_load_radius * std::sqrt(slots(0, 0)));
    fit.pull_off_force = estimate(curve.pull_off_force, -curve.pull_off_force * std::sqrt(slots(1, 1)));
    fit.transition_share = estimate(share, share_error);
    const bool determined = share_error <= 0.25 && std::isfinite(contact.cohesive_stress);
    // steps well above the resolution of the inverse through Maugis' model
    constexpr double step = 1e-4;
    const Index rows = determined ? 3 : 2;
    Eigen::MatrixXd slopes(rows, 3);
    for (Index k = 0; k < 3; ++k) {
        FitParameters more = solution.at, less = solution.at;
        more[k] += step;
        less[k] -= step;
        const TransitionContact above = transition_contact(more, radius), below = transition_contact(less, radius);
        slopes(0, k) = (above.contact_modulus - below.contact_modulus) / (2.0 * step);
        slopes(1, k) = (above.work_of_adhesion - below.work_of_adhesion) / (2.0 * step);
        if (determined) slopes(2, k) = (above.cohesive_stress - below.cohesive_stress) / (2.0 * step);
    }
    fit.parameters = {"contact_modulus", "work_of_adhesion"};
    if (determined) fit.parameters.push_back("cohesive_stress");
    fit.covariance = slopes * slots * slopes.transpose();
    fit.contact_modulus = estimate(contact.contact_modulus, std::sqrt(fit.covariance(0, 0)));
    fit.work_of_adhesion = estimate(contact.work_of_adhesion, std::sqrt(fit.covariance(1, 1)));
    if (determined) {
        fit.cohesive_stress = estimate(contact.cohesive_stress, std::sqrt(fit.covariance(2, 2)));
        const double lambda = contact::transition::transition_parameter(share);
        // dλ/dα = 0.924 · 1.02/(1 − 1.02 α)
        fit.transition_parameter = estimate(lambda, 0.924 * 1.02 / (1.0 - 1.02 * share) * share_error);
        return;
    }
    const std::string why =
        share_error > 0.25 ? fmt::format("α = {:.2f} ± {:.2f}: the branch does not determine the range of attraction",
                                         share, share_error)
        : share >= max_share
            ? fmt::format(
                  "α = {:.3f}: the branch is in the limit of JKR, which has no range of attraction; E* and W are "
                  "those of JKR",
                  share)
            : fmt::format(
                  "α = {:.3f}: the branch is in the limit of DMT, which does not determine the cohesive stress; "
                  "E* and W are those of DMT",
                  share);
    fit.cohesive_stress = Outcome<Estimate>::missing(why);
    fit.transition_parameter = Outcome<Estimate>::missing(why);
    if (share_error > 0.25) fit.transition_share = Outcome<Estimate>::missing(why);
    fit.undetermined.push_back(why);
}

void fill_zone(ModelFit& fit, const PreparedFit& prepared, const FitSolution& solution, const Eigen::Matrix4d& slots) {
    const ModelCurve& curve = prepared.problem.curve();
    const double lambda = curve.transition_parameter(solution.at.head<3>());
    const contact::AdhesiveContact contact{.radius = curve.radius(),
                                           .contact_modulus = fit.contact_modulus.value,
                                           .work_of_adhesion = curve.work_of_adhesion(solution.at.head<3>())};
    const double stress = contact::maugis_dugdale::cohesive_stress(lambda, contact);
    // ln σ0 = ln λ + ln W/3 + 2 ln E*/3 + …
    const Eigen::Vector4d third(0.0, 0.0, 1.0, 0.0);
    const Eigen::Vector4d towards(2.0 / 3.0, 1.0 / 3.0, 0.0, 0.0);
    const Eigen::Vector4d by_stress = curve.stress_given() ? third : Eigen::Vector4d(third + towards);
    const Eigen::Vector4d by_lambda = curve.stress_given() ? Eigen::Vector4d(third - towards) : third;
    const double lambda_error = std::sqrt(by_lambda.dot(slots * by_lambda));
    const double stress_error = std::sqrt(by_stress.dot(slots * by_stress));
    const auto estimate = [&](double value, double log_error) {
        return log_error > 0.0 ? solution.least_squares.estimate(value, value * log_error) : given(value);
    };
    fit.transition_parameter = estimate(lambda, lambda_error);
    fit.cohesive_stress = estimate(stress, stress_error);
    if (!prepared.is_free(2)) return;
    const bool ran_off = lambda < min_lambda || lambda > max_lambda;
    if (!ran_off && lambda_error <= max_log_error) return;
    if (ran_off) return leave_zone_open(fit, lambda);
    const std::string why = fmt::format(
        "λ = {:.2g} is uncertain by a factor of {:.2g}: the branch does not determine the range of "
        "attraction",
        lambda, std::exp(lambda_error));
    fit.transition_parameter = Outcome<Estimate>::missing(why);
    fit.cohesive_stress = Outcome<Estimate>::missing(why);
    fit.undetermined.push_back(why);
}

}  // namespace

void leave_zone_open(ModelFit& fit, double transition_parameter) {
    const std::string why =
        fmt::format("λ reached {:.2g}, the limit of {}: the branch does not determine the cohesive stress",
                    transition_parameter, transition_parameter > 1.0 ? "JKR" : "DMT");
    fit.transition_parameter = fit.cohesive_stress = Outcome<Estimate>::missing(why);
    fit.undetermined.push_back(why);
}

Eigen::MatrixXd correlations(const Eigen::MatrixXd& covariance) {
    const Eigen::VectorXd inverse = covariance.diagonal().cwiseSqrt().cwiseInverse();
    return inverse.asDiagonal() * covariance * inverse.asDiagonal();
}

Eigen::Vector4d physical_slopes(const BranchProblem& problem, const FitParameters& at) {
    const ModelCurve& curve = problem.curve();
    double work = 2.0 * std::abs(at[1]);
    if (curve.model() == ContactModel::dmt) work = 1.0;
    if (curve.model() == ContactModel::maugis_dugdale) work = std::exp(at[1]);
    return {std::exp(at[0]), work, std::exp(at[2]), problem.depth_unit()};
}

Outcome<Estimate> work_estimate(const ModelCurve& curve, const LeastSquaresSolution& solution, const FitParameters& at,
                                double slot_standard_error) {
    const double work = curve.work_of_adhesion(at.head<3>());
    if (curve.model() == ContactModel::dmt) return solution.estimate(work, slot_standard_error);
    if (curve.model() != ContactModel::maugis_dugdale)
        return solution.estimate(work, square_standard_error(at[1], slot_standard_error, 1.0));
    if (slot_standard_error <= max_log_error) return solution.estimate(work, work * slot_standard_error);
    return Outcome<Estimate>::missing(
        fmt::format("W = {} is uncertain by a factor of {:.2g}, since W depends on λ; include forces down to "
                    "pull-off in the fit, or give the cohesive stress",
                    format_value(work, "J/m2", 2), std::exp(slot_standard_error)));
}

void fill_estimates(ModelFit& fit, const PreparedFit& prepared, const FitSolution& solution,
                    const LensAndCounterBody& bodies) {
    const BranchProblem& problem = prepared.problem;
    const ModelCurve& curve = problem.curve();
    const LeastSquaresSolution& least_squares = solution.least_squares;
    fit.contact_point = {undefined};
    const Outcome<Estimate> no_zone = Outcome<Estimate>::missing(to_string(curve.model()) + " has no cohesive stress");
    fit.cohesive_stress = fit.transition_parameter = no_zone;
    fit.transition_share = fit.zero_load_radius = fit.pull_off_force =
        Outcome<Estimate>::missing("only the transition equation has this parameter");
    if (curve.model() == ContactModel::transition) {
        fill_transition(fit, prepared, solution);
    } else {
        const Eigen::Matrix4d slots = slot_covariance(prepared, least_squares);
        const auto error = [&](Index slot) { return std::sqrt(slots(slot, slot)); };
        const Eigen::Vector4d slopes = physical_slopes(problem, solution.at);
        const double modulus = std::exp(solution.at[0]), work = curve.work_of_adhesion(solution.at.head<3>());
        fit.contact_modulus =
            prepared.is_free(0) ? least_squares.estimate(modulus, modulus * error(0)) : given(modulus);
        if (curve.model() == ContactModel::hertz)
            fit.work_of_adhesion = Outcome<Estimate>::missing("hertz has no adhesion");
        else
            fit.work_of_adhesion =
                prepared.is_free(1) ? work_estimate(curve, least_squares, solution.at, error(1)) : given(work);
        if (!fit.work_of_adhesion && curve.model() != ContactModel::hertz)
            fit.undetermined.push_back(fit.work_of_adhesion.reason);
        if (curve.model() == ContactModel::maugis_dugdale) fill_zone(fit, prepared, solution, slots);
        if (problem.has_displacement()) {
            const double point = problem.contact_point(solution.at);
            fit.contact_point = prepared.is_free(contact_point_slot)
                                    ? least_squares.estimate(point, problem.depth_unit() * error(contact_point_slot))
                                    : given(point);
        }
        const std::array<const char*, 4> names{"contact_modulus", "work_of_adhesion", "transition_parameter",
                                               "contact_point"};
        fit.covariance.resize(static_cast<Index>(prepared.free.size()), static_cast<Index>(prepared.free.size()));
        for (std::size_t i = 0; i < prepared.free.size(); ++i) {
            fit.parameters.emplace_back(names[static_cast<std::size_t>(prepared.free[i])]);
            for (std::size_t k = 0; k < prepared.free.size(); ++k)
                fit.covariance(static_cast<Index>(i), static_cast<Index>(k)) =
                    slots(prepared.free[i], prepared.free[k]) * slopes[prepared.free[i]] * slopes[prepared.free[k]];
        }
    }
    fit.youngs_modulus = youngs_modulus(fit.contact_modulus, bodies);
    fit.correlations = correlations(fit.covariance);
}

}  // namespace setae::loops
