// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "line_elasticity.hpp"
#include "pinning_lines.hpp"

namespace setae::crack_front {

/// Force that pulls a front back where > 0, and its derivative by the front:
///
///   H = diag(stiffness) + kernel · K − coupling_factor · coupling couplingᵀ
struct Balance {
    Array1D residual, stiffness, coupling;
    double kernel = 0.0;
    double coupling_factor = 0.0;  ///< 0: coupling is not there
};

/// A front x_j on lines that pin it, in a machine that drives it.
class FrontEquation {
public:
    FrontEquation(const PinningLines& pinning, LineElasticity& elasticity)
        : pinning_(pinning), elasticity_(elasticity) {}
    virtual ~FrontEquation() = default;
    FrontEquation(const FrontEquation&) = delete;
    FrontEquation& operator=(const FrontEquation&) = delete;

    [[nodiscard]] const PinningLines& pinning() const { return pinning_; }
    [[nodiscard]] LineElasticity& elasticity() const { return elasticity_; }

    /// The balance of a front whose points are in the given cells of their lines.
    void evaluate(const Array1D& front, const std::vector<Index>& cells, Balance& balance);

protected:
    /// Everything but the pinning; `bent` is K x. Sets all of the balance.
    virtual void elastic_part(const Array1D& front, const Array1D& bent, Balance& balance) = 0;
    /// Factor on the pinning of a line; 1 for most models.
    virtual void scale_pinning(const Array1D& /*front*/, Array1D& /*scale*/) {}

private:
    const PinningLines& pinning_;
    LineElasticity& elasticity_;
    Array1D bent_, scale_;
};

/// Where a search for equilibrium ends.
struct Equilibrium {
    double residual = 0.0;  ///< largest |residual|
    int iterations = 0;     ///< evaluations of the balance
    bool converged = false;
    bool left = false;  ///< a point left its line, at its beginning or end: there is no equilibrium on it
};

struct SearchLimits {
    double tolerance = 0.0;  ///< tolerance of the largest |residual|
    int max_iterations = 0;
    double largest_move = 0.0;  ///< largest move of a point in one step of the trust region
};

/// Points move in one direction only, each to its equilibrium position for fixed other points, and at most to the next
/// change of slope: since points pull each other along, none passes the first equilibrium, for any steps. Once no slope
/// changes any more the remainder is one linear solution.
/// Source: Rosso, Krauth, Phys. Rev. Lett. 87 (2001) 187002; no passing: Middleton, Phys. Rev. Lett. 68 (1992) 670.
Equilibrium rosso_krauth(FrontEquation& equation, Array1D& front, const SearchLimits& limits);

/// Newton steps by conjugate gradients, within the largest move and to it where the energy curves down, shorter where
/// the work along the step would be gained: like a front that moves slowly.
/// Source: Steihaug, SIAM J. Numer. Anal. 20 (1983) 626.
Equilibrium trust_region(FrontEquation& equation, Array1D& front, const SearchLimits& limits);

/// A step p with H p ≈ −residual. `stable`: no direction met along which the energy curves down; otherwise, and where
/// the step reached the largest move, it ends there.
struct NewtonStep {
    Array1D step;
    bool stable = true;
};
[[nodiscard]] NewtonStep newton_step(LineElasticity& elasticity, const Balance& balance, double largest_move,
                                     double accuracy);

}  // namespace setae::crack_front
