// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/fields/describe.hpp"
#include "setae/hysteresis/full_contact.hpp"
#include "setae/hysteresis/retraction_model_trials.hpp"
#include "setae/hysteresis/smooth_limit.hpp"
#include "setae/loops/outcome.hpp"
#include "setae/study/edge_speeds.hpp"

namespace setae::study {

struct StudyResult;

/// W_ret of a pair predicted from roughness by one model.
struct ModelWork {
    hysteresis::RetractionModel model;
    Estimate work_retraction;  ///< [J/m²]; NaN where an input of the model is missing
    std::string reason;        ///< missing input
    /// ln density of the measured values, with the pair's surface left out of the fit [(J/m²)⁻¹]
    std::optional<double> log_likelihood;
};

/// Energy budget of one measured loop, by the pair's model with measured W_app and contact area. After the joint fit of
/// all loops the contributions add up to the measured energy.
struct LossDecomposition {
    std::string model;     ///< name of the likeliest model, which determines the contributions
    TracedValue measured;  ///< E_loss [J]
    /// computed from W_app, W_ret and the contact area, because the area of the loop is unknown
    bool of_works = false;
    hysteresis::EnergyShares shares;  ///< contributions by the model
    TracedValue unexplained;          ///< measured − Σ shares [J]
    /// contributions whose sum is known three times better than each: "a and b"
    std::vector<std::string> indistinguishable;
};

/// An input of all loops before and after their fit.
struct JointInput {
    std::string name, unit;
    Estimate before, after;
};

/// One fit of all loops: their energies and works of retraction against the predictions of the pairs' models.
struct JointLossFit {
    int energies = 0, works = 0;        ///< numbers of E_loss of loops and W_ret of pairs
    double unexplained_per_area = 0.0;  ///< scatter of loops beyond all known errors, determined by the fit [J/m²]
    double chi2 = 0.0;                  ///< χ² of energies and works, at that scatter
    std::vector<JointInput> inputs;     ///< E*, W_int, parameters of the tip, parameter of the model
};

/// Choice of a pair's model: the best one with a smooth limit, hysteresis::has_smooth_limit().
enum class ModelChoice {
    conforming_pairs,  ///< by pairs in spontaneous full contact
    all_pairs,         ///< by all pairs
    assumed,           ///< hysteresis::model_without_measurements(): too few pairs have a measured W_ret
};

/// Measured loops of a pair minus the predicted loop, at the same displacement.
struct LoopResiduals {
    double approach = 0.0, retraction = 0.0;  ///< rms of the force [N]
    double largest_force = 0.0;               ///< largest measured force [N]
    int loops = 0;
};

/// The likeliest model of a pair where it has no smooth limit: it is shown in addition to the recommended one.
struct LikelierModel {
    hysteresis::RetractionModel model;
    TracedValue work_retraction;                ///< predicted from roughness [J/m²]
    std::optional<TracedValue> pull_off_force;  ///< 3/2 π R W_ret [N]; where the sphere is given
};

/// Retraction of one pair.
struct PairHysteresis {
    std::string surface, elastomer;
    double energy_share = 0.0;              ///< U_el divided by the energy gained in full contact
    bool conforms = false;                  ///< the share is at most hysteresis::full_contact_energy_share
    std::optional<TracedValue> tip_factor;  ///< W_ret/W_app of the smooth reference
    /// W_ret as measured divided by W_ret at zero speed, for the speed of the pair's edge
    std::optional<TracedValue> speed_factor;
    std::optional<Estimate> measured_retraction;  ///< by Eq. S2, else by Eq. S1 [J/m²]
    hysteresis::RetractionModel model;            ///< model of the predicted numbers
    ModelChoice choice = ModelChoice::assumed;
    double contact_fraction = 1.0;  ///< share of the area in contact without load
    TracedValue work_approach;    ///< by the full-contact balance (Eq. 7), or for the predicted partial contact [J/m²]
    TracedValue work_retraction;  ///< predicted from roughness by the model [J/m²]
    std::optional<TracedValue> pull_off_force;  ///< 3/2 π R W_ret [N]; where the sphere is given
    loops::Outcome<hysteresis::PredictedRetraction> loop;
    loops::Outcome<LossDecomposition> decomposition;  ///< by the likeliest model
    std::optional<LoopResiduals> residuals;           ///< residuals of records against `loop`
    std::optional<LikelierModel> likelier;            ///< where `model` is not the likeliest
    std::optional<hysteresis::PairPinning> pinning;   ///< pinning of JKR's contact; where models are ranked
    std::vector<ModelWork> models;
};

/// Time dependence of an elastomer, from its references and the study.
struct ElastomerTimes {
    std::string elastomer;
    loops::Outcome<ElastomerEdgeSpeed> edge;
    std::vector<hysteresis::TracedRelaxation> relaxation;

    /// contact::crack_speed::largest_bulk_factor() of the relaxation.
    [[nodiscard]] double largest_bulk_factor() const;
};

/// A pair without a prediction, with the reason.
struct SkippedPair {
    std::string surface, elastomer, reason;
};

/// A pair that would distinguish two models.
struct DecidingPair {
    std::string surface, elastomer;
    std::string first, second;                   ///< names of the models
    double first_work = 0.0, second_work = 0.0;  ///< W_ret by each model [J/m²]
    std::string largest_input;     ///< input that contributes most to the standard error of the difference
    double standard_errors = 0.0;  ///< difference in standard errors of a measurement of this pair
};

/// Comparison of a model with the smooth reference on one elastomer.
struct ReferenceLimit {
    std::string elastomer;
    Estimate reference;             ///< measured W_ret of the reference [J/m²]
    hysteresis::SmoothLimit limit;  ///< W_ret by the model at r = 1, U_el = 0
};

/// Hysteresis predicted from roughness, with models ranked by measured values.
struct Hysteresis {
    int measured_pairs = 0, conforming_pairs = 0;  ///< numbers of pairs with measured W_ret
    hysteresis::CountRange conforming_range;       ///< range of conforming_pairs by the standard errors of its inputs
    hysteresis::Ranking conforming, all;           ///< rankings with measured W_app
    hysteresis::Ranking by_area;                   ///< ranking of all pairs with known loop area: W_ret from that area
    int pairs_by_area = 0;
    std::vector<ElastomerTimes> elastomers;  ///< elastomers of the pairs
    loops::Outcome<JointLossFit> joint;      ///< joint fit for the budgets of the pairs
    std::vector<PairHysteresis> pairs;
    std::vector<SkippedPair> skipped;
    std::vector<Alert> alerts;                    ///< warnings of the predictions
    std::vector<ReferenceLimit> smooth_limits;    ///< limits of the models in the ranking of all pairs
    std::vector<hysteresis::ModelTrials> trials;  ///< trials of the first ranking, on request
    /// pair that distinguishes the best model from the likeliest model that cannot be distinguished from it
    std::optional<DecidingPair> deciding;
};

/// Largest number of pairs with measured W_ret for which run_study() ranks models: the time increases with its cube.
inline constexpr int max_ranked_by_studies = 48;

/// Every pair whose surface has a spectrum and whose elastomer has a modulus; W_int is that of the study.
///
/// Models are ranked with measured W_app, so that errors of W_app do not affect the ranking; predictions use only
/// roughness, so that pairs without a loop have them, too. The machine stiffness is that of loops of the pair, else of
/// its elastomer; fixed grips where none is stated.
/// @throws UndefinedDataError where the study has no W_int.
/// trials: whether measurements like the study's can distinguish the models, hysteresis::model_trials().
[[nodiscard]] Hysteresis hysteresis_of(const StudyResult& result,
                                       const std::optional<hysteresis::TrialOptions>& trials = {},
                                       parallel::Threads threads = {});

}  // namespace setae::study

namespace setae::fields {

template <>
struct Described<study::LossDecomposition> {
    using T = study::LossDecomposition;
    static constexpr std::array rows{
        field<&T::model>("model", "name of the likeliest model"),
        made<T>("of", "`loop`: area of the measured loop; `works`: computed from W_app, W_ret and the contact area",
                [](const T& of) { return of.of_works ? "works" : "loop"; }),
        quantity<&T::measured>("energy_loss", "E_loss", "J", "measured"),
        field<&T::shares>("energy_loss_shares", "contributions to the predicted energy loss; their sum is that loss"),
        quantity<&T::unexplained>("unexplained", "E_loss - Σ", "J", "measured minus predicted energy loss"),
        field<&T::indistinguishable>("not_told_apart", "contributions of which only the sum is known"),
        inner<&T::of_works>(),
    };
    static constexpr Description description{"", "energy budget of a measured loop", rows};
};
static_assert(complete<study::LossDecomposition>);

template <>
struct Described<study::JointInput> {
    using T = study::JointInput;
    static Quantity stated(const char* name, const Estimate& value, const T& of) {
        return {.quantity = name, .estimate = value, .unit = of.unit};
    }
    static constexpr std::array rows{
        field<&T::name>("name", "name of the input"),
        made<T>("before", "value as stated, or fitted elsewhere",
                [](const T& of) { return stated("before", of.before, of); }),
        made<T>("after", "value after the fit to the loops", [](const T& of) { return stated("after", of.after, of); }),
        inner<&T::unit>(),
        inner<&T::before>(),
        inner<&T::after>(),
    };
    static constexpr Description description{"", "input of all loops before and after the fit", rows};
};
static_assert(complete<study::JointInput>);

template <>
struct Described<study::JointLossFit> {
    using T = study::JointLossFit;
    static constexpr std::array rows{
        field<&T::energies>("energies", "number of energy losses of loops in the fit"),
        field<&T::works>("works", "number of W_ret of pairs in the fit"),
        field<&T::chi2>("chi2", "χ² of both"),
        value<&T::unexplained_per_area>("unexplained_per_area", "J/m2",
                                        "scatter of energies beyond the uncertainty of their inputs"),
        field<&T::inputs>("inputs", "inputs of the loops before and after the fit"),
    };
    static constexpr Description description{"", "one fit of all loops", rows};
};
static_assert(complete<study::JointLossFit>);

template <>
struct Described<study::LoopResiduals> {
    using T = study::LoopResiduals;
    static constexpr std::array rows{
        field<&T::loops>("loops", "number of records"),
        value<&T::approach>("approach", "N", "rms difference on approach"),
        value<&T::retraction>("retraction", "N", "rms difference on retraction"),
        inner<&T::largest_force>(),
    };
    static constexpr Description description{
        "", "force of records minus that of the predicted loop at the same displacement, rms by branch", rows};
};
static_assert(complete<study::LoopResiduals>);

template <>
struct Described<study::LikelierModel> {
    using T = study::LikelierModel;
    static constexpr std::array rows{
        made<T>("model", "name of the model", [](const T& of) { return of.model.name(); }),
        quantity<&T::work_retraction>("work_of_adhesion_retraction", "W_ret", "J/m2",
                                      "W_ret predicted from roughness only"),
        quantity<&T::pull_off_force>("pull_off_force", "F_po", "N", "magnitude"),
        inner<&T::model>(),
    };
    static constexpr Description description{"", "likeliest model where it is not used for the predictions", rows};
};
static_assert(complete<study::LikelierModel>);

template <>
struct Described<study::PairHysteresis> {
    using T = study::PairHysteresis;
    static constexpr std::array<std::string_view, 3> choices{"conforming_pairs", "all_pairs", "assumed"};
    static constexpr std::array rows{
        field<&T::surface>("surface", "name of the surface"),
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        made<T>("model", "model by which the numbers are predicted", [](const T& of) { return of.model.name(); }),
        made<T>("chosen_by",
                "ranking that gives the model: `conforming_pairs`, `all_pairs`: best model of that ranking "
                "with a smooth limit; `assumed`: `reversible`, where no models are ranked",
                [](const T& of) { return choices[static_cast<std::size_t>(of.choice)]; })
            .one_of(choices),
        field<&T::energy_share>("energy_share", "U_el divided by the energy that is gained in full contact"),
        field<&T::conforms>("conforms", "whether full contact forms spontaneously"),
        field<&T::contact_fraction>("contact_fraction",
                                    "share of the area that is in contact without load, from simulated patches"),
        quantity<&T::tip_factor>("tip_factor", "φ", "1", "factor φ, W_ret/W_app of the smooth reference"),
        quantity<&T::speed_factor>(
            "speed_factor", "φ(v)", "1",
            "factor φ(v), apparent W_ret divided by W_ret from roughness, at the speed of the edge of the pair"),
        quantity<&T::work_approach>(
            "work_of_adhesion_approach", "W_app", "J/m2",
            "W_app by the full-contact balance (Eq. 7) in full contact, otherwise of the partial contact")
            .as("apparent_work_of_adhesion"),
        quantity<&T::work_retraction>("work_of_adhesion_retraction", "W_ret", "J/m2",
                                      "W_ret predicted from roughness only"),
        quantity<&T::measured_retraction>("measured", "W_ret", "J/m2",
                                          "measured W_ret at pull-off by Eq. S2, else by Eq. S1")
            .as("work_of_adhesion_retraction"),
        quantity<&T::pull_off_force>("pull_off_force", "F_po", "N", "magnitude"),
        field<&T::likelier>("likelier",
                            "likeliest model, where it is not used because its W_ret does not tend to that of a smooth "
                            "surface as roughness tends to zero; null where the likeliest model is used")
            .or_null(),
        field<&T::pinning>(
            "pinning",
            "pinning coefficient k of simulated fronts as long as the edge of the contact; null where no "
            "models are ranked")
            .or_null(),
        made<T>("contact_radius", "a_max", "m", "contact radius at the preload",
                [](const T& of) { return of.loop ? std::optional(of.loop->contact_radius) : std::nullopt; }),
        made<T>("energy_loss", "E_loss", "J", "energy loss of the whole loop; null where it is not predicted",
                [](const T& of) {
                    return of.loop ? loops::Outcome<TracedValue>(of.loop->energy_loss)
                                   : loops::Outcome<TracedValue>::missing(of.loop.reason);
                }),
        made<T>("energy_loss_shares", "contributions to the predicted energy loss; their sum is that loss",
                [](const T& of) { return of.loop ? std::optional(of.loop->shares) : std::nullopt; }),
        field<&T::decomposition>("decomposition", "energy budget of the measured loop; null where it is unknown"),
        field<&T::residuals>(
            "residuals", "force of records minus that of the predicted loop at the same displacement, rms by branch"),
        made<T>("models", "W_ret", "J/m2", "W_ret at pull-off predicted from roughness only, by each model",
                [](const T& of) {
                    std::vector<std::pair<std::string, Estimate>> works;
                    for (const auto& m : of.models) works.emplace_back(m.model.name(), m.work_retraction);
                    return works;
                })
            .as("work_of_adhesion_retraction")
            .or_null(),
        made<T>("log_likelihood",
                "ln of the probability density of the measured values by each model, with the surface of the "
                "pair left out of the fit",
                [](const T& of) {
                    std::vector<std::pair<std::string, double>> densities;
                    for (const auto& m : of.models)
                        densities.emplace_back(m.model.name(), m.log_likelihood.value_or(undefined));
                    return densities;
                })
            .or_null(),
        inner<&T::model>(),
        inner<&T::choice>(),
        inner<&T::loop>(),
        inner<&T::models>(),
    };
    static constexpr Description description{"", "hysteresis of one pair", rows};
};
static_assert(complete<study::PairHysteresis>);

template <>
struct Described<study::ElastomerTimes> {
    using T = study::ElastomerTimes;
    static constexpr std::array rows{
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        field<&T::edge>("crack_speed", "W_ret(v) = φ W [1 + (v/v0)^n]; null where it is unknown"),
        field<&T::relaxation>("relaxation", "terms of E(t)/E∞ = 1 + Σ g e^(−t/τ), as stated in the study"),
        made<T>(
            "largest_bulk_factor", "1 + Σ g: upper limit of W_ret(v)/W_ret(0) by this relaxation",
            [](const T& of) { return of.relaxation.empty() ? std::nullopt : std::optional(of.largest_bulk_factor()); }),
    };
    static constexpr Description description{"", "time dependence of an elastomer", rows};
};
static_assert(complete<study::ElastomerTimes>);

template <>
struct Described<study::SkippedPair> {
    using T = study::SkippedPair;
    static constexpr std::array rows{
        field<&T::surface>("surface", "name of the surface"),
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        field<&T::reason>("reason", "reason for which it is missing or left out"),
    };
    static constexpr Description description{"", "pair without a prediction", rows};
};
static_assert(complete<study::SkippedPair>);

template <>
struct Described<study::DecidingPair> {
    using T = study::DecidingPair;
    static constexpr std::array rows{
        field<&T::surface>("surface", "name of the surface"),
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        made<T>("models", "names of the two models",
                [](const T& of) {
                    return std::vector{of.first, of.second};
                }),
        made_value<T>("work_of_adhesion_retraction", "J/m2", "W_ret predicted by each model",
                      [](const T& of) {
                          return std::vector{of.first_work, of.second_work};
                      }),
        field<&T::largest_input>("largest_input",
                                 "input that contributes most to the standard error of the difference"),
        field<&T::standard_errors>("standard_errors_apart", "difference of the predictions in standard errors"),
        inner<&T::first>(),
        inner<&T::second>(),
        inner<&T::first_work>(),
        inner<&T::second_work>(),
    };
    static constexpr Description description{"", "pair that would distinguish two models", rows};
};
static_assert(complete<study::DecidingPair>);

template <>
struct Described<study::ReferenceLimit> {
    using T = study::ReferenceLimit;
    static constexpr std::array rows{
        made<T>("model", "name of the model", [](const T& of) { return of.limit.model.name(); }),
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        made<T>("tends_to_reference",
                "whether W_ret tends to W_app, times the factor of the crack tip, as the roughness tends to zero",
                [](const T& of) { return of.limit.tends_to_reference; }),
        made<T>("work_of_adhesion_retraction", "W_ret", "J/m2", "W_ret by the model",
                [](const T& of) { return of.limit.work_retraction; }),
        quantity<&T::reference>("reference", "W_ret", "J/m2", "measured W_ret of the smooth reference"),
        made<T>("distance", "W_ret - W_ret,reference", "J/m2", "W_ret by the model minus the measured value",
                [](const T& of) { return of.limit.distance; }),
        inner<&T::limit>(),
    };
    static constexpr Description description{"", "comparison of a model with the smooth reference on one elastomer",
                                             rows};
};
static_assert(complete<study::ReferenceLimit>);

template <>
struct Described<study::Hysteresis> {
    using T = study::Hysteresis;
    static constexpr std::array ranking_rows{
        field<&T::conforming>("conforming_pairs", "ranking by pairs in spontaneous full contact"),
        field<&T::all>("all_pairs", "ranking by all measured pairs"),
        field<&T::by_area>("loop_areas",
                           "ranking by W_ret from the energy loss of loops, for pairs with known loop area"),
    };
    static constexpr Description rankings{"", "models of W_ret at pull-off", ranking_rows};
    static constexpr std::array rows{
        field<&T::measured_pairs>("measured_pairs", "number of pairs with measured W_app and W_ret"),
        field<&T::conforming_pairs>("conforming_pairs", "number of these pairs in spontaneous full contact"),
        made<T>("conforming_pairs_range",
                "2.5 and 97.5 % points of this number when inputs are drawn within their standard errors",
                [](const T& of) {
                    return std::vector{of.conforming_range.lower, of.conforming_range.upper};
                }),
        inner<&T::conforming_range>(),
        part<T>("rankings", "models of W_ret at pull-off", rankings),
        field<&T::pairs_by_area>("pairs_by_area", "number of pairs with known loop area"),
        field<&T::elastomers>("elastomers", "time dependence of elastomers"),
        field<&T::joint>("joint_fit",
                         "one fit of all loops, on which the budgets of the pairs depend; null where there are too "
                         "few loops"),
        field<&T::deciding>(
            "deciding_pair",
            "pair for which the best model and the likeliest model that cannot be distinguished from it "
            "differ most; null where there is none")
            .or_null(),
        field<&T::smooth_limits>("smooth_limits",
                                 "every model of the ranking of all pairs, applied to the smooth reference of every "
                                 "elastomer: r = 1, U_el = 0"),
        field<&T::alerts>("alerts", "warnings"),
        field<&T::trials>("trials", "recovery of known retraction models from simulated pairs").with(Missing::left_out),
        field<&T::pairs>("pairs", "one entry per pair of a surface and an elastomer"),
        field<&T::skipped>("skipped", "pairs without a prediction"),
    };
    static constexpr Description description{"", "retraction models and predictions of all pairs", rows};
};
static_assert(complete<study::Hysteresis>);

}  // namespace setae::fields
