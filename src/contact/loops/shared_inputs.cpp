// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/shared_inputs.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "contact_analysis.hpp"
#include "fits/fit_support.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

/// All that an analysis starts from.
struct Start {
    Loop recorded;
    LensAndCounterBody bodies;
    AnalysisOptions options;
};

/// The options with the decisions of an analysis fixed, and without those that do not affect any number.
AnalysisOptions as_decided(AnalysisOptions options, const LoopAnalysis& analysis) {
    using Mode = ContactPointChoice::Mode;
    if (analysis.contact_points && analysis.contact_points->chosen)
        options.contact_point = {.mode = Mode::estimator, .estimator = *analysis.contact_points->chosen};
    options.sensitivity_dropped.clear();
    options.machine_stiffness_standard_error = 0.0;
    return options;
}

double* constant_of(Start& start, SharedInput input) {
    const auto known = [](std::optional<double>& value) { return value ? &*value : nullptr; };
    switch (input) {
        case SharedInput::sphere_radius: return &start.bodies.radius;
        case SharedInput::sphere_height:
            return known(start.bodies.layer_thickness ? start.bodies.layer_thickness : start.bodies.lens_height);
        case SharedInput::poisson_ratio: return &start.bodies.lens_poisson_ratio;
        case SharedInput::machine_stiffness: return known(start.options.machine_stiffness);
        default: return nullptr;
    }
}

std::optional<Calibration> calibration_of(SharedInput input, double factor) {
    switch (input) {
        case SharedInput::force_calibration: return Calibration{.force = factor};
        case SharedInput::displacement_calibration: return Calibration{.displacement = factor};
        case SharedInput::contact_radius_calibration: return Calibration{.contact_radius = factor};
        default: return std::nullopt;
    }
}

ContactAnalysis analysed(const Start& start, const LoopAnalysis& as) {
    const auto record = prepared(start.recorded, as.faults, start.options, &as.segments);
    return analyse_contact(record, 0, start.bodies, start.options, &as);
}

void add_error(Estimate& estimate, double change) {
    if (!std::isfinite(change) || change == 0.0) return;
    estimate.standard_error = std::hypot(estimate.uncertain() ? estimate.standard_error : 0.0, change);
    estimate.interval.reset();
}

/// branch_of: a branch of a contact, or nullptr where it has none.
template <class BranchOf>
void add_branch_error(BranchAnalysis& branch, const LensAndCounterBody& bodies, const InputDerivative& derivative,
                      double standard_error, const BranchOf& branch_of) {
    for (const auto& way : fit_routes) {
        const auto route = way.fit;
        auto& fit = branch.*route;
        if (!fit) continue;
        const auto shift = [&](Estimate JkrFit::*number) {
            return standard_error * derivative.of([&](const ContactAnalysis& contact) {
                const BranchAnalysis* of = branch_of(contact);
                return of && of->*route ? (*(of->*route).value.*number).value : undefined;
            });
        };
        JkrFit shifted = *fit;
        shifted.converged = true;
        shifted.contact_modulus.value += shift(&JkrFit::contact_modulus);
        shifted.work_of_adhesion.value += shift(&JkrFit::work_of_adhesion);
        shifted.contact_point.value += shift(&JkrFit::contact_point);
        add_force_zero_error(*fit.value, shifted, bodies);
    }
    if (!branch.pointwise) return;
    add_error(branch.pointwise.value->contact_modulus,
              standard_error * derivative.of([&](const ContactAnalysis& contact) {
                  const BranchAnalysis* of = branch_of(contact);
                  return of && of->pointwise ? of->pointwise->contact_modulus.value : undefined;
              }));
    branch.pointwise.value->youngs_modulus = youngs_modulus(branch.pointwise->contact_modulus, bodies);
}

}  // namespace

const char* shared_input_name(SharedInput input) {
    switch (input) {
        case SharedInput::sphere_radius: return "sphere_radius";
        case SharedInput::sphere_height: return "sphere_height";
        case SharedInput::poisson_ratio: return "poisson_ratio";
        case SharedInput::machine_stiffness: return "machine_stiffness";
        case SharedInput::force_calibration: return "force_calibration";
        case SharedInput::displacement_calibration: return "displacement_calibration";
        case SharedInput::contact_radius_calibration: return "contact_radius_calibration";
    }
    throw InternalError("unknown shared input");
}

Loop calibrated(Loop recorded, const Calibration& factors) {
    recorded.force *= factors.force;
    recorded.displacement *= factors.displacement;
    recorded.contact_radius *= factors.contact_radius;
    return recorded;
}

AnalysisOptions calibrated(AnalysisOptions options, const Calibration& factors) {
    if (options.segments.force_baseline) *options.segments.force_baseline *= factors.force;
    options.contact_point.value *= factors.displacement;
    options.displacement_drift_rate *= factors.displacement;
    if (options.contact_radius_noise) *options.contact_radius_noise *= factors.contact_radius;
    return options;
}

InputDerivative::InputDerivative(const Loop& recorded, const LensAndCounterBody& bodies, const AnalysisOptions& options,
                                 const LoopAnalysis& analysis, SharedInput input)
    : here_(analysis) {
    constexpr double step = 1e-3;
    const Start start{recorded, bodies, as_decided(options, analysis)};
    // ν has bounds of its own, everything else is a scale
    if (input == SharedInput::poisson_ratio) {
        constexpr double most = 0.5;
        const double value = bodies.lens_poisson_ratio;
        const auto moved = [&](double by) {
            Start there = start;
            there.bodies.lens_poisson_ratio = value + by;
            return analysed(there, analysis);
        };
        if (value - step >= 0.0 && value + step <= most) {
            beside_ = {moved(step), moved(-step)};
            weights_ = {0.5 / step, -0.5 / step};
        } else {
            const double inwards = value + step > most ? -step : step;
            beside_ = {moved(inwards), moved(2.0 * inwards)};
            weights_ = {2.0 / inwards, -0.5 / inwards};
        }
        return;
    }
    double value = 1.0;
    const auto scaled = [&](double by) {
        Start there = start;
        const double factor = std::exp(by);
        if (const auto factors = calibration_of(input, factor)) {
            there.recorded = calibrated(std::move(there.recorded), *factors);
            there.options = calibrated(std::move(there.options), *factors);
        } else {
            double* constant = constant_of(there, input);
            if (!constant)
                throw InvalidArgument(
                    fmt::format("{}: the loop was analysed without this input", shared_input_name(input)));
            value = *constant;
            *constant *= factor;
        }
        return analysed(there, analysis);
    };
    beside_ = {scaled(step), scaled(-step)};
    weights_ = {0.5 / (step * value), -0.5 / (step * value)};
}

double InputDerivative::of(const std::function<double(const ContactAnalysis&)>& number) const {
    // differences: exactly 0 for unchanged numbers
    const double here = number(here_);
    return weights_[0] * (number(beside_[0]) - here) + weights_[1] * (number(beside_[1]) - here);
}

void add_input_error(LoopAnalysis& analysis, const LensAndCounterBody& bodies, const InputDerivative& derivative,
                     double standard_error) {
    add_branch_error(analysis.loading, bodies, derivative, standard_error,
                     [](const ContactAnalysis& contact) { return &contact.loading; });
    if (analysis.unloading)
        add_branch_error(
            *analysis.unloading.value, bodies, derivative, standard_error,
            [](const ContactAnalysis& contact) { return contact.unloading ? &*contact.unloading : nullptr; });
    const auto shift = [&](const std::function<double(const ContactAnalysis&)>& number) {
        return standard_error * derivative.of(number);
    };
    if (analysis.pull_off) {
        auto& pull_off = *analysis.pull_off.value;
        add_error(pull_off.work_of_adhesion, shift([](const ContactAnalysis& contact) {
                      return contact.pull_off ? contact.pull_off->work_of_adhesion.value : undefined;
                  }));
        if (auto& stiff = pull_off.work_of_adhesion_fixed_grips)
            add_error(*stiff.value, shift([](const ContactAnalysis& contact) {
                const auto* found = contact.pull_off ? &contact.pull_off->work_of_adhesion_fixed_grips : nullptr;
                return found && *found ? (*found)->value : undefined;
            }));
    }
    if (analysis.retraction)
        add_error(analysis.retraction.value->work_of_adhesion, shift([](const ContactAnalysis& contact) {
                      return contact.retraction ? contact.retraction->work_of_adhesion.value : undefined;
                  }));
}

}  // namespace setae::loops
