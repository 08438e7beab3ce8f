// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/loop_dependence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::study {
namespace {

using loops::SharedInput;

struct Number {
    double LoopNumbers::*value;
    Components LoopDependence::*inputs;
    const char* name;
};
constexpr std::array<Number, 7> numbers{
    {{&LoopNumbers::contact_modulus, &LoopDependence::contact_modulus, "E*"},
     {&LoopNumbers::youngs_modulus, &LoopDependence::youngs_modulus, "E"},
     {&LoopNumbers::approach, &LoopDependence::approach, "W of approach"},
     {&LoopNumbers::pull_off, &LoopDependence::pull_off, "W of pull-off"},
     {&LoopNumbers::retraction, &LoopDependence::retraction, "W_ret at pull-off"},
     {&LoopNumbers::loss, &LoopDependence::loss, "the loss"},
     {&LoopNumbers::contact_area, &LoopDependence::contact_area, "the contact area"}}};

double freedom_of(const Estimate& estimate) {
    return estimate.degrees_of_freedom.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

LoopNumbers numbers_of(const loops::ContactAnalysis& contact) {
    const auto& fit = contact.loading.primary();
    LoopNumbers found{.contact_modulus = fit.contact_modulus.value,
                      .youngs_modulus = fit.youngs_modulus.value,
                      .approach = fit.work_of_adhesion.value};
    if (contact.pull_off) found.pull_off = contact.pull_off->work_of_adhesion.value;
    if (contact.retraction) found.retraction = contact.retraction->work_of_adhesion.value;
    if (contact.loop) found.loss = contact.loop->energy;
    if (contact.context.largest_contact_area > 0.0) found.contact_area = contact.context.largest_contact_area;
    return found;
}

std::string input_name(const Estimate& input, const std::string& otherwise) {
    return input.input.empty() ? otherwise : input.input;
}

std::vector<UncertainInput> uncertain_inputs(const ExperimentInput& experiment, const ElastomerInput& elastomer) {
    std::vector<UncertainInput> found;
    const auto add = [&](SharedInput input, const std::optional<Estimate>& value, const std::string& owner) {
        if (value && value->uncertain())
            found.push_back({input, input_name(*value, owner + "." + loops::shared_input_name(input)), *value});
    };
    const std::string own = experiment.file, of_elastomer = "elastomers." + elastomer.name;
    if (experiment.sphere_radius) add(SharedInput::sphere_radius, experiment.sphere_radius, own);
    else add(SharedInput::sphere_radius, elastomer.sphere_radius, of_elastomer);
    add(SharedInput::sphere_height, elastomer.sphere_height, of_elastomer);
    add(SharedInput::poisson_ratio, elastomer.poisson_ratio, of_elastomer);
    add(SharedInput::machine_stiffness, experiment.machine_stiffness, own);
    add(SharedInput::force_calibration, experiment.force_calibration, own);
    add(SharedInput::displacement_calibration, experiment.displacement_calibration, own);
    add(SharedInput::contact_radius_calibration, experiment.contact_radius_calibration, own);
    return found;
}

loops::Calibration calibration_of(const ExperimentInput& experiment) {
    return {experiment.force_calibration.value, experiment.displacement_calibration.value,
            experiment.contact_radius_calibration.value};
}

std::vector<LoopNumbers> derivatives_of(const loops::Loop& recorded, const loops::LensAndCounterBody& bodies,
                                        const loops::AnalysisOptions& options, const loops::LoopAnalysis& analysis,
                                        const std::vector<UncertainInput>& inputs) {
    std::vector<LoopNumbers> found;
    for (const auto& input : inputs) {
        LoopNumbers by_input;
        try {
            const loops::InputDerivative derivative(recorded, bodies, options, analysis, input.input);
            for (const auto& number : numbers)
                by_input.*number.value = derivative.of(
                    [&](const loops::ContactAnalysis& contact) { return numbers_of(contact).*number.value; });
        } catch (const UndefinedDataError&) {
            // reported with the number, for all of them
        }
        // factors are in the record already: derivative by the factor itself, not by an additional one
        const bool factor = input.input == SharedInput::force_calibration ||
                            input.input == SharedInput::displacement_calibration ||
                            input.input == SharedInput::contact_radius_calibration;
        if (factor)
            for (const auto& number : numbers) by_input.*number.value /= input.value.value;
        found.push_back(by_input);
    }
    return found;
}

LoopDependence dependence_of(const LoopNumbers& of_loop, const std::vector<UncertainInput>& inputs,
                             const std::vector<LoopNumbers>& derivatives) {
    LoopDependence dependence;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        for (const auto& number : numbers) {
            if (!std::isfinite(of_loop.*number.value)) continue;
            const double slope = derivatives[i].*number.value;
            if (!std::isfinite(slope)) {
                dependence.lost.push_back(fmt::format("the derivative of {} with respect to {} could not be computed",
                                                      number.name, inputs[i].name));
                continue;
            }
            if (slope == 0.0) continue;
            const TracedValue input(inputs[i].value, inputs[i].name);
            auto& of_number = dependence.*number.inputs;
            of_number = combined({{1.0, of_number}, {slope, input.components}});
        }
    return dependence;
}

FitNoise fit_noise_of(const loops::JkrFit& fit) {
    const auto& E = fit.youngs_modulus;
    const auto& W = fit.work_of_adhesion;
    FitNoise noise;
    if (!E.uncertain() || !W.uncertain() || !std::isfinite(fit.correlation)) return noise;
    const double along = std::clamp(fit.correlation, -1.0, 1.0);
    noise.youngs_modulus = {Array1D{{E.standard_error, 0.0}}, freedom_of(E)};
    noise.work_of_adhesion = {Array1D{{along * W.standard_error, std::sqrt(1.0 - along * along) * W.standard_error}},
                              freedom_of(W)};
    return noise;
}

Component area_noise_of(const loops::JkrFit& fit, const loops::LensAndCounterBody& bodies, double force) {
    const auto noise = fit_noise_of(fit);
    const double E = fit.youngs_modulus.value, modulus = fit.contact_modulus.value, W = fit.work_of_adhesion.value,
                 nu = bodies.lens_poisson_ratio;
    if (noise.youngs_modulus.directions.size() == 0 || !(W > 0.0)) return {};
    const auto area = [&](double of_modulus, double of_work) {
        const double a = contact::jkr::contact_radius_at_force(force, {bodies.radius, of_modulus, of_work});
        return pi * a * a;
    };
    const auto slope = [](const std::function<double(double)>& of, double at, double error) {
        const double step = std::min(error, 0.5 * at);
        return (of(at + step) - of(at - step)) / (2.0 * step);
    };
    const double by_modulus = slope([&](double x) { return area(x, W); }, modulus, fit.contact_modulus.standard_error),
                 by_work = slope([&](double x) { return area(modulus, x); }, W, fit.work_of_adhesion.standard_error),
                 by_youngs_modulus = (1.0 - nu * nu) * modulus * modulus / (E * E) * by_modulus;
    return {by_youngs_modulus * noise.youngs_modulus.directions + by_work * noise.work_of_adhesion.directions,
            noise.youngs_modulus.degrees_of_freedom};
}

std::string fit_name(const std::string& file) { return "fit of " + file; }

std::string loops_name(const std::string& elastomer) { return fmt::format("E of {}, loops", elastomer); }

Component beyond_fits(const Estimate& mean, const Components& fits) {
    double left = mean.variance(), uncertainty = left * left / freedom_of(mean);
    for (const auto& [name, fit] : fits) {
        left -= fit.variance();
        uncertainty -= fit.variance() * fit.variance() / fit.degrees_of_freedom;
    }
    constexpr double rounding = 1e-12;
    if (!(left > rounding * mean.variance())) return {};
    Component rest{Array1D::Constant(1, std::sqrt(left))};
    if (uncertainty > 0.0) rest.degrees_of_freedom = left * left / uncertainty;
    return rest;
}

}  // namespace setae::study
