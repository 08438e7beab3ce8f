// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// Inputs shared by all loops with one lens, camera or machine: their errors are common to these loops.
enum class SharedInput {
    sphere_radius,               ///< R [m]
    sphere_height,               ///< h of the soft lens, or of the soft layer [m]
    poisson_ratio,               ///< ν of the soft body
    machine_stiffness,           ///< stiffness k of the testing machine [N/m]
    force_calibration,           ///< true force divided by the force of the record, f
    displacement_calibration,    ///< true displacement divided by that of the record, d
    contact_radius_calibration,  ///< true contact radius divided by that of the record, c: the size of a pixel
};

/// Key of the input in a study: "sphere_radius".
[[nodiscard]] const char* shared_input_name(SharedInput input);

/// Factors of the channels of a record: true value = factor × value of the record.
struct Calibration {
    double force = 1.0;
    double displacement = 1.0;
    double contact_radius = 1.0;
};

[[nodiscard]] Loop calibrated(Loop recorded, const Calibration& factors);
/// Options in units of the record, converted: zero of force, contact point, drift of displacement, noise of radii.
[[nodiscard]] AnalysisOptions calibrated(AnalysisOptions options, const Calibration& factors);

/// Derivatives of the results of a loop's first contact by one of its inputs.
///
///   ∂y/∂x ≈ [y(x e^h) − y(x e^−h)]/(2hx),  h = 1e-3;  for ν in steps of 1e-3, one-sided to second order at 0 and 1/2
///
/// The record is analysed again at both values, with unchanged segments, pinned section and method of the contact
/// point. JKR's curve is self-similar, so that without height and machine stiffness, with ρ, f, d, c the factors on R,
/// force, displacement and contact radius, with measured radii
///
///   E* ∝ f ρ c⁻³,  W ∝ f/ρ,
///
/// from force and displacement E* ∝ f ρ^(−1/2) d^(−3/2), W ∝ f/ρ; Eqs. S1 and S2 W ∝ f/ρ; ∮F dδ ∝ f d. A height scales
/// with c, else with √(ρd), a machine stiffness with f/d. These relations apply to every estimate made here; the
/// differences cover records and options to which they do not apply.
class InputDerivative {
public:
    /// The record, bodies and options of `analysis`, which must outlive this. The bodies contain a sphere_height, the
    /// options a machine_stiffness.
    /// @throws InvalidArgument for an input that they do not contain; UndefinedDataError where the loop cannot be
    /// analysed at a neighbouring value.
    InputDerivative(const Loop& recorded, const LensAndCounterBody& bodies, const AnalysisOptions& options,
                    const LoopAnalysis& analysis, SharedInput input);

    /// ∂/∂x [1/unit of x] of a number; NaN where it is missing at a neighbouring value.
    [[nodiscard]] double of(const std::function<double(const ContactAnalysis&)>& number) const;

private:
    const ContactAnalysis& here_;
    std::array<ContactAnalysis, 2> beside_;
    std::array<double, 2> weights_{};  ///< weights of the differences at the two neighbouring values
};

/// Adds the contribution of an input with a standard error to the standard errors of a loop's numbers, including
/// covariances of fits; degrees of freedom stay those of the loop's own noise.
void add_input_error(LoopAnalysis& analysis, const LensAndCounterBody& bodies, const InputDerivative& derivative,
                     double standard_error);

}  // namespace setae::loops
