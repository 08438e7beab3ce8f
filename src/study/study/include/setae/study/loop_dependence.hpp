// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/traced_value.hpp"
#include "setae/loops/shared_inputs.hpp"
#include "setae/study/study.hpp"

namespace setae::study {

/// Numbers measured from one loop, or their derivatives by one input; NaN where the loop has none.
struct LoopNumbers {
    double contact_modulus = undefined;  ///< E* of the primary fit of loading [Pa]
    double youngs_modulus = undefined;   ///< E of that fit [Pa]
    double approach = undefined;         ///< W of that fit [J/m²]
    double pull_off = undefined;         ///< W by Eq. S1 [J/m²]
    double retraction = undefined;       ///< W by Eq. S2 [J/m²]
    double loss = undefined;             ///< E_loss [J]
    double contact_area = undefined;     ///< π a_max² at the largest force [m²]
};

[[nodiscard]] LoopNumbers numbers_of(const loops::ContactAnalysis& contact);

/// An input of a loop that is known with a standard error.
struct UncertainInput {
    loops::SharedInput input;
    std::string name;  ///< name by which other values share it
    Estimate value;
};

/// The uncertain inputs of an experiment: for the sphere its own radius, else that of its elastomer.
[[nodiscard]] std::vector<UncertainInput> uncertain_inputs(const ExperimentInput& experiment,
                                                           const ElastomerInput& elastomer);

/// Calibration factors of the experiment's record.
[[nodiscard]] loops::Calibration calibration_of(const ExperimentInput& experiment);

/// The name of an input, else the given one.
[[nodiscard]] std::string input_name(const Estimate& input, const std::string& otherwise);

/// ∂number/∂input [unit/unit of the input], input by input, by loops::InputDerivative. NaN where it cannot be found.
[[nodiscard]] std::vector<LoopNumbers> derivatives_of(const loops::Loop& recorded,
                                                      const loops::LensAndCounterBody& bodies,
                                                      const loops::AnalysisOptions& options,
                                                      const loops::LoopAnalysis& analysis,
                                                      const std::vector<UncertainInput>& inputs);

/// Contributions of inputs that loops share to the numbers of one loop: ∂number/∂input × standard error, by input. The
/// loop's own noise is not included; it is in the numbers' own standard errors, which do not include the inputs.
struct LoopDependence {
    Components contact_modulus;                 ///< [Pa]
    Components youngs_modulus;                  ///< [Pa]
    Components approach, pull_off, retraction;  ///< [J/m²]
    Components loss;                            ///< [J]
    Components contact_area;                    ///< [m²]
    std::vector<std::string> lost;              ///< a sentence for each number whose derivative could not be found
};

[[nodiscard]] LoopDependence dependence_of(const LoopNumbers& numbers, const std::vector<UncertainInput>& inputs,
                                           const std::vector<LoopNumbers>& derivatives);

/// Own noise of one fit in E and W, which are correlated: two directions, the first along E.
///
///   E: (σ_E, 0),  W: (ρ σ_W, √(1 − ρ²) σ_W)
///
/// ρ of E* and W. Empty directions where a standard error is not known.
struct FitNoise {
    Component youngs_modulus, work_of_adhesion;
};
[[nodiscard]] FitNoise fit_noise_of(const loops::JkrFit& fit);

/// Effect of this noise on the contact area at a force, which is that of the fitted curve (Eq. 1).
///
///   ∂A/∂E = (1 − ν²)(E*/E)² ∂A/∂E*,  ∂A/∂W: central differences over the standard errors
[[nodiscard]] Component area_noise_of(const loops::JkrFit& fit, const loops::LensAndCounterBody& bodies, double force);

/// "fit of FILE": the input that E of an elastomer and W of a pair share where both come from the same fit.
[[nodiscard]] std::string fit_name(const std::string& file);

/// "E of NAME, loops": additional scatter of E between the loops on an elastomer.
[[nodiscard]] std::string loops_name(const std::string& elastomer);

/// The own noise of a mean of loops beyond the weighted noise of its fits: scatter of the loops. Variance of the mean
/// minus that of the fits, >= 0; degrees of freedom so that all together have those of the mean.
[[nodiscard]] Component beyond_fits(const Estimate& mean, const Components& fits);

}  // namespace setae::study
