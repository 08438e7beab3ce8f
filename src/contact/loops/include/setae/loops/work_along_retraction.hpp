// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "setae/fields/describe.hpp"
#include "setae/loops/jkr_fits.hpp"

namespace setae::loops {

/// W_ret as a straight line in the contact radius, from the largest contact to pull-off.
///
/// W_ret(a) = W_po + s (a − a_po), a_po <= a <= a_max
///
/// a_po: radius where the force is smallest. A contact that remains below it follows the same line.
struct WorkAlongRetraction {
    Estimate at_pull_off;          ///< W_po, at the smallest contact radius before pull-off [J/m²]
    Estimate at_largest_contact;   ///< W_ret(a_max) [J/m²]
    Estimate slope;                ///< s [J/m³]; > 0: W_ret decreases as the contact shrinks
    double smallest_radius = 0.0;  ///< a_po [m]
    double largest_radius = 0.0;   ///< a_max [m]
    Index n = 0;
    double rms_residual = 0.0;      ///< measured G − W_ret(a) [J/m²]
    double chi2_reduced = 0.0;      ///< NaN where the noise is unknown
    Estimate energy_loss;           ///< ∮F dδ [J] of a loop with W_app on approach and this W_ret on retraction
    Estimate energy_loss_constant;  ///< the loss with W_po during the whole retraction [J]
};

struct RetractionCourse {
    double radius = 0.0;       ///< R [m], > 0
    Estimate contact_modulus;  ///< E* of loading [Pa], > 0; that of the retraction would include the variation of W_ret
    Estimate work_approach;    ///< W_app of loading [J/m²], >= 0
    double largest_contact_radius = 0.0;                                 ///< a_max [m], > 0
    double machine_stiffness = std::numeric_limits<double>::infinity();  ///< [N/m], > 0; infinite: fixed grips
};

/// Line through the energy release rates G(a) of a retracting edge, G = (4E*a³/3R − F)²/(8πE*a³): the edge of an
/// elastic contact retracts at G = W_ret.
///
/// Each sample is weighted by σ² = (∂G/∂F σ_F)² + (∂G/∂a − s)² σ_a², with equal weights where the noise is unknown. The
/// standard errors include the scatter of the residuals, which may be correlated, the zero of force, E* and, for the
/// losses, W_app. An edge whose W_ret depends on its speed has a slope, too: fit_crack_speed() distinguishes the two.
///
/// ∮F dδ = E_jump in + U_E(a_out) + F_out²/2k + ∫ W_ret dA − W_app A_max, A from a_out to a_max
///
/// a_out: radius at which d(δ + F/k)/da = 0 on the line, where the contact separates; U_E = E*(δ²a − 2/3 δa³/R +
/// a⁵/5R²). @throws InvalidArgument for R, E*, a_max or k <= 0; UndefinedDataError without measured contact radius, for
/// fewer than 8 samples, or where these cover less than 5 % of a_max, and where the line falls below 0. Source: Maugis,
/// Contact, Adhesion and Rupture of Elastic Solids (2000), ch. 4; loss: energy balance.
[[nodiscard]] WorkAlongRetraction fit_work_along_retraction(const BranchData& retraction,
                                                            const RetractionCourse& course);

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::WorkAlongRetraction> {
    using T = loops::WorkAlongRetraction;
    static constexpr std::array rows{
        quantity<&T::at_pull_off>("work_at_pull_off", "W_ret(a_po)", "J/m2", "W_ret at the smallest contact radius"),
        quantity<&T::at_largest_contact>("work_at_largest_contact", "W_ret(a_max)", "J/m2",
                                         "W_ret at the largest contact radius"),
        made<T>("slope", "dW_ret/da", "J/m3", "slope dW_ret/da; above 0, W_ret decreases as the contact shrinks",
                [](const T& of) { return with_count(of.n, of.slope); })
            .as("retraction_work_slope")
            .from("line through G(a) = (4E*a^3/3R - F)^2/(8 pi E* a^3) of the retracting edge"),
        quantity<&T::smallest_radius>("smallest_contact_radius", "a_po", "m", "a_po"),
        quantity<&T::largest_radius>("largest_contact_radius", "a_max", "m", "a_max"),
        quantity<&T::rms_residual>("rms_residual", "rms", "J/m2", "root mean square of the measured G minus the line")
            .as("rms_residual_of_work"),
        field<&T::chi2_reduced>("chi_squared_reduced", "χ² per degree of freedom; null where the noise is unknown"),
        quantity<&T::energy_loss>("energy_loss", "E_loss", "J",
                                  "∮F dδ of a loop with W_app on approach and this W_ret on retraction"),
        quantity<&T::energy_loss_constant>(
            "energy_loss_constant_work", "E_loss", "J",
            "∮F dδ of a loop with W_app on approach and W_ret at pull-off during the whole retraction"),
        inner<&T::slope>(),
        inner<&T::n>(),
    };
    static constexpr Description description{"work_along_retraction",
                                             "linear W_ret(a) from the largest contact to pull-off", rows};
};
static_assert(complete<loops::WorkAlongRetraction>);

}  // namespace setae::fields
