// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/fields/describe.hpp"
#include "setae/hysteresis/full_contact.hpp"
#include "setae/hysteresis/law_trials.hpp"
#include "setae/hysteresis/smooth_limit.hpp"
#include "setae/loops/outcome.hpp"
#include "setae/study/edge_speeds.hpp"

namespace setae::study {

struct StudyResult;

/// W_ret of a pair by one model, from roughness alone.
struct ModelWork {
    hysteresis::RetractionModel model;
    Estimate work_retraction;  ///< [J/m²]; NaN where the model lacks something
    std::string reason;        ///< what it lacks
    /// ln density of what was measured, the pair's surface left out of the fit [(J/m²)⁻¹]
    std::optional<double> log_likelihood;
};

/// Where the joules of one measured loop went, by the pair's model with W_app and contact area as measured. After the
/// fit of all loops together they add up to the measured energy.
struct LossDecomposition {
    std::string model;                ///< name of the likeliest model, by which the joules are told
    TracedValue measured;             ///< E_loss [J]
    bool of_works = false;            ///< from W_app, W_ret and the contact area: the loop's own area is not known
    hysteresis::EnergyShares shares;  ///< by the model
    TracedValue unexplained;          ///< measured − Σ shares [J]
    std::vector<std::string> not_told_apart;  ///< shares whose sum is known three times better than each: "a and b"
};

/// An input of all loops before and after their fit.
struct JointInput {
    std::string name, unit;
    Estimate before, after;
};

/// One fit of all loops: their energies and works of retraction against what the pairs' laws say of them.
struct JointLossFit {
    int energies = 0, works = 0;        ///< E_loss of loops and W_ret of pairs
    double unexplained_per_area = 0.0;  ///< what loops scatter by beyond everything known, found with the fit [J/m²]
    double chi2 = 0.0;                  ///< of energies and works, at that scatter
    std::vector<JointInput> inputs;     ///< E*, W_int, the tip's law, the law's own number
};

/// How a pair's model was chosen: the best one with a smooth limit, hysteresis::has_smooth_limit().
enum class ModelChoice {
    conforming_pairs,  ///< by pairs that come into full contact of themselves
    all_pairs,         ///< by all pairs
    assumed,           ///< hysteresis::model_without_measurements(): too few pairs have W_ret measured
};

/// Measured loops of a pair less the predicted one, at the same displacement.
struct LoopResiduals {
    double approach = 0.0, retraction = 0.0;  ///< rms of the force [N]
    double largest_force = 0.0;               ///< measured [N]
    int loops = 0;
};

/// The likeliest model of a pair where it has no smooth limit: it is shown beside the answer.
struct LikelierModel {
    hysteresis::RetractionModel model;
    TracedValue work_retraction;                ///< from roughness alone [J/m²]
    std::optional<TracedValue> pull_off_force;  ///< 3/2 π R W_ret [N]; where the sphere is given
};

/// One pair on its way back.
struct PairHysteresis {
    std::string surface, elastomer;
    double energy_share = 0.0;                    ///< U_el over what conforming gains
    bool conforms = false;                        ///< the share is at most hysteresis::conforming_energy_share
    std::optional<TracedValue> tip_factor;        ///< W_ret/W_app of the smooth reference
    std::optional<TracedValue> speed_factor;      ///< W_ret as read over W_ret at rest, of the speed of the pair's edge
    std::optional<Estimate> measured_retraction;  ///< by (S2), else by (S1) [J/m²]
    hysteresis::RetractionModel model;            ///< whose numbers follow
    ModelChoice choice = ModelChoice::assumed;
    double contact_fraction = 1.0;              ///< of the area in contact without load
    TracedValue work_approach;                  ///< by (7), of the contact that there is [J/m²]
    TracedValue work_retraction;                ///< by the model, from roughness alone [J/m²]
    std::optional<TracedValue> pull_off_force;  ///< 3/2 π R W_ret [N]; where the sphere is given
    loops::Outcome<hysteresis::PredictedRetraction> loop;
    loops::Outcome<LossDecomposition> decomposition;  ///< by the likeliest model
    std::optional<LoopResiduals> residuals;           ///< of records against `loop`
    std::optional<LikelierModel> likelier;            ///< where `model` is not the likeliest
    std::optional<hysteresis::PairPinning> pinning;   ///< of JKR's contact; where models are ranked
    std::vector<ModelWork> models;
};

/// What an elastomer does in time, as its references and the study say.
struct ElastomerTimes {
    std::string elastomer;
    loops::Outcome<ElastomerEdgeSpeed> edge;
    std::vector<hysteresis::TracedRelaxation> relaxation;

    /// contact::crack_speed::largest_bulk_factor() of the relaxation.
    [[nodiscard]] double largest_bulk_factor() const;
};

/// A pair of which nothing can be said, and why.
struct SkippedPair {
    std::string surface, elastomer, reason;
};

/// A pair that would tell two models apart.
struct DecidingPair {
    std::string surface, elastomer;
    std::string first, second;                   ///< models
    double first_work = 0.0, second_work = 0.0;  ///< W_ret by them [J/m²]
    std::string largest_input;                   ///< what most of the ± of their difference rests on
    double standard_errors = 0.0;                ///< their difference in standard errors of a measurement there
};

/// A model against the smooth reference on one elastomer.
struct ReferenceLimit {
    std::string elastomer;
    Estimate reference;             ///< W_ret of it as measured [J/m²]
    hysteresis::SmoothLimit limit;  ///< W_ret by the model at r = 1, U_el = 0
};

/// Hysteresis predicted from roughness, ranked against what was measured.
struct Hysteresis {
    int measured_pairs = 0, conforming_pairs = 0;  ///< with W_ret measured
    hysteresis::CountRange conforming_range;       ///< of conforming_pairs, by the ± of what they rest on
    hysteresis::Ranking conforming, all;           ///< W_app as measured
    hysteresis::Ranking by_area;                   ///< of all pairs whose loops' area is known: W_ret read from it
    int pairs_by_area = 0;
    std::vector<ElastomerTimes> elastomers;  ///< of the pairs
    loops::Outcome<JointLossFit> joint;      ///< behind the pairs' decompositions
    std::vector<PairHysteresis> pairs;
    std::vector<SkippedPair> skipped;
    std::vector<Alert> alerts;                  ///< of what is predicted
    std::vector<ReferenceLimit> smooth_limits;  ///< of the ranking of all pairs
    std::vector<hysteresis::LawTrials> trials;  ///< of the ranking that comes first, where they were asked for
    std::optional<DecidingPair> deciding;       ///< between the best law and the likeliest not told apart from it
};

/// Pairs with W_ret measured up to which run_study() ranks laws: the time goes as their cube.
inline constexpr int max_ranked_by_studies = 48;

/// Every pair whose surface has a spectrum and whose elastomer a modulus; W_int is the study's.
///
/// Models are ranked with W_app as measured, so that errors of it do not count against them; what is predicted rests
/// on roughness alone, so that pairs without a loop have it, too. Machines are as stiff as loops of the pair, else of
/// its elastomer, state; fixed grips where none does.
/// @throws UndefinedDataError where the study has no W_int.
/// trials: whether measurements like the study's could tell the laws apart, hysteresis::law_trials().
[[nodiscard]] Hysteresis hysteresis_of(const StudyResult& result,
                                       const std::optional<hysteresis::TrialOptions>& trials = {},
                                       parallel::Threads threads = {});

}  // namespace setae::study

namespace setae::fields {

template <>
struct Described<study::LossDecomposition> {
    using T = study::LossDecomposition;
    static constexpr std::array rows{
        field<&T::model>("model", "the likeliest model"),
        made<T>("of", "`loop`: its own area; `works`: from W_app, W_ret and the contact area",
                [](const T& of) { return of.of_works ? "works" : "loop"; }),
        quantity<&T::measured>("energy_loss", "E_loss", "J", "measured"),
        field<&T::shares>("energy_loss_shares", "where the energy goes; they add to the loss of the law"),
        quantity<&T::unexplained>("unexplained", "E_loss - Σ", "J", "measured less the law's"),
        field<&T::not_told_apart>("not_told_apart", "shares of which only the sum is known"),
        inner<&T::of_works>(),
    };
    static constexpr Description description{"", "where the joules of a measured loop went", rows};
};
static_assert(complete<study::LossDecomposition>);

template <>
struct Described<study::JointInput> {
    using T = study::JointInput;
    static Quantity stated(const char* name, const Estimate& value, const T& of) {
        return {.quantity = name, .estimate = value, .unit = of.unit};
    }
    static constexpr std::array rows{
        field<&T::name>("name", "of the input"),
        made<T>("before", "as stated or fitted elsewhere", [](const T& of) { return stated("before", of.before, of); }),
        made<T>("after", "with what the loops say", [](const T& of) { return stated("after", of.after, of); }),
        inner<&T::unit>(),
        inner<&T::before>(),
        inner<&T::after>(),
    };
    static constexpr Description description{"", "an input of all loops before and after their fit", rows};
};
static_assert(complete<study::JointInput>);

template <>
struct Described<study::JointLossFit> {
    using T = study::JointLossFit;
    static constexpr std::array rows{
        field<&T::energies>("energies", "E_loss of loops in it"),
        field<&T::works>("works", "W_ret of pairs in it"),
        field<&T::chi2>("chi2", "of both"),
        value<&T::unexplained_per_area>("unexplained_per_area", "J/m2",
                                        "what energies scatter by beyond what their inputs leave open"),
        field<&T::inputs>("inputs", "what loops rest on, before and after"),
    };
    static constexpr Description description{"", "one fit of all loops", rows};
};
static_assert(complete<study::JointLossFit>);

template <>
struct Described<study::LoopResiduals> {
    using T = study::LoopResiduals;
    static constexpr std::array rows{
        field<&T::loops>("loops", "records behind it"),
        value<&T::approach>("approach", "N", "while it is pressed"),
        value<&T::retraction>("retraction", "N", "while it is pulled off"),
        inner<&T::largest_force>(),
    };
    static constexpr Description description{
        "", "force of records less that of the predicted loop at the same displacement, rms by branch", rows};
};
static_assert(complete<study::LoopResiduals>);

template <>
struct Described<study::LikelierModel> {
    using T = study::LikelierModel;
    static constexpr std::array rows{
        made<T>("model", "name of the model", [](const T& of) { return of.model.name(); }),
        quantity<&T::work_retraction>("work_of_adhesion_retraction", "W_ret", "J/m2", "from roughness alone"),
        quantity<&T::pull_off_force>("pull_off_force", "F_po", "N", "magnitude"),
        inner<&T::model>(),
    };
    static constexpr Description description{"", "the likeliest model where it is not the answer", rows};
};
static_assert(complete<study::LikelierModel>);

template <>
struct Described<study::PairHysteresis> {
    using T = study::PairHysteresis;
    static constexpr std::array<std::string_view, 3> choices{"conforming_pairs", "all_pairs", "assumed"};
    static constexpr std::array rows{
        field<&T::surface>("surface", "name of the surface"),
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        made<T>("model", "the law whose numbers follow", [](const T& of) { return of.model.name(); }),
        made<T>(
            "chosen_by",
            "`conforming_pairs`, `all_pairs`: best of that ranking with a smooth limit; `assumed`: `reversible`, where "
            "nothing was ranked",
            [](const T& of) { return choices[static_cast<std::size_t>(of.choice)]; })
            .one_of(choices),
        field<&T::energy_share>("energy_share", "U_el over what conforming gains"),
        field<&T::conforms>("conforms", "whether the bodies come into full contact of themselves"),
        field<&T::contact_fraction>("contact_fraction",
                                    "of the area in contact without load, as simulated patches have it"),
        quantity<&T::tip_factor>("tip_factor", "φ", "1", "φ, W_ret/W_app of the smooth reference"),
        quantity<&T::speed_factor>(
            "speed_factor", "φ(v)", "1",
            "φ(v), W_ret as read over what roughness asks for, at the speed of the pair's own edge"),
        quantity<&T::work_approach>("work_of_adhesion_approach", "W_app", "J/m2",
                                    "by (7) where contact is full, of the contact that there is where it is not"),
        quantity<&T::work_retraction>("work_of_adhesion_retraction", "W_ret", "J/m2", "from roughness alone"),
        quantity<&T::measured_retraction>("measured", "W_ret", "J/m2", "W_ret at pull-off by (S2), else by (S1)")
            .as("work_of_adhesion_retraction"),
        quantity<&T::pull_off_force>("pull_off_force", "F_po", "N", "magnitude"),
        field<&T::likelier>(
            "likelier",
            "the likeliest model, not taken for the answer because it does not tend to a smooth surface's "
            "W_ret as roughness tends to zero; null where the answer is the likeliest")
            .or_null(),
        field<&T::pinning>("pinning",
                           "k of simulated fronts as long as the edge of the contact; null where no models are ranked")
            .or_null(),
        made<T>("contact_radius", "a_max", "m", "at the preload",
                [](const T& of) { return of.loop ? std::optional(of.loop->contact_radius) : std::nullopt; }),
        made<T>("energy_loss", "E_loss", "J", "of the whole loop; null where it is not predicted",
                [](const T& of) {
                    return of.loop ? loops::Outcome<TracedValue>(of.loop->energy_loss)
                                   : loops::Outcome<TracedValue>::missing(of.loop.reason);
                }),
        made<T>("energy_loss_shares", "where the energy goes; they add to the loss of the law",
                [](const T& of) { return of.loop ? std::optional(of.loop->shares) : std::nullopt; }),
        field<&T::decomposition>("decomposition",
                                 "where the joules of the measured loop went; null where that is not known"),
        field<&T::residuals>(
            "residuals", "force of records less that of the predicted loop at the same displacement, rms by branch"),
        made<T>("models", "W_ret", "J/m2", "W_ret at pull-off from roughness alone by each law",
                [](const T& of) {
                    std::vector<std::pair<std::string, Estimate>> works;
                    for (const auto& m : of.models) works.emplace_back(m.model.name(), m.work_retraction);
                    return works;
                })
            .as("work_of_adhesion_retraction")
            .or_null(),
        made<T>("log_likelihood", "ln density of what was measured by each law, the pair's surface left out of the fit",
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
        field<&T::edge>("crack_speed", "W_ret(v) = φ W [1 + (v/v0)^n]; null where it is not known"),
        field<&T::relaxation>("relaxation", "terms of E(t)/E∞ = 1 + Σ g e^(−t/τ), as the study states them"),
        made<T>(
            "largest_bulk_factor", "1 + Σ g: the most that this relaxation can raise W_ret(v)/W_ret(0) to",
            [](const T& of) { return of.relaxation.empty() ? std::nullopt : std::optional(of.largest_bulk_factor()); }),
    };
    static constexpr Description description{"", "what an elastomer does in time", rows};
};
static_assert(complete<study::ElastomerTimes>);

template <>
struct Described<study::SkippedPair> {
    using T = study::SkippedPair;
    static constexpr std::array rows{
        field<&T::surface>("surface", "name of the surface"),
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        field<&T::reason>("reason", "why it is missing, or left out"),
    };
    static constexpr Description description{"", "a pair of which nothing can be said", rows};
};
static_assert(complete<study::SkippedPair>);

template <>
struct Described<study::DecidingPair> {
    using T = study::DecidingPair;
    static constexpr std::array rows{
        field<&T::surface>("surface", "name of the surface"),
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        made<T>("models", "the two laws",
                [](const T& of) {
                    return std::vector{of.first, of.second};
                }),
        made_value<T>("work_of_adhesion_retraction", "J/m2", "by each of them",
                      [](const T& of) {
                          return std::vector{of.first_work, of.second_work};
                      }),
        field<&T::largest_input>("largest_input", "what most of the ± of their difference rests on"),
        field<&T::standard_errors>("standard_errors_apart", "of what is predicted"),
        inner<&T::first>(),
        inner<&T::second>(),
        inner<&T::first_work>(),
        inner<&T::second_work>(),
    };
    static constexpr Description description{"", "a pair that would tell two models apart", rows};
};
static_assert(complete<study::DecidingPair>);

template <>
struct Described<study::ReferenceLimit> {
    using T = study::ReferenceLimit;
    static constexpr std::array rows{
        made<T>("model", "its name", [](const T& of) { return of.limit.model.name(); }),
        field<&T::elastomer>("elastomer", "name of the elastomer"),
        made<T>("tends_to_reference",
                "whether W_ret tends to W_app, times the factor of its crack tip, as the roughness tends to zero",
                [](const T& of) { return of.limit.tends_to_reference; }),
        made<T>("work_of_adhesion_retraction", "W_ret", "J/m2", "by the model",
                [](const T& of) { return of.limit.work_retraction; }),
        quantity<&T::reference>("reference", "W_ret", "J/m2", "as measured"),
        made<T>("distance", "W_ret - W_ret,reference", "J/m2", "by the model less as measured",
                [](const T& of) { return of.limit.distance; }),
        inner<&T::limit>(),
    };
    static constexpr Description description{"", "a model against the smooth reference on one elastomer", rows};
};
static_assert(complete<study::ReferenceLimit>);

template <>
struct Described<study::Hysteresis> {
    using T = study::Hysteresis;
    static constexpr std::array ranking_rows{
        field<&T::conforming>("conforming_pairs", "by pairs that come into full contact of themselves"),
        field<&T::all>("all_pairs", "by all measured pairs"),
        field<&T::by_area>("loop_areas", "by W_ret read from what loops lose, of pairs whose loops' area is known"),
    };
    static constexpr Description rankings{"", "models of W_ret at pull-off", ranking_rows};
    static constexpr std::array rows{
        field<&T::measured_pairs>("measured_pairs", "with W_app and W_ret measured"),
        field<&T::conforming_pairs>("conforming_pairs", "of these, that come into full contact of themselves"),
        made<T>("conforming_pairs_range", "2.5 and 97.5 % of this number when inputs are drawn within their ±",
                [](const T& of) {
                    return std::vector{of.conforming_range.lower, of.conforming_range.upper};
                }),
        inner<&T::conforming_range>(),
        part<T>("rankings", "models of W_ret at pull-off", rankings),
        field<&T::pairs_by_area>("pairs_by_area", "pairs whose loops' area is known"),
        field<&T::elastomers>("elastomers", "what elastomers do in time"),
        field<&T::joint>("joint_fit",
                         "one fit of all loops, behind the pairs' decompositions; null where there are too few"),
        field<&T::deciding>("deciding_pair",
                            "the pair on which the best law and the likeliest not told apart from it differ most; null "
                            "where there is none")
            .or_null(),
        field<&T::smooth_limits>(
            "smooth_limits",
            "every model of the ranking of all pairs on the smooth reference of every elastomer: r = "
            "1, U_el = 0"),
        field<&T::alerts>("alerts", "what the reader must know"),
        field<&T::trials>("trials", "what became of laws that were planted").with(Missing::left_out),
        field<&T::pairs>("pairs", "one entry a surface and elastomer"),
        field<&T::skipped>("skipped", "pairs of which nothing can be said"),
    };
    static constexpr Description description{"", "retraction models and predictions of all pairs", rows};
};
static_assert(complete<study::Hysteresis>);

}  // namespace setae::fields
