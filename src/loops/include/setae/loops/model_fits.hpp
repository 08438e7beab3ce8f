// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/contact/tabor.hpp"
#include "setae/loops/jkr_fits.hpp"
#include "setae/loops/outcome.hpp"

namespace setae::loops {

/// Models of contact a branch can be fitted with; each is a header of module contact.
enum class ContactModel {
    hertz,           ///< no adhesion: E*
    dmt,             ///< adhesion of long range: E*, W
    jkr,             ///< adhesion of vanishing range: E*, W
    maugis_dugdale,  ///< adhesion of any range: E*, W, λ
    transition,  ///< Carpick–Ogletree–Salmeron: a0, Fc, α, from which E*, W, σ0; contact radius against force alone
    layer,       ///< JKR of a layer, its thickness from the bodies: E*, W
    large_strain,  ///< JKR of a sphere, contact radii comparable to R: E*, W
};

[[nodiscard]] const std::vector<ContactModel>& contact_models();

/// "hertz", "dmt", "jkr", "maugis_dugdale", "transition", "layer", "large_strain".
[[nodiscard]] std::string to_string(ContactModel model);

/// The model of that name. @throws InvalidArgument with the nearest name and all there are.
[[nodiscard]] ContactModel model_named(std::string_view name);

/// What of a branch is fitted; force always is.
enum class Channels {
    force_radius,               ///< (F, a)
    force_displacement,         ///< (F, δ)
    force_displacement_radius,  ///< (F, δ, a)
};

/// Those that a branch has. @throws UndefinedDataError for neither displacement nor contact radius.
[[nodiscard]] Channels channels_of(const BranchData& data);

/// Which errors the fit allows for. Every sample lies at an unknown t, the contact radius of a point of the curve.
enum class FitErrors {
    /// Σ (F − F(x))², x = a or δ + δ0 taken for exact: two channels only.
    force_only,
    /// Linear propagation at the measured radius: Σ rᵀC⁻¹r, r = (F − F(a), δ − δ(a) − δ0), C = TΣTᵀ, T = [1 0 −F'; 0 1
    /// −δ'],
    /// C renewed until the solution settles. Biased by F'' σ_a²/2, which shows where σ_a is some percent of the range.
    /// Without a
    /// measured radius the nearest point of the curve takes its place, and the result is that of orthogonal distance.
    effective_variance,
    /// Σ (F − F(t))²/σ_F² + (δ − δ(t) − δ0)²/σ_δ² + (a − t)²/σ_a², least over the parameters and all t.
    orthogonal_distance,
};
[[nodiscard]] std::string to_string(FitErrors errors);

struct ModelFitOptions {
    ContactModel model = ContactModel::jkr;
    std::optional<Channels> channels;  ///< else channels_of
    FitErrors errors = FitErrors::orthogonal_distance;
    std::optional<double> contact_point;         ///< δ0 [m] where known; else fitted
    std::optional<double> contact_modulus;       ///< E* [Pa] where known; not of the transition equation
    std::optional<double> work_of_adhesion;      ///< W [J/m²] where known; not of the transition equation
    std::optional<double> cohesive_stress;       ///< σ0 [Pa] of Maugis–Dugdale where known
    std::optional<double> transition_parameter;  ///< λ of Maugis–Dugdale where known; not both
    double interaction_range = 0.3e-9;  ///< z0 of the Tabor parameter [m] for models that have no range of their own
};

/// Noise a fit weighed its channels with: known, or read from their second differences.
struct ChannelNoise {
    double force = 0.0;                          ///< σ_F [N]
    double displacement = 0.0;                   ///< σ_δ [m]
    double contact_radius = 0.0;                 ///< σ_a [m]
    double force_displacement_covariance = 0.0;  ///< [N m]
    bool all_known = false;                      ///< else χ²_red says little about the model
};

/// Residuals of one channel at the nearest points of the curve, measured − fitted; empty where the channel was not
/// fitted.
struct ChannelResiduals {
    Array1D values;
    double rms = 0.0;
};

/// Least-squares estimate of a model's parameters from one branch.
///
/// Standard errors and covariance are scaled by the scatter of the residuals and allow for residuals that follow their
/// neighbours, as JkrFit's do; the error of the zero of force is added.
struct ModelFit {
    ContactModel model = ContactModel::jkr;
    Channels channels = Channels::force_radius;
    FitErrors errors = FitErrors::orthogonal_distance;
    bool converged = false;  ///< and the data determine all unknowns
    int iterations = 0;
    Estimate contact_modulus;  ///< E* [Pa]
    Estimate youngs_modulus;   ///< E of the soft body [Pa]; NaN where E* exceeds what the counter-body allows
    Outcome<Estimate>
        work_of_adhesion;  ///< W [J/m²]; none for Hertz and where it follows a λ that the data do not determine
    Outcome<Estimate> cohesive_stress;       ///< σ0 [Pa] of Maugis–Dugdale and transition, where determined
    Outcome<Estimate> transition_parameter;  ///< λ of the same
    Outcome<Estimate> transition_share;      ///< α of transition
    Outcome<Estimate> zero_load_radius;      ///< a0 [m] of transition
    Outcome<Estimate> pull_off_force;        ///< Fc [N] of transition
    Estimate contact_point;                  ///< δ0 [m]; NaN without displacement, without error where given
    std::vector<std::string>
        parameters;  ///< rows of the covariance: "contact_modulus", "work_of_adhesion", …, "contact_point"
    Eigen::MatrixXd covariance;  ///< of `parameters`, SI
    Eigen::MatrixXd correlations;
    std::vector<std::string> undetermined;  ///< sentences: what the data do not determine, and why
    double chi2 = 0.0;                      ///< Σ of squared residuals over their noise
    double chi2_reduced = 0.0;
    double degrees_of_freedom = 0.0;  ///< residuals − parameters
    double akaike = 0.0;              ///< AICc with the scale of the noise fitted, every residual taken for independent
    double correlated_samples = 1.0;  ///< τ: n/τ residuals count as independent
    Index n = 0;
    ChannelNoise noise;
    Array1D fitted_radius;  ///< t of each sample [m]
    ChannelResiduals force_residuals, displacement_residuals, contact_radius_residuals;
    RunsTest runs;                                   ///< of the signs of the force residuals
    std::optional<contact::tabor::Verdict> verdict;  ///< which model applies at the largest force; none where W <= 0
};

/// Fits one model to one branch.
///
/// Without known noise each channel is weighed by its second differences. Starts are searched for over the decades a
/// branch can mean, the best ones refined on few samples first; bounds are kept by the parameters' scale (ln E*, ln λ,
/// the signed root of W), so that no sample and no start needs help.
/// @throws UndefinedDataError for too few samples, a missing channel or data that are no elastic contact;
/// InvalidArgument for options a model or channel set does not have, a layer without thickness, radii beyond the
/// model's domain. Cost: measured in docs/theory/contact-models.md, below 0.2 s for 2000 samples.
[[nodiscard]] ModelFit fit_model(const BranchData& data, const LensAndCounterBody& bodies,
                                 const ModelFitOptions& options = {});

/// One model among others on the same branch.
struct ComparedModel {
    ContactModel model = ContactModel::jkr;
    Outcome<ModelFit> fit;
    double akaike_difference =
        0.0;  ///< of AICc to the least, ln χ² counted for n/τ residuals, τ of the best; NaN without a fit
    double akaike_weight = 0.0;  ///< e^(−Δ/2) over their sum
};

struct ModelComparison {
    Channels channels = Channels::force_radius;
    std::vector<ComparedModel> models;  ///< in contact_models' order
    std::optional<ContactModel> best;   ///< least AICc
    std::string sentence;               ///< for users: which fits best, by how much, and what Tabor's parameter says
};

/// Fits every model that the channels and bodies allow; `options.model` does not count. The others carry the reason.
[[nodiscard]] ModelComparison compare_models(const BranchData& data, const LensAndCounterBody& bodies,
                                             const ModelFitOptions& options = {});

}  // namespace setae::loops
