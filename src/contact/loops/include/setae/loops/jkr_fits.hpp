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

/// Samples of one branch in the order they were taken, force counted from the baseline, and how noisy they are (0 =
/// unknown).
struct BranchData {
    Array1D force;           ///< [N]
    Array1D displacement;    ///< [m], empty where not measured
    Array1D contact_radius;  ///< [m], empty where not measured; > 0
    double force_noise = 0.0;
    double displacement_noise = 0.0;
    double force_displacement_covariance = 0.0;
    double contact_radius_noise = 0.0;
    /// Independent errors of the zero that forces are counted from [N]: samples × modes, each of one standard
    /// deviation.
    Array2D force_zero_modes{};
    double compliance = 0.0;  ///< of the machine, whose deflection was taken off the displacement [m/N]

    /// The same with another zero: forces higher by so much, displacements less by what the machine deflects under it.
    [[nodiscard]] BranchData with_higher_force(const Eigen::Ref<const Array1D>& shift) const;
};

/// Least-squares estimate of E* and W by one of several routes.
///
/// Standard errors and covariance are scaled by the scatter of the residuals themselves and allow for residuals that
/// follow their neighbours, as autoregressive; where fewer than about ten independent ones are left (n over
/// `correlated_samples`) they are still too small. `chi2_reduced` compares that scatter with the noise of free flight,
/// so that a value far above 1 says that the model, not the noise, makes the residuals. W >= 0: where a contact is
/// smaller than Hertz's, W is 0 with the error that it would have, and its interval begins at 0.
struct JkrFit {
    std::string
        method;  ///< "radius_force", "radius_force_effective_variance", "linear_form", "force_displacement", "joint"
    bool converged = false;  ///< and the data determine the unknowns: covariance defined
    int iterations = 0;
    Estimate contact_modulus;   ///< E* [Pa]
    Estimate youngs_modulus;    ///< E of the soft body [Pa]; NaN where E* exceeds what the counter-body allows
    Estimate work_of_adhesion;  ///< W [J/m²]
    Estimate contact_point;     ///< δ at first touch [m]; NaN where the method has none
    std::optional<Estimate> unbounded_work{};  ///< W < 0 at which the sum of squares is least, where it is
    Eigen::MatrixXd covariance;                ///< of E*, W and, where fitted, the contact point
    double correlation = 0.0;                  ///< of E* and W
    double correlated_samples = 1.0;  ///< τ = 1 + 2 Σ ρ_k of the residuals: n/τ of them count as independent
    Index n = 0;
    Array1D residuals;               ///< measured − fitted, in `residual_unit`
    std::string residual_unit;       ///< "m"; "N" with effective variance, "N/m^1.5" for the linear form
    Array1D depth_residuals;         ///< [m], of the joint fit, beside its residuals of force; empty for the others
    double rms_residual = 0.0;       ///< in `residual_unit`
    double relative_residual = 0.0;  ///< rms residual over the range of the fitted quantity
    double chi2_reduced = 0.0;       ///< NaN where the noise is unknown
    /// Whether noise alone can make the residuals: not where χ²_red > 4 and neighbours are correlated by more than 1/2.
    /// Nothing where the noise is unknown.
    std::optional<bool> within_noise{};
    RunsTest runs;  ///< of the residuals' signs
};

/// Which errors the fit of a(F) allows for.
enum class RadiusErrors {
    radius_only,         ///< ordinary least squares in a
    effective_variance,  ///< each residual, taken in force, weighed by σ_F² + (dF/da)² σ_a², slopes at the fitted
                         ///< radius
};

/// Eq. (1): contact radius against force, nonlinear least squares in a; unknown E* and W.
///
///   a³ = (3R/4E*) [F + 3πRW + √(6πRWF + (3πRW)²)]
///
/// Forces below the fitted pull-off keep the radius at pull-off. With W near 0 and noise of force, least squares in a
/// alone is biased and too sure of itself; effective variance is not. With errors in both, each sample has a true
/// radius that is fitted too, see fit_joint; where the noise is large against the curve's bend, neighbours are averaged
/// first.
///
/// Measured, 800 fits to 1000 samples of a branch from jump-in or to pull-off, largest radius and range of force over
/// σ_a and σ_F 5, 10, 30, 100: the 95 % intervals of E* and W cover 93–96 %.
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

/// Which errors the fit of δ(F) allows for.
enum class DepthErrors {
    depth_only,          ///< ordinary least squares in δ
    effective_variance,  ///< distances from the curve in units of the noise of both, σ_Fδ included, where it is known
};

/// Displacement against force, nonlinear least squares in depth; unknown E*, W and the contact point.
///
///   δ = a²/R − √(2πaW/E*) + δ0,  a = a(F) by (1)
///
/// In `depth_only`, forces below the fitted pull-off keep the depth at pull-off, and starts are found by a scan over W,
/// in which E* and δ0 are linear. Effective variance, taken where the noise of both is known, goes on through the fold,
/// see fit_joint; of its two minima, which lie on either side of W = 0 where W is hardly known, that of W > 0 is
/// preferred.
///
/// Measured as for fit_radius_force: intervals cover 90–97 %. They are too short where W is not told from 0 (its error
/// larger than itself): those of E* then cover 73–92 %; take the joint fit.
/// @throws UndefinedDataError for fewer than 4 samples, no displacement, or a displacement that falls as the force
/// rises; InvalidArgument for R <= 0.
[[nodiscard]] JkrFit fit_force_displacement(const BranchData& data, const LensAndCounterBody& bodies,
                                            DepthErrors errors = DepthErrors::effective_variance);

/// Force, displacement and contact radius together; unknown E*, W and the contact point.
///
///   F = 4E*a³/(3R) − √(8πE*W a³),  δ = a²/R − √(2πaW/E*) + δ0
///
/// Each sample has a true contact radius, which is fitted too: the sum of squared distances from (F, δ, a) to that
/// curve in units of the noise is least. To first order this is the pair (F − F(a), δ − δ(a) − δ0) weighed by the
/// inverse of its covariance diag(σ_F², σ_δ²) + σ_Fδ + σ_a² g gᵀ, g = (F'(a), δ'(a)); but it does not take the measured
/// a for the true one, which would pull E* and W towards 0, and the mean offset that noise along a curved line makes is
/// taken off. Residuals are those of the pair; their covariance has an autoregressive process for each of the two
/// series and their correlation at the same sample. Measured as for fit_radius_force: intervals cover 92–96 %.
/// @throws UndefinedDataError for fewer than 4 samples or a channel that was not measured; InvalidArgument for R <= 0
/// and where the noise of a channel is unknown. Source: Britt, Luecke, Technometrics 15 (1973) 233; Amemiya, Fuller,
/// Ann. Stat. 16 (1988) 147.
[[nodiscard]] JkrFit fit_joint(const BranchData& data, const LensAndCounterBody& bodies);

/// Contact modulus from F, δ and a without W: F = 2aE* (δ − δ0 − a²/(3R)) is linear in E* and E*δ0.
struct PointwiseModulus {
    Estimate contact_modulus;   ///< slope [Pa]
    Estimate youngs_modulus;    ///< [Pa]
    Estimate contact_point;     ///< δ0 [m]
    Array1D pointwise;          ///< E* of each sample with that δ0 [Pa]; NaN where the bracket vanishes
    double rms_residual = 0.0;  ///< of F/(2a) [N/m]
    double relative_residual = 0.0;
    Index n = 0;
};

/// @throws UndefinedDataError for fewer than 3 samples, or without displacement or contact radius.
[[nodiscard]] PointwiseModulus fit_pointwise_modulus(const BranchData& data, const LensAndCounterBody& bodies);

/// Energy release rate along a branch.
struct EnergyReleaseRate {
    Array1D contact_radius;       ///< [m], measured, else implied by F, δ and E*
    Array1D energy_release_rate;  ///< G [J/m²]
    Array1D standard_error;  ///< of G from the noise of the sample's own channels [J/m²]; NaN where that is unknown
    Array1D systematic;  ///< of G from E* (and the contact point, where a is implied), common to all samples [J/m²]
    bool radius_measured = false;
};

/// G = (4E*a³/3R − F)²/(8πE*a³) at each sample, with E* and contact point given.
[[nodiscard]] EnergyReleaseRate energy_release_rates(const BranchData& data, double radius, double contact_modulus,
                                                     double contact_point);

/// The same with its band. With a measured, F and a carry the noise; with a implied, F and δ, σ_Fδ included.
///
///   σ_G² = Σ (∂G/∂x_i)(∂G/∂x_j) Cov(x_i, x_j);  systematic² = (∂G/∂E* σ_E*)² + (∂G/∂δ0 σ_δ0)²
///
/// The two add in quadrature for one G; of differences along the branch the systematic one largely drops out.
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
