// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/model_fits.hpp"
#include "setae/core/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model_estimates.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::loops {
namespace {

constexpr std::array<std::pair<ContactModel, const char*>, 7> names{{{ContactModel::hertz, "hertz"},
                                                                     {ContactModel::dmt, "dmt"},
                                                                     {ContactModel::jkr, "jkr"},
                                                                     {ContactModel::maugis_dugdale, "maugis_dugdale"},
                                                                     {ContactModel::transition, "transition"},
                                                                     {ContactModel::layer, "layer"},
                                                                     {ContactModel::large_strain, "large_strain"}}};

/// The error of the zero of force: the change of all estimates to the same data with forces higher by one of its modes.
void add_force_zero(ModelFit& fit, const BranchData& data, Index mode, const LensAndCounterBody& bodies,
                    const ModelFitOptions& options, const FitSolution& solution) {
    const BranchData higher = data.with_higher_force(data.force_zero_modes.col(mode));
    PreparedFit prepared = prepare(higher, bodies, options);
    const FitSolution moved = solve(prepared, solution.at);
    if (!moved.least_squares.converged) return;
    ModelFit shifted{.model = fit.model};
    fill_estimates(shifted, prepared, moved, bodies);
    if (shifted.parameters != fit.parameters) return;
    const auto value = [](const ModelFit& of, const std::string& name) {
        if (name == "contact_modulus") return of.contact_modulus.value;
        if (name == "contact_point") return of.contact_point.value;
        const Outcome<Estimate>& outcome = name == "work_of_adhesion"       ? of.work_of_adhesion
                                           : name == "transition_parameter" ? of.transition_parameter
                                                                            : of.cohesive_stress;
        return outcome ? outcome->value : undefined;
    };
    Eigen::VectorXd change(fit.covariance.rows());
    for (Index i = 0; i < change.size(); ++i) {
        const std::string& name = fit.parameters[static_cast<std::size_t>(i)];
        change[i] = value(shifted, name) - value(fit, name);
        if (!std::isfinite(change[i])) change[i] = 0.0;
    }
    fit.covariance += change * change.transpose();
    const auto widen = [](Estimate& estimate, double other) {
        if (estimate.standard_error > 0.0)
            estimate.standard_error = std::hypot(estimate.standard_error, other - estimate.value);
    };
    widen(fit.contact_modulus, shifted.contact_modulus.value);
    if (std::isfinite(fit.contact_point.value)) widen(fit.contact_point, shifted.contact_point.value);
    for (const auto outcome : {&ModelFit::work_of_adhesion, &ModelFit::cohesive_stress, &ModelFit::transition_parameter,
                               &ModelFit::transition_share, &ModelFit::zero_load_radius, &ModelFit::pull_off_force})
        if (fit.*outcome && shifted.*outcome) widen(*(fit.*outcome).value, (shifted.*outcome)->value);
    fit.youngs_modulus = youngs_modulus(fit.contact_modulus, bodies);
    fit.correlations = correlations(fit.covariance);
}

/// Where λ diverges, W is that of the limit: tests whether it can be distinguished from W in the middle, at λ = 0.7.
void question_work(ModelFit& fit, const PreparedFit& prepared, const FitSolution& solution) {
    PreparedFit middle = prepared;
    middle.hold(2, std::log(0.7));
    FitParameters start = solution.at;
    start[2] = middle.given[2];
    const FitSolution other = solve(middle, start);
    const double chi2 = solution.least_squares.residuals.squaredNorm();
    const double freedom = static_cast<double>(prepared.problem.residuals() - static_cast<Index>(prepared.free.size()));
    // two standard errors, residuals counted as independent ones
    const double rise = other.least_squares.residuals.squaredNorm() - chi2;
    if (!fit.work_of_adhesion || !(rise < 4.0 * chi2 / freedom * fit.correlated_samples)) return;
    const double here = fit.work_of_adhesion->value,
                 there = prepared.problem.curve().work_of_adhesion(other.at.head<3>());
    fit.work_of_adhesion = Outcome<Estimate>::missing(
        fmt::format("W = {} at the limit of λ and W = {} at λ = 0.7 fit equally well: W depends on the range of "
                    "attraction; fit jkr or dmt, or give the cohesive stress",
                    format_value(here, "J/m2", 3), format_value(there, "J/m2", 3)));
    fit.undetermined.push_back(fit.work_of_adhesion.reason);
}

ChannelResiduals channel(Array1D residuals) {
    const double rms = residuals.size() > 0 ? std::sqrt(residuals.square().mean()) : 0.0;
    return {.values = std::move(residuals), .rms = rms};
}

void fill_residuals(ModelFit& fit, const PreparedFit& prepared, const FitSolution& solution) {
    const BranchProblem& problem = prepared.problem;
    const std::vector<CurvePoint> points = problem.fitted(solution.at);
    fit.fitted_radius.resize(problem.samples());
    for (Index i = 0; i < problem.samples(); ++i) fit.fitted_radius[i] = points[static_cast<std::size_t>(i)].radius;
    fit.force_residuals = channel(problem.force_residuals(points));
    fit.runs = runs_test(fit.force_residuals.values);
    if (fit.errors != FitErrors::force_only) {
        fit.displacement_residuals = channel(problem.displacement_residuals(points, solution.at));
        fit.contact_radius_residuals = channel(problem.radius_residuals(points));
    }
    fit.chi2 = problem.chi2(points, solution.at);
    const auto residuals = static_cast<double>(problem.residuals());
    const double scale = static_cast<double>(prepared.free.size()) + 1.0;  // with that of the noise
    fit.degrees_of_freedom = residuals - static_cast<double>(prepared.free.size());
    fit.chi2_reduced = fit.chi2 / fit.degrees_of_freedom;
    const double room = residuals - scale - 1.0;
    fit.akaike = room > 0.0 ? residuals * std::log(fit.chi2 / residuals) + 2.0 * scale * residuals / room : undefined;
}

std::optional<contact::tabor::Verdict> verdict(const ModelFit& fit, const BranchData& data, double radius,
                                               double range) {
    if (!fit.work_of_adhesion || !(fit.work_of_adhesion->value > 0.0)) return std::nullopt;
    // for equal largest attraction, σ0 = 16W/(9√3 z0): the relation also converts σ0 to z0
    if (fit.cohesive_stress)
        range = contact::tabor::lennard_jones_stress(fit.work_of_adhesion->value, fit.cohesive_stress->value);
    return contact::tabor::which_model(data.force.maxCoeff(),
                                       {.radius = radius,
                                        .contact_modulus = fit.contact_modulus.value,
                                        .work_of_adhesion = fit.work_of_adhesion->value},
                                       range);
}

}  // namespace

const std::vector<ContactModel>& contact_models() {
    static const std::vector<ContactModel> all = [] {
        std::vector<ContactModel> models;
        for (const auto& entry : names) models.push_back(entry.first);
        return models;
    }();
    return all;
}

std::string to_string(ContactModel model) {
    for (const auto& [known, name] : names)
        if (known == model) return name;
    throw InternalError("a contact model without a name");
}

ContactModel model_named(std::string_view name) {
    std::vector<std::string> known;
    for (const auto& [model, word] : names) {
        if (word == name) return model;
        known.emplace_back(word);
    }
    const std::string nearest = nearest_match(name, known);
    throw InvalidArgument(fmt::format("unknown contact model '{}'{}; expected one of {}", name,
                                      nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest),
                                      fmt::join(known, ", ")));
}

std::vector<std::string> names_of(Channels channels) {
    switch (channels) {
        case Channels::force_radius: return {"force", "contact_radius"};
        case Channels::force_displacement: return {"force", "displacement"};
        case Channels::force_displacement_radius: return {"force", "displacement", "contact_radius"};
    }
    return {};
}

std::string to_string(FitErrors errors) {
    switch (errors) {
        case FitErrors::force_only: return "force_only";
        case FitErrors::effective_variance: return "effective_variance";
        default: return "orthogonal_distance";
    }
}

Channels channels_of(const BranchData& data) {
    const bool displacement = data.displacement.size() > 0, radius = data.contact_radius.size() > 0;
    if (!displacement && !radius)
        throw UndefinedDataError("the branch has only the force; a fit also needs displacement or contact radius");
    if (displacement && radius) return Channels::force_displacement_radius;
    return radius ? Channels::force_radius : Channels::force_displacement;
}

ModelFit fit_model(const BranchData& data, const LensAndCounterBody& bodies, const ModelFitOptions& options) {
    return solved_fit(data, bodies, options).fit;
}

namespace {

/// W >= 0: the fit with W = 0 in place of one below, with the error that W has there.
SolvedFit without_adhesion(const BranchData& data, const LensAndCounterBody& bodies, const ModelFitOptions& options,
                           const FitSolution& below) {
    ModelFitOptions bound = options;
    bound.work_of_adhesion = 0.0;
    SolvedFit solved = solved_fit(data, bodies, bound);
    PreparedFit prepared = prepare(data, bodies, options);
    ModelFit free{.model = options.model};
    fill_estimates(free, prepared, below, bodies);
    Estimate work{.value = 0.0};
    if (free.work_of_adhesion) work.standard_error = free.work_of_adhesion->standard_error;
    if (const auto around = interval_of(work)) work.interval = Interval{0.0, around->upper, around->level};
    solved.fit.work_of_adhesion = work;
    solved.fit.undetermined.push_back(
        "W is at its limit 0: the measured contact is smaller than a contact without adhesion");
    return solved;
}

}  // namespace

SolvedFit solved_fit(const BranchData& data, const LensAndCounterBody& bodies, const ModelFitOptions& options) {
    PreparedFit prepared = prepare(data, bodies, options);
    FitSolution solution = solve(prepared, find_start(prepared, data));
    const ModelCurve& curve = prepared.problem.curve();
    const bool below = options.model != ContactModel::transition && prepared.is_free(1) &&
                       curve.work_of_adhesion(solution.at.head<3>()) < 0.0;
    if (below) return without_adhesion(data, bodies, options, solution);
    const bool zone_free = options.model == ContactModel::maugis_dugdale && prepared.is_free(2);
    PreparedFit reported = prepared;
    if (zone_free && !solution.least_squares.uncertainty.covariance.allFinite()) {
        // at the limits of λ nothing depends on it: the others' errors are those at that limit
        reported.hold(2, solution.at[2]);
        solution = solve(reported, solution.at);
    }
    ModelFit fit{.model = options.model,
                 .channels = options.channels ? *options.channels : channels_of(data),
                 .errors = options.errors,
                 .iterations = solution.least_squares.iterations,
                 .correlated_samples = solution.least_squares.uncertainty.correlated_samples,
                 .n = data.force.size(),
                 .noise = prepared.noise};
    fill_estimates(fit, reported, solution, bodies);
    if (zone_free && !reported.is_free(2)) leave_zone_open(fit, curve.transition_parameter(solution.at.head<3>()));
    if (zone_free && !fit.transition_parameter) question_work(fit, prepared, solution);
    fit.converged = solution.least_squares.converged && fit.covariance.allFinite();
    fill_residuals(fit, prepared, solution);
    for (Index mode = 0; mode < data.force_zero_modes.cols(); ++mode)
        add_force_zero(fit, data, mode, bodies, options, solution);
    fit.verdict = verdict(fit, data, curve.radius(), options.interaction_range);
    return {.fit = std::move(fit), .prepared = std::move(reported), .solution = std::move(solution)};
}

}  // namespace setae::loops
