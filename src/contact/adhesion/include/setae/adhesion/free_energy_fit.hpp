// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "setae/adhesion/generalised_fit.hpp"
#include "setae/adhesion/pair_point.hpp"

namespace setae::adhesion {

/// A pair as the bound below sees it: prediction max(0, r W − γ1 (r − 1) − E* u).
struct FreeEnergyPoint {
    PairPoint pair;               ///< slope r, offset γ1 (r − 1): nothing stored
    TracedValue contact_modulus;  ///< E* [Pa]

    /// The pair where its surface stores u E* an area; u [m].
    [[nodiscard]] PairPoint storing(double energy_per_modulus) const;
};

/// What a surface stores over E*, free of its spectrum.
struct FreeEnergy {
    std::string surface;
    Estimate energy_per_modulus;  ///< u [m], >= 0
};

/// W and every u with the covariance of all errors.
struct GeneralisedFreeEnergies {
    TracedValue traced_work_of_adhesion;  ///< with every input it rests on
    Estimate work_of_adhesion;            ///< [J/m²], >= 0
    std::vector<FreeEnergy> energies;
    ModelScatter scatter;
    double r_squared = 0.0;
    double log_likelihood = 0.0;  ///< as that of GeneralisedFit
    int n = 0, parameters = 0;
};

/// The best any power spectral density could do: (7) with U_el/(A E*) = u free, >= 0, for each surface.
struct FreeEnergyFit {
    double work_of_adhesion = 0.0;  ///< least squares, every pair alike
    double r_squared = 0.0;
    std::vector<std::pair<std::string, double>> energy_per_modulus;  ///< u by surface [m]
    std::optional<GeneralisedFreeEnergies> generalised;
};

/// Least squares, every pair alike. @throws InvalidArgument for fewer than two pairs.
[[nodiscard]] FreeEnergyFit fit_with_free_energies(const std::vector<FreeEnergyPoint>& pairs);

/// The same by generalised least squares, from an answer that is near:
///
///   minimise (y − f(θ))ᵀ V⁻¹ (y − f(θ)),   θ = (W, u_1, u_2, …) >= 0
///
/// V as in fit_generalised(), without effects of surfaces: those are what the u are for. Parameters that are 0 take no
/// part in the errors of the others. An interval ends at 0 at the least; that of a parameter at 0 is one-sided,
/// 0 to U, where with t = (x̂ − U)/s the probability T(t) is 5 % of T(x̂/s): x̂ ± s what the fit gives without its
/// floor, T Student's distribution. It holds every x in 95 % of all cases or more, and meets the two-sided one at x̂ =
/// 0. A surface whose pairs are all at their floor keeps its u, without an error. Absent where pairs are not more than
/// parameters, or do not tell these apart. Source: Read, J. Phys. G 28 (2002) 2693 (limits by CL_s); JCGM 102:2011.
[[nodiscard]] std::optional<GeneralisedFreeEnergies> fit_free_energies_generalised(
    const std::vector<FreeEnergyPoint>& pairs, const FreeEnergyFit& start);

}  // namespace setae::adhesion
