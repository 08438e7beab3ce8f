// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "setae/core/units.hpp"
#include "setae/fields/describe.hpp"
#include "setae/fields/thinned.hpp"
#include "setae/loops/loop.hpp"
#include "setae/loops/runs_test.hpp"

namespace setae::loops {

/// Samples of one branch in the order of recording, force relative to the baseline, and their noise (0 = unknown).
struct BranchData {
    Array1D force;           ///< [N]
    Array1D displacement;    ///< [m], empty where not measured
    Array1D contact_radius;  ///< [m], empty where not measured; > 0
    double force_noise = 0.0;
    double displacement_noise = 0.0;
    double force_displacement_covariance = 0.0;
    double contact_radius_noise = 0.0;
    /// Independent errors of the zero of force [N]: samples × modes, each of one standard deviation.
    Array2D force_zero_modes{};
    /// compliance of the testing machine, whose deflection was subtracted from the displacement [m/N]
    double compliance = 0.0;

    /// The branch with another zero: forces higher by this amount, displacements smaller by the deflection of the
    /// testing machine under it.
    [[nodiscard]] BranchData with_higher_force(const Eigen::Ref<const Array1D>& shift) const;
};

/// Least-squares estimate of E* and W by one of several routes.
///
/// Standard errors and covariance are scaled by the scatter of the residuals and take autoregressive correlations of
/// residuals into account; where fewer than about ten independent residuals are left (n divided by
/// `correlated_samples`) they are still too small. `chi2_reduced` compares that scatter with the noise of free flight:
/// a value far above 1 means that residuals are due to the model, not to noise. W >= 0: where a contact is smaller than
/// Hertz's, W is 0 with the error that it would have, and its interval begins at 0.
struct JkrFit {
    std::string
        method;  ///< "radius_force", "radius_force_effective_variance", "linear_form", "force_displacement", "joint"
    /// whether the iteration converged and the data determine the unknowns: covariance defined
    bool converged = false;
    int iterations = 0;
    Estimate contact_modulus;   ///< E* [Pa]
    Estimate youngs_modulus;    ///< E of the soft body [Pa]; NaN where E* exceeds the limit of the counter-body
    Estimate work_of_adhesion;  ///< W [J/m²]
    Estimate contact_point;     ///< δ at first contact [m]; NaN where the method has none
    std::optional<Estimate> unbounded_work{};  ///< W < 0 with the smallest sum of squares, where it exists
    Eigen::MatrixXd covariance;                ///< covariance of E*, W and, where fitted, the contact point
    double correlation = 0.0;                  ///< correlation of E* and W
    double correlated_samples = 1.0;           ///< τ = 1 + 2 Σ ρ_k of the residuals: n/τ of them are independent
    Index n = 0;
    Array1D residuals;          ///< measured − fitted, in `residual_unit`
    std::string residual_unit;  ///< "m"; "N" with effective variance, "N/m^1.5" for the linear form
    Array1D depth_residuals;    ///< [m], for the joint fit, in addition to its residuals of force; empty for the others
    double rms_residual = 0.0;  ///< in `residual_unit`
    double relative_residual = 0.0;  ///< rms residual divided by the range of the fitted quantity
    double chi2_reduced = 0.0;       ///< NaN where the noise is unknown
    /// Whether noise explains the residuals: false where χ²_red > 4 and neighbours are correlated by more than 1/2.
    /// Empty where the noise is unknown.
    std::optional<bool> within_noise{};
    RunsTest runs;  ///< test of the residuals' signs
};

/// Errors in the fit of a(F).
enum class RadiusErrors {
    radius_only,         ///< ordinary least squares in a
    effective_variance,  ///< each residual, in force, weighted by σ_F² + (dF/da)² σ_a², slopes at the fitted radius
};

/// Eq. 1: contact radius against force, nonlinear least squares in a; unknown E* and W.
///
///   a³ = (3R/4E*) [F + 3πRW + √(6πRWF + (3πRW)²)]
///
/// Forces below the fitted pull-off have the radius at pull-off. With W near 0 and noise of force, least squares in a
/// only is biased and its intervals are too narrow; effective variance is not. With errors in both, each sample has a
/// true radius that is fitted too, see fit_joint; where the noise is large compared with the curvature of the curve,
/// neighbours are averaged first.
///
/// Measured, 800 fits to 1000 samples of a branch from jump-in or to pull-off, largest radius and range of force
/// divided by σ_a and σ_F 5, 10, 30, 100: the 95 % intervals of E* and W cover 93–96 %.
/// @throws UndefinedDataError for fewer than 3 samples or no contact radius; InvalidArgument for R <= 0 and for
/// effective variance without the noise of both.
/// Source: Johnson, Kendall, Roberts 1971; effective variance: Orear, Am. J. Phys. 50 (1982) 912.
[[nodiscard]] JkrFit fit_radius_force(const BranchData& data, const LensAndCounterBody& bodies,
                                      RadiusErrors errors = RadiusErrors::radius_only);

/// The same model as a straight line, K = 4E*/3:
///
///   F/√(6πa³) = K a^(3/2)/(√(6π) R) − √(KW)
///
/// Errors of a enter both sides, which biases it where they are large.
/// @throws as fit_radius_force.
[[nodiscard]] JkrFit fit_linear_form(const BranchData& data, const LensAndCounterBody& bodies);

/// Errors in the fit of δ(F).
enum class DepthErrors {
    depth_only,          ///< ordinary least squares in δ
    effective_variance,  ///< distances from the curve in units of the noise of both, σ_Fδ included, where it is known
};

/// Displacement against force, nonlinear least squares in depth; unknown E*, W and the contact point.
///
///   δ = a²/R − √(2πaW/E*) + δ0,  a = a(F) by Eq. 1
///
/// In `depth_only`, forces below the fitted pull-off have the depth at pull-off, and starts are found by a scan over W,
/// in which E* and δ0 are linear. Effective variance, used where the noise of both is known, continues through the
/// fold, see fit_joint; of its two minima, which lie on either side of W = 0 where W is poorly determined, that of W >
/// 0 is preferred.
///
/// Measured as for fit_radius_force: intervals cover 90–97 %. They are too short where W cannot be distinguished from 0
/// (its error larger than itself): those of E* then cover 73–92 %; use the joint fit.
/// @throws UndefinedDataError for fewer than 4 samples, no displacement, or a displacement that decreases as the force
/// increases; InvalidArgument for R <= 0.
[[nodiscard]] JkrFit fit_force_displacement(const BranchData& data, const LensAndCounterBody& bodies,
                                            DepthErrors errors = DepthErrors::effective_variance);

/// Force, displacement and contact radius together; unknown E*, W and the contact point.
///
///   F = 4E*a³/(3R) − √(8πE*W a³),  δ = a²/R − √(2πaW/E*) + δ0
///
/// Each sample has a true contact radius, which is fitted too: the sum of squared distances from (F, δ, a) to that
/// curve in units of the noise is minimised. To first order this is the pair (F − F(a), δ − δ(a) − δ0) weighted by the
/// inverse of its covariance diag(σ_F², σ_δ²) + σ_Fδ + σ_a² g gᵀ, g = (F'(a), δ'(a)). Using the measured a as the true
/// one would bias E* and W towards 0; the mean offset from noise along a curved line is subtracted. Residuals are those
/// of the pair; their covariance has an autoregressive process for each of the two series and their correlation at the
/// same sample. Measured as for fit_radius_force: intervals cover 92–96 %. @throws UndefinedDataError for fewer than 4
/// samples or a channel that was not measured; InvalidArgument for R <= 0 and where the noise of a channel is unknown.
/// Source: Britt, Luecke, Technometrics 15 (1973) 233; Amemiya, Fuller, Ann. Stat. 16 (1988) 147.
[[nodiscard]] JkrFit fit_joint(const BranchData& data, const LensAndCounterBody& bodies);

/// Contact modulus from F, δ and a without W: F = 2aE* (δ − δ0 − a²/(3R)) is linear in E* and E*δ0.
struct PointwiseModulus {
    Estimate contact_modulus;   ///< slope [Pa]
    Estimate youngs_modulus;    ///< [Pa]
    Estimate contact_point;     ///< δ0 [m]
    Array1D pointwise;          ///< E* of each sample with that δ0 [Pa]; NaN where the bracket vanishes
    double rms_residual = 0.0;  ///< rms of F/(2a) [N/m]
    double relative_residual = 0.0;
    Index n = 0;
};

/// @throws UndefinedDataError for fewer than 3 samples, or without displacement or contact radius.
[[nodiscard]] PointwiseModulus fit_pointwise_modulus(const BranchData& data, const LensAndCounterBody& bodies);

/// Energy release rate along a branch.
struct EnergyReleaseRate {
    Array1D contact_radius;       ///< [m], measured, else computed from F, δ and E*
    Array1D energy_release_rate;  ///< G [J/m²]
    /// standard error of G from the noise of the sample's own channels [J/m²]; NaN where that is unknown
    Array1D standard_error;
    Array1D systematic;  ///< error of G from E* (and the contact point, for a computed a), common to all samples [J/m²]
    bool radius_measured = false;
};

/// G = (4E*a³/3R − F)²/(8πE*a³) at each sample, with E* and contact point given.
[[nodiscard]] EnergyReleaseRate energy_release_rates(const BranchData& data, double radius, double contact_modulus,
                                                     double contact_point);

/// G with its errors. With a measured, F and a have noise; with a computed, F and δ, including σ_Fδ.
///
///   σ_G² = Σ (∂G/∂x_i)(∂G/∂x_j) Cov(x_i, x_j);  systematic² = (∂G/∂E* σ_E*)² + (∂G/∂δ0 σ_δ0)²
///
/// The two add in quadrature for one G; in differences along the branch the systematic error largely cancels.
[[nodiscard]] EnergyReleaseRate energy_release_rates(const BranchData& data, double radius,
                                                     const Estimate& contact_modulus, const Estimate& contact_point);

/// Young's modulus of the soft body with its standard error, from E*; NaN where the counter-body is too soft for it.
[[nodiscard]] Estimate youngs_modulus(const Estimate& contact_modulus, const LensAndCounterBody& bodies);

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::JkrFit> {
    using T = loops::JkrFit;
    static constexpr std::array moduli_rows{
        made<T>("contact_modulus", "E*", "Pa", "E*", [](const T& of) { return with_count(of.n, of.contact_modulus); }),
        made<T>("youngs_modulus", "E", "Pa", "E", [](const T& of) { return with_count(of.n, of.youngs_modulus); }),
        made<T>("work_of_adhesion", "W", "J/m2", "W",
                [](const T& of) { return with_count(of.n, of.work_of_adhesion); }),
    };
    static constexpr Description moduli{"", "E*, E and W of a fit", moduli_rows};
    static constexpr std::array rows{
        field<&T::method>("method", "route of the fit"),
        field<&T::converged>("converged", "whether the iteration converged"),
        fields_of<T>(moduli, [](const T& of) -> const T& { return of; }),
        made<T>("contact_point", "delta0", "m", "δ0",
                [](const T& of) {
                    return std::isnan(of.contact_point.value) ? std::nullopt : std::optional(of.contact_point);
                }),
        field<&T::correlation>("correlation", "correlation of the two parameters"),
        field<&T::correlated_samples>(
            "correlated_samples",
            "number of samples that correspond to one independent sample, because neighbouring residuals "
            "are correlated"),
        field<&T::covariance>("covariance", "covariance of the parameters"),
        field<&T::n>("n", "number of points, measurements or pairs"),
        field<&T::within_noise>(
            "within_noise",
            "whether noise explains the residuals: false where χ²_red > 4 and neighbouring residuals are "
            "correlated; null where the noise is unknown")
            .or_null(),
        quantity<&T::unbounded_work>("unbounded_work_of_adhesion", "W", "J/m2",
                                     "W below 0 with the smallest sum of squares, where it exists; W is 0 then"),
        field<&T::chi2_reduced>("chi_squared_reduced", "χ² divided by the degrees of freedom"),
        made<T>("rms_residual", "rms", "", "root mean square residual",
                [](const T& of) { return Quantity{.estimate = {.value = of.rms_residual}, .unit = of.residual_unit}; }),
        field<&T::relative_residual>("relative_residual", "rms residual divided by the rms of the fitted values"),
        made<T>("residuals", "measured minus fitted values", [](const T& of) { return thinned(of.residuals); }),
        made<T>("depth_residuals", "residuals of the displacement",
                [](const T& of) { return thinned(of.depth_residuals); })
            .with(Missing::left_out),
        made<T>("residuals_every",
                "step between the samples whose residuals are given, for more than 20 000 samples; absent "
                "where all residuals are given",
                [](const T& of) { return step_of(of.residuals.size()); }),
        field<&T::runs>("runs", "test of the signs of residuals"),
        inner<&T::iterations>(),
        inner<&T::contact_modulus>(),
        inner<&T::youngs_modulus>(),
        inner<&T::work_of_adhesion>(),
        inner<&T::contact_point>(),
        inner<&T::residuals>(),
        inner<&T::residual_unit>(),
        inner<&T::depth_residuals>(),
        inner<&T::rms_residual>(),
    };
    static constexpr Description description{"jkr_fit", "fit of JKR to a branch", rows};
};
static_assert(complete<loops::JkrFit>);

template <>
struct Described<loops::PointwiseModulus> {
    using T = loops::PointwiseModulus;
    static constexpr std::array rows{
        quantity<&T::contact_modulus>("contact_modulus", "E*", "Pa", "E*"),
        quantity<&T::youngs_modulus>("youngs_modulus", "E", "Pa", "E"),
        quantity<&T::contact_point>("contact_point", "delta0", "m", "δ0"),
        field<&T::n>("n", "number of points, measurements or pairs"),
        field<&T::relative_residual>("relative_residual", "rms residual divided by the rms of the fitted values"),
        inner<&T::pointwise>(),
        inner<&T::rms_residual>(),
    };
    static constexpr Description description{"", "E* of each single point", rows};
};
static_assert(complete<loops::PointwiseModulus>);

template <>
struct Described<loops::EnergyReleaseRate> {
    using T = loops::EnergyReleaseRate;
    static constexpr std::array rows{
        made<T>("contact_radius", "a", [](const T& of) { return thinned(of.contact_radius); }),
        made<T>("contact_radius_unit", "unit of the contact radii", [](const T&) { return "m"; }),
        made<T>("energy_release_rate", "energy release rate G at each point",
                [](const T& of) { return thinned(of.energy_release_rate); }),
        made<T>("standard_error", "standard error", [](const T& of) { return thinned(of.standard_error); }),
        made<T>("systematic", "change of G by an error of E*", [](const T& of) { return thinned(of.systematic); }),
        made<T>("energy_release_rate_unit", "unit of G", [](const T&) { return "J/m2"; }),
        field<&T::radius_measured>("contact_radius_measured",
                                   "whether the contact radius was measured; otherwise it is computed by JKR"),
        made<T>("every",
                "step between the points in the columns, for more than 20 000 points; absent where the "
                "columns contain all points",
                [](const T& of) { return step_of(of.contact_radius.size()); }),
        inner<&T::contact_radius>(),
        inner<&T::energy_release_rate>(),
        inner<&T::standard_error>(),
        inner<&T::systematic>(),
    };
    static constexpr Description description{"", "energy release rate G at each point", rows};
};
static_assert(complete<loops::EnergyReleaseRate>);

}  // namespace setae::fields
