// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// What all loops measured with one lens, camera or machine share: an error of it is in every one of them.
enum class SharedInput {
    sphere_radius,               ///< R [m]
    sphere_height,               ///< h of the soft lens, or of the soft layer [m]
    poisson_ratio,               ///< ν of the soft body
    machine_stiffness,           ///< k of the machine [N/m]
    force_calibration,           ///< true force over what the record says, f
    displacement_calibration,    ///< likewise of displacement, d
    contact_radius_calibration,  ///< likewise of the contact radius, c: the size of a pixel
};

/// Its key in a study: "sphere_radius".
[[nodiscard]] const char* shared_input_name(SharedInput input);

/// What the channels of a record are multiplied by: true = factor × what the record says.
struct Calibration {
    double force = 1.0;
    double displacement = 1.0;
    double contact_radius = 1.0;
};

[[nodiscard]] Loop calibrated(Loop recorded, const Calibration& factors);
/// What options say in units of the record: zero of force, contact point, drift of displacement, noise of radii.
[[nodiscard]] AnalysisOptions calibrated(AnalysisOptions options, const Calibration& factors);

/// How fast numbers of a loop's first contact move with one of its inputs.
///
///   ∂y/∂x ≈ [y(x e^h) − y(x e^−h)]/(2hx),  h = 1e-3;  of ν in steps of 1e-3, one-sided to second order at 0 and 1/2
///
/// The record is analysed anew at both places, with segments, pinned stretch and the method of the contact point as
/// they are. JKR's curve is similar to itself, so that without height and machine stiffness, ρ, f, d, c the factors on
/// R, force, displacement and contact radius, with measured radii
///
///   E* ∝ f ρ c⁻³,  W ∝ f/ρ,
///
/// from force and displacement E* ∝ f ρ^(−1/2) d^(−3/2), W ∝ f/ρ; (S1) and (S2) W ∝ f/ρ; ∮F dδ ∝ f d. A height goes
/// with c, else with √(ρd), a machine stiffness with f/d. These laws hold for every estimate made here; the differences
/// are of records and options for which they do not tell all.
class InputDerivative {
public:
    /// The record, bodies and options of `analysis`, which must outlive this. Of sphere_height the bodies have one, of
    /// machine_stiffness the options.
    /// @throws InvalidArgument where the input is none of theirs; UndefinedDataError where the loop cannot be analysed
    /// with it a little off.
    InputDerivative(const Loop& recorded, const LensAndCounterBody& bodies, const AnalysisOptions& options,
                    const LoopAnalysis& analysis, SharedInput input);

    /// ∂/∂x [1/unit of x] of a number; NaN where a neighbour does not have it.
    [[nodiscard]] double of(const std::function<double(const ContactAnalysis&)>& number) const;

private:
    const ContactAnalysis& here_;
    std::array<ContactAnalysis, 2> beside_;
    std::array<double, 2> weights_{};  ///< of what the two beside differ from here
};

/// Adds to the standard errors of a loop's numbers, covariances of fits included, what the standard error of an input
/// they do not hold yet makes; degrees of freedom stay those of the loop's own noise.
void add_input_error(LoopAnalysis& analysis, const LensAndCounterBody& bodies, const InputDerivative& derivative,
                     double standard_error);

}  // namespace setae::loops
