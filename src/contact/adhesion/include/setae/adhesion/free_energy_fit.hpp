// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"
#include "setae/adhesion/pair_point.hpp"

namespace setae::adhesion {

/// A pair for the bound below: prediction max(0, r W − γ1 (r − 1) − E* u).
struct FreeEnergyPoint {
    PairPoint pair;               ///< slope r, offset γ1 (r − 1): without stored energy
    TracedValue contact_modulus;  ///< E* [Pa]

    /// The pair with a stored energy of u E* per area of the surface; u [m].
    [[nodiscard]] PairPoint storing(double energy_per_modulus) const;
};

/// Stored energy of a surface divided by E*, independent of the spectrum.
struct FreeEnergy {
    std::string surface;
    Estimate energy_per_modulus;  ///< u [m], >= 0
};

/// W and every u with the covariance of all errors.
struct GeneralisedFreeEnergies {
    TracedValue traced_work_of_adhesion;  ///< W with all its inputs
    Estimate work_of_adhesion;            ///< [J/m²], >= 0
    std::vector<FreeEnergy> energies;
    ModelScatter scatter;
    double r_squared = 0.0;
    double log_likelihood = 0.0;  ///< log-likelihood as in GeneralisedFit
    int n = 0, parameters = 0;
};

/// Best possible fit for any power spectral density: the full-contact balance (Eq. 7) with U_el/(A E*) = u free, >= 0,
/// for each surface.
struct FreeEnergyFit {
    double work_of_adhesion = 0.0;  ///< W by least squares with equal weights
    double r_squared = 0.0;
    std::vector<std::pair<std::string, double>> energy_per_modulus;  ///< u by surface [m]
    std::optional<GeneralisedFreeEnergies> generalised;
};

/// Least squares with equal weights. @throws InvalidArgument for fewer than two pairs.
[[nodiscard]] FreeEnergyFit fit_with_free_energies(const std::vector<FreeEnergyPoint>& pairs);

/// The fit by generalised least squares, from a start near the solution:
///
///   minimise (y − f(θ))ᵀ V⁻¹ (y − f(θ)),   θ = (W, u_1, u_2, …) >= 0
///
/// V as in fit_generalised(), without effects of surfaces, which the u represent. Parameters at 0 do not enter the
/// errors of the others. An interval has a lower end of at least 0; that of a parameter at 0 is one-sided,
/// 0 to U, where with t = (x̂ − U)/s the probability T(t) is 5 % of T(x̂/s): x̂ ± s is the result of the fit without
/// its floor, T is Student's distribution. It covers every x in at least 95 % of all cases, and equals the two-sided
/// one at x̂ = 0. A surface whose pairs are all at their floor keeps its u, without an error. Absent where there are
/// not more pairs than parameters, or where the pairs do not determine the parameters. Source: Read, J. Phys. G 28
/// (2002) 2693 (limits by CL_s); JCGM 102:2011.
[[nodiscard]] std::optional<GeneralisedFreeEnergies> fit_free_energies_generalised(
    const std::vector<FreeEnergyPoint>& pairs, const FreeEnergyFit& start);

}  // namespace setae::adhesion
