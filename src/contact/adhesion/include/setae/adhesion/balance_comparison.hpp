// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/adhesion/free_energy_fit.hpp"
#include "setae/adhesion/pair_fit.hpp"

namespace setae::adhesion {

/// Agreement of one balance with the measured values of all pairs, with W_int fitted by least squares.
struct BalanceScore {
    int n = 0;                      ///< number of pairs
    int parameters = 1;             ///< number of fitted parameters
    double work_of_adhesion = 0.0;  ///< W_int [J/m²]
    double residual_squares = 0.0;  ///< Σ (measured − predicted)² [J²/m⁴]
    double r_squared = 0.0;         ///< 1 − SS_res/SS_tot
    double log_likelihood = 0.0;    ///< −n/2 ln(SS_res/n): Gaussian residuals of one unknown variance
    /// rms residual of each surface under the fit to the others [J/m²]; NaN where the balance predicts nothing for a
    /// surface that is left out
    double left_out_deviation = 0.0;
};

/// pairs: lines in W_int of one balance.
/// @throws InvalidArgument for fewer than two pairs.
[[nodiscard]] BalanceScore score_balance(const std::vector<PairPoint>& pairs);
[[nodiscard]] BalanceScore score_free_energies(const std::vector<FreeEnergyPoint>& pairs);

/// The balance with an interface whose energy changes as the soft side is stretched, linearly in its area:
///
///   W_app = W_int r − γ1 (r − 1) − χ r (r − 1) − U_el/A,   γ1s2 − γ12 = χ (r − 1)
///
/// W_int >= 0 and χ by least squares; errors from the residuals, n − 2 degrees of freedom.
struct StrainedInterfaceFit {
    Estimate work_of_adhesion;  ///< W_int [J/m²]
    Estimate interface_change;  ///< χ [J/m²]
    double correlation = 0.0;   ///< correlation of W_int and χ
    double r_squared = 0.0;
    double residual_squares = 0.0;
    int n = 0;
};

/// pairs: lines of the full-contact balance (Eq. 7), with slope r.
/// @throws InvalidArgument for fewer than three pairs, or where all have the same area ratio.
[[nodiscard]] StrainedInterfaceFit fit_strained_interface(const std::vector<PairPoint>& pairs);
[[nodiscard]] BalanceScore score_strained_interface(const std::vector<PairPoint>& pairs);

}  // namespace setae::adhesion
