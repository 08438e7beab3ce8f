// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
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
    std::string decomposed_by;                        ///< name of the likeliest model, which `decomposition` is of
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
inline constexpr int most_ranked_by_studies = 48;

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
