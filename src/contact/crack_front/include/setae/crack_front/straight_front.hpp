// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "setae/crack_front/circular_front.hpp"

namespace setae::crack_front {

/// A straight front, limit of a circle large against everything along it.
struct StraightFrontOptions {
    double width = 0.0;      ///< L_z [m], > 0: lines are width/lines apart
    double restoring = 0.0;  ///< q_κ [1/m] of the spring that drives it; 0: π/L_z, G_J'/G_J of a circle of 2πa = L_z
    EquilibriumMethod method = EquilibriumMethod::trust_region;
    double tolerance = 1e-9;       ///< of the largest |residual| over W
    int most_iterations = 100000;  ///< of one equilibrium
    double largest_move = 0.5;     ///< of a point in one step of the trust region, in spacings of the field
};

/// A front x(z) on parallels, which its spring pulls to x_d.
///
///   W q_κ (x_j − x_d) + W (K x)_j = w(x_j, z_j) − W,   K: x̃_q → |q| x̃_q
///
/// The apparent work of adhesion is what the spring leaves, W (1 + q_κ (⟨x⟩ − x_d)) = ⟨w⟩ along the front. The field
/// repeats itself in both directions.
/// Source: Gao, Rice, J. Appl. Mech. 56 (1989) 828 (first-order elasticity of a front).
class StraightFront {
public:
    /// @throws InvalidArgument for a field, width or spring outside its domain.
    StraightFront(const WorkField& field, const StraightFrontOptions& options);
    ~StraightFront();
    StraightFront(StraightFront&&) noexcept;
    StraightFront& operator=(StraightFront&&) noexcept;

    /// x(z_j) [m]; straight at 0 to begin with.
    [[nodiscard]] const Array1D& front() const;

    struct State {
        double drive = 0.0;          ///< x_d [m]
        double position = 0.0;       ///< ⟨x⟩ [m]
        double roughness = 0.0;      ///< rms of x − ⟨x⟩ [m]
        double apparent_work = 0.0;  ///< [J/m²]
        double residual = 0.0;       ///< largest, over W
        int iterations = 0;
        bool converged = false;
    };
    State drive_to(double position);

private:
    class Work;
    std::unique_ptr<Work> work_;
};

/// Works with which a straight front grows and recedes in steady motion.
struct FrontWorks {
    double approach = 0.0;                                                  ///< W_appr [J/m²]
    double retraction = 0.0;                                                ///< W_ret [J/m²]
    double approach_standard_error = 0.0, retraction_standard_error = 0.0;  ///< from eight stretches of the way [J/m²]
    bool converged = false;

    /// k of W_ret − W_appr = 2k U_el/A. @param stored_energy U_el/A [J/m²].
    [[nodiscard]] double pinning_coefficient(double stored_energy) const {
        return 0.5 * (retraction - approach) / stored_energy;
    }
};

/// Drives a front over the field once and back, x_d in steps of `step` spacings, quasi-statically, and averages the
/// apparent work over the second half of the way of each.
/// @throws InvalidArgument as StraightFront does, and for a step that is not positive.
[[nodiscard]] FrontWorks straight_front_works(const WorkField& field, const StraightFrontOptions& options,
                                              double step = 0.5);

}  // namespace setae::crack_front
