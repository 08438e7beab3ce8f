// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/contact/tabor.hpp"
#include "setae/fields/describe.hpp"
#include "setae/loops/jkr_fits.hpp"
#include "setae/loops/outcome.hpp"

namespace setae::loops {

/// Contact models that can be fitted to a branch; each is a header of module contact.
enum class ContactModel {
    hertz,           ///< no adhesion: E*
    dmt,             ///< adhesion of long range: E*, W
    jkr,             ///< adhesion of vanishing range: E*, W
    maugis_dugdale,  ///< adhesion of any range: E*, W, λ
    transition,  ///< Carpick–Ogletree–Salmeron: a0, Fc, α, from which E*, W, σ0; contact radius against force only
    layer,       ///< JKR of a layer, its thickness from the bodies: E*, W
    large_strain,  ///< JKR of a sphere, contact radii comparable to R: E*, W
};

[[nodiscard]] const std::vector<ContactModel>& contact_models();

/// "hertz", "dmt", "jkr", "maugis_dugdale", "transition", "layer", "large_strain".
[[nodiscard]] std::string to_string(ContactModel model);

/// The model of that name. @throws InvalidArgument with the nearest name and all names.
[[nodiscard]] ContactModel model_named(std::string_view name);

/// Fitted channels of a branch; force is always fitted.
enum class Channels {
    force_radius,               ///< (F, a)
    force_displacement,         ///< (F, δ)
    force_displacement_radius,  ///< (F, δ, a)
};

/// "force", "displacement", "contact_radius": names of the fitted channels.
[[nodiscard]] std::vector<std::string> names_of(Channels channels);

/// The channels of a branch. @throws UndefinedDataError for neither displacement nor contact radius.
[[nodiscard]] Channels channels_of(const BranchData& data);

/// Errors in the fit. Every sample lies at an unknown t, the contact radius of a point of the curve.
enum class FitErrors {
    /// Σ (F − F(x))², x = a or δ + δ0 taken as exact: two channels only.
    force_only,
    /// Linear propagation at the measured radius: Σ rᵀC⁻¹r, r = (F − F(a), δ − δ(a) − δ0), C = TΣTᵀ, T = [1 0 −F'; 0 1
    /// −δ'],
    /// C updated until the solution converges. Biased by F'' σ_a²/2, which is visible where σ_a is some percent of the
    /// range. Without a
    /// measured radius the nearest point of the curve is used instead, and the result is that of orthogonal distance.
    effective_variance,
    /// Σ (F − F(t))²/σ_F² + (δ − δ(t) − δ0)²/σ_δ² + (a − t)²/σ_a², minimised over the parameters and all t.
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
    double interaction_range = 0.3e-9;           ///< z0 of the Tabor parameter [m] for models without a range
};

/// Noise by which a fit weighted its channels: known, or from second differences.
struct ChannelNoise {
    double force = 0.0;                          ///< σ_F [N]
    double displacement = 0.0;                   ///< σ_δ [m]
    double contact_radius = 0.0;                 ///< σ_a [m]
    double force_displacement_covariance = 0.0;  ///< [N m]
    bool all_known = false;                      ///< otherwise χ²_red does not test the model
};

/// Residuals of one channel at the nearest points of the curve, measured − fitted; empty where the channel was not
/// fitted.
struct ChannelResiduals {
    Array1D values;
    double rms = 0.0;
};

/// Least-squares estimate of a model's parameters from one branch.
///
/// Standard errors and covariance are scaled by the scatter of the residuals and take correlated residuals into
/// account, as in JkrFit; the error of the zero of force is added.
struct ModelFit {
    ContactModel model = ContactModel::jkr;
    Channels channels = Channels::force_radius;
    FitErrors errors = FitErrors::orthogonal_distance;
    bool converged = false;  ///< whether the iteration converged and the data determine all unknowns
    int iterations = 0;
    Estimate contact_modulus;  ///< E* [Pa]
    Estimate youngs_modulus;   ///< E of the soft body [Pa]; NaN where E* exceeds the limit of the counter-body
    Outcome<Estimate>
        work_of_adhesion;  ///< W [J/m²]; none for Hertz and where it follows a λ that the data do not determine
    Outcome<Estimate> cohesive_stress;       ///< σ0 [Pa] of Maugis–Dugdale and transition, where determined
    Outcome<Estimate> transition_parameter;  ///< λ of Maugis–Dugdale and transition
    Outcome<Estimate> transition_share;      ///< α of transition
    Outcome<Estimate> zero_load_radius;      ///< a0 [m] of transition
    Outcome<Estimate> pull_off_force;        ///< Fc [N] of transition
    Estimate contact_point;                  ///< δ0 [m]; NaN without displacement, without error where given
    std::vector<std::string>
        parameters;  ///< rows of the covariance: "contact_modulus", "work_of_adhesion", …, "contact_point"
    Eigen::MatrixXd covariance;  ///< of `parameters`, SI
    Eigen::MatrixXd correlations;
    std::vector<std::string> undetermined;  ///< sentences on undetermined parameters, with the reason
    double chi2 = 0.0;                      ///< Σ of squared residuals divided by their noise
    double chi2_reduced = 0.0;
    double degrees_of_freedom = 0.0;  ///< residuals − parameters
    double akaike = 0.0;              ///< AICc with a fitted scale of the noise, residuals taken as independent
    double correlated_samples = 1.0;  ///< τ: n/τ residuals are independent
    Index n = 0;
    ChannelNoise noise;
    Array1D fitted_radius;  ///< t of each sample [m]
    ChannelResiduals force_residuals, displacement_residuals, contact_radius_residuals;
    RunsTest runs;                                   ///< test of the signs of the force residuals
    std::optional<contact::tabor::Verdict> verdict;  ///< applicable model at the largest force; none where W <= 0
};

/// Fits one model to one branch.
///
/// Without known noise each channel is weighted by its second differences. Starts are searched over the possible
/// decades of a branch, the best ones refined on few samples first; bounds are enforced by the parameters' scale (ln
/// E*, ln λ, the signed root of W), so that no start has to be given.
/// @throws UndefinedDataError for too few samples, a missing channel or data that are no elastic contact;
/// InvalidArgument for options a model or channel set does not have, a layer without thickness, radii beyond the
/// model's domain. Cost: measured in docs/concepts/contact-models.md, below 0.2 s for 2000 samples.
[[nodiscard]] ModelFit fit_model(const BranchData& data, const LensAndCounterBody& bodies,
                                 const ModelFitOptions& options = {});

/// One model in a comparison on one branch.
struct ComparedModel {
    ContactModel model = ContactModel::jkr;
    Outcome<ModelFit> fit;
    double akaike_difference =
        0.0;  ///< AICc minus the smallest AICc, ln χ² for n/τ residuals, τ of the best; NaN without a fit
    double akaike_weight = 0.0;  ///< e^(−Δ/2) divided by the sum over all models
};

struct ModelComparison {
    Channels channels = Channels::force_radius;
    std::vector<ComparedModel> models;  ///< in contact_models' order
    std::optional<ContactModel> best;   ///< smallest AICc
    /// sentence for users: best model, its difference to the others, and the model by Tabor's parameter
    std::string sentence;
};

/// Fits every model that the channels and bodies allow; `options.model` is ignored. The others have a reason.
[[nodiscard]] ModelComparison compare_models(const BranchData& data, const LensAndCounterBody& bodies,
                                             const ModelFitOptions& options = {});

}  // namespace setae::loops

namespace setae::fields {

/// Residuals of one channel, in its unit.
struct ResidualsInUnit {
    const loops::ChannelResiduals* of;
    const char* unit;
};

template <>
struct Described<ResidualsInUnit> {
    using T = ResidualsInUnit;
    static constexpr std::array rows{
        made<T>("rms", "root mean square", [](const T& of) { return of.of->rms; }),
        field<&T::unit>("unit", "unit of the numbers of this object"),
        made<T>("values", "residual of each point", [](const T& of) -> const Array1D& { return of.of->values; }),
        inner<&T::of>(),
    };
    static constexpr Description description{"channel_residuals", "measured minus fitted values", rows};
};
static_assert(complete<ResidualsInUnit>);

/// Applicable model of contact.
struct ApplicableModel {
    const contact::tabor::Verdict* verdict;
};

template <>
struct Described<ApplicableModel> {
    using T = ApplicableModel;
    static constexpr std::array rows{
        made<T>("sentence", "applicability of the model in words", [](const T& of) { return of.verdict->sentence; }),
        made<T>("tabor_parameter", "Tabor parameter μ; JKR applies for large μ",
                [](const T& of) { return of.verdict->tabor_parameter; }),
        made<T>("transition_parameter", "transition parameter λ of Maugis",
                [](const T& of) { return of.verdict->transition_parameter; }),
        inner<&T::verdict>(),
    };
    static constexpr Description description{"", "whether the model is that of the Tabor parameter", rows};
};
static_assert(complete<ApplicableModel>);

template <>
struct Described<loops::ModelFit> {
    using T = loops::ModelFit;
    using Number = loops::Outcome<Estimate> T::*;
    /// A parameter of some models, where the fit's model is one of these.
    static std::optional<loops::Outcome<Estimate>> number_of(const T& of, Number number, bool with_maugis_dugdale) {
        const bool has_it = of.model == loops::ContactModel::transition ||
                            (with_maugis_dugdale && of.model == loops::ContactModel::maugis_dugdale);
        if (!has_it) return {};
        return of.*number;
    }
    static std::optional<ResidualsInUnit> residuals(const loops::ChannelResiduals& of, const char* unit) {
        if (of.values.size() == 0) return {};
        return ResidualsInUnit{&of, unit};
    }
    static constexpr std::string_view signed_distance = "measured minus fitted values";
    static constexpr std::array rows{
        made<T>("model", "name of the contact model", [](const T& of) { return to_string(of.model); }),
        made<T>("channels", "fitted channels: force, displacement, contact radius",
                [](const T& of) { return loops::names_of(of.channels); }),
        made<T>("errors", "channels whose errors were minimised", [](const T& of) { return to_string(of.errors); }),
        field<&T::converged>("converged", "whether the iteration converged"),
        quantity<&T::contact_modulus>("contact_modulus", "E*", "Pa", "E*"),
        quantity<&T::youngs_modulus>("youngs_modulus", "E", "Pa", "E"),
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W", "J/m2", "W"),
        made<T>("cohesive_stress", "sigma0", "Pa", "cohesive stress σ0 of Maugis",
                [](const T& of) { return number_of(of, &T::cohesive_stress, true); }),
        made<T>("transition_parameter", "lambda", "1", "transition parameter λ of Maugis",
                [](const T& of) { return number_of(of, &T::transition_parameter, true); }),
        made<T>("transition_share", "alpha", "1", "transition parameter α between DMT and JKR",
                [](const T& of) { return number_of(of, &T::transition_share, false); }),
        made<T>("zero_load_radius", "a0", "m", "a0",
                [](const T& of) { return number_of(of, &T::zero_load_radius, false); }),
        made<T>("pull_off_force", "F_c", "N", "pull-off force of the model",
                [](const T& of) { return number_of(of, &T::pull_off_force, false); })
            .as("model_pull_off_force"),
        made<T>("contact_point", "delta0", "m", "δ0",
                [](const T& of) {
                    return std::isnan(of.contact_point.value) ? std::nullopt : std::optional(of.contact_point);
                }),
        field<&T::parameters>("parameters", "names of the fitted parameters, in the order of the covariance"),
        field<&T::covariance>("covariance", "covariance of the parameters"),
        field<&T::correlations>("correlations", "correlations of the parameters"),
        field<&T::undetermined>("undetermined", "parameters that the data do not determine").with(Missing::left_out),
        field<&T::n>("n", "number of points, measurements or pairs"),
        field<&T::degrees_of_freedom>("degrees_of_freedom", "degrees of freedom of Student's t or of χ²"),
        field<&T::chi2_reduced>("chi_squared_reduced", "χ² divided by the degrees of freedom"),
        made<T>("noise_known", "whether the errors of all channels were stated",
                [](const T& of) { return of.noise.all_known; }),
        field<&T::akaike>("akaike", "Akaike's information criterion"),
        field<&T::correlated_samples>(
            "correlated_samples",
            "number of samples that correspond to one independent sample, because neighbouring residuals "
            "are correlated"),
        field<&T::runs>("runs", "test of the signs of residuals"),
        made<T>("force_residuals", signed_distance, [](const T& of) { return residuals(of.force_residuals, "N"); }),
        made<T>("displacement_residuals", signed_distance,
                [](const T& of) { return residuals(of.displacement_residuals, "m"); }),
        made<T>("contact_radius_residuals", signed_distance,
                [](const T& of) { return residuals(of.contact_radius_residuals, "m"); }),
        made<T>("applies", "whether the model is that of the Tabor parameter",
                [](const T& of) { return of.verdict ? std::optional(ApplicableModel{&*of.verdict}) : std::nullopt; }),
        inner<&T::model>(),
        inner<&T::channels>(),
        inner<&T::errors>(),
        inner<&T::iterations>(),
        inner<&T::cohesive_stress>(),
        inner<&T::transition_parameter>(),
        inner<&T::transition_share>(),
        inner<&T::zero_load_radius>(),
        inner<&T::pull_off_force>(),
        inner<&T::contact_point>(),
        inner<&T::chi2>(),
        inner<&T::noise>(),
        inner<&T::fitted_radius>(),
        inner<&T::force_residuals>(),
        inner<&T::displacement_residuals>(),
        inner<&T::contact_radius_residuals>(),
        inner<&T::verdict>(),
    };
    static constexpr Description description{"model_fit", "contact model fitted to a branch", rows};
};
static_assert(complete<loops::ModelFit>);

template <>
struct Described<loops::ComparedModel> {
    using T = loops::ComparedModel;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) -> const loops::Outcome<loops::ModelFit>& { return of.fit; }),
        made<T>("model", "name of the contact model",
                [](const T& of) { return of.fit ? std::nullopt : std::optional(to_string(of.model)); }),
        made<T>("reason", "reason for which it is missing or left out",
                [](const T& of) { return of.fit ? std::nullopt : std::optional(of.fit.reason); }),
        field<&T::akaike_difference>("akaike_difference", "difference of Akaike's criterion from the best model"),
        field<&T::akaike_weight>("akaike_weight", "Akaike weight of the model"),
        inner<&T::model>(),
        inner<&T::fit>(),
    };
    static constexpr Description description{"compared_model", "contact model in comparison with others", rows};
};
static_assert(complete<loops::ComparedModel>);

template <>
struct Described<loops::ModelComparison> {
    using T = loops::ModelComparison;
    static constexpr std::array rows{
        made<T>("channels", "fitted channels: force, displacement, contact radius",
                [](const T& of) { return loops::names_of(of.channels); }),
        field<&T::models>("models", "one entry per model"),
        made<T>("best", "name of the best model",
                [](const T& of) { return of.best ? std::optional(to_string(*of.best)) : std::nullopt; })
            .or_null(),
        field<&T::sentence>("sentence", "comparison in words"),
        inner<&T::channels>(),
        inner<&T::best>(),
    };
    static constexpr Description description{"model_comparison", "models compared by Akaike's criterion", rows};
};
static_assert(complete<loops::ModelComparison>);

}  // namespace setae::fields
