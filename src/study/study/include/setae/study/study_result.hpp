// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/adhesion/balance_comparison.hpp"
#include "setae/adhesion/balance_draws.hpp"
#include "setae/adhesion/contact_scales.hpp"
#include "setae/adhesion/input_profile.hpp"
#include "setae/adhesion/left_out.hpp"
#include "setae/adhesion/pair_fit.hpp"
#include "setae/adhesion/partial_contact.hpp"
#include "setae/adhesion/predicted_loop.hpp"
#include "setae/adhesion/prediction.hpp"
#include "setae/adhesion/prediction_test.hpp"
#include "setae/adhesion/scale_balance.hpp"
#include "setae/core/boxed.hpp"
#include "setae/core/traced_value.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/loops/reference_loop.hpp"
#include "setae/statistics/equivalence.hpp"
#include "setae/statistics/mixed_model.hpp"
#include "setae/study/hysteresis.hpp"
#include "setae/study/loop_dependence.hpp"
#include "setae/study/provenance.hpp"
#include "setae/study/run_options.hpp"
#include "setae/study/study.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::study {

/// One loop file of a study, or the reason of its failure. Standard errors in `analysis` are those of the loop's own
/// noise; those of the study's inputs, including the stiffness of the testing machine, are in `dependence` only.
struct ExperimentResult {
    ExperimentInput input;  ///< its options in units of the record as analysed, with calibrations applied
    loops::LensAndCounterBody bodies;
    std::string error;
    Boxed<loops::LoopAnalysis> analysis;
    LoopDependence dependence;  ///< dependence of its numbers on inputs that it shares with other loops
    Boxed<LoopModels> models;   ///< on request of the study
    /// G(v) of the retracting edge, for loops on the smooth reference
    Boxed<loops::Outcome<loops::CrackSpeedFit>> edge_speed;
    std::vector<Alert> alerts;

    [[nodiscard]] bool failed() const { return !error.empty(); }
};

/// An elastomer with the modulus the study uses and a check of plausibility.
struct ElastomerResult {
    ElastomerInput input;
    Estimate youngs_modulus;  ///< [Pa]: stated in the study, else the mean of the loops on it; 0 where neither is known
    bool modulus_from_loops = false;
    Estimate contact_modulus;  ///< E* with the rough solid [Pa]
    /// The same two with all their inputs: E itself where the study states it; else "fit of FILE" of every loop, which
    /// W_app of its pair shares, "E of NAME, loops" for additional scatter, and inputs that the loops share. E* from E
    /// and ν.
    TracedValue traced_youngs_modulus, traced_contact_modulus;
    std::optional<double> network_modulus;                       ///< ρRT/M_c [Pa]
    std::optional<loops::Outcome<loops::GlobalFit>> shared_fit;  ///< shared fit of the loops on it that request one
    std::vector<Alert> alerts;

    /// Inputs of the balances: E* and γ1 with all their inputs, by their names in the study, else as inputs of this
    /// elastomer.
    [[nodiscard]] adhesion::SoftSide soft_side() const;
    /// R of its sphere with all its inputs. @throws InternalError where the study gives none.
    [[nodiscard]] TracedValue traced_radius() const;
};

/// One quantity of all loops on one elastomer, and its analysis by a mixed model: the measured values of its pairs.
struct ElastomerReplicates {
    std::string elastomer;
    std::string symbol;              ///< such as "W_app"
    statistics::ReplicateData data;  ///< levels surface, lens, spot; rows named by their files
    loops::Outcome<statistics::MixedModel> model;
};

/// W_ret along the retraction: means over the loops of a pair with this result.
struct PairWorkAlong {
    Estimate at_pull_off, at_largest_contact;  ///< [J/m²]
    Estimate slope;                            ///< dW_ret/da [J/m³]
    Estimate energy_loss, energy_recorded;     ///< by the line, and of these loops as recorded [J]
    int loops = 0;
};

/// One surface × elastomer pair: measured values and predictions from roughness.
struct PairResult {
    std::string surface;
    std::string elastomer;
    std::optional<Estimate> approach;    ///< W_app of loading [J/m²]
    std::optional<Estimate> pull_off;    ///< W by Eq. S1 [J/m²]
    std::optional<Estimate> retraction;  ///< W by Eq. S2 [J/m²]
    std::optional<Estimate> loss;        ///< E_loss [J]
    /// ∂value/∂input × standard error by the inputs that loops share. The four standard errors above are those of the
    /// loops' own noise and scatter; they do not include these contributions.
    Components approach_inputs, pull_off_inputs, retraction_inputs, loss_inputs;
    /// The part of `approach`'s own standard error that it shares with E of the elastomer where that comes from the
    /// same fits: "fit of FILE" of each loop. Empty where the study states E.
    Components approach_fits;
    std::optional<double> bulk_loss;     ///< part of `loss` by the stated relaxation of the bulk [J]
    std::optional<double> contact_area;  ///< π a_max² at maximum preload [m²]
    Components contact_area_inputs;      ///< its inputs: those that loops share, and "fit of FILE" of each loop [m²]
    std::optional<double> ideal_loss;    ///< energy loss of a smooth sphere with this W and E* [J]
    /// share of the hysteresis W_ret − W_app that the smooth reference has, too
    std::optional<Estimate> reference_share;
    loops::Outcome<PairWorkAlong> work_along_retraction;
    int experiments = 0;  ///< number of loops of the measured values; 0 for published ones

    double area_ratio = 1.0;
    Estimate stored_energy;  ///< U_el/A_app [J/m²]
    /// full-contact balance (Eq. 7); its errors are those of Eq. 7 for a measured pair, and include the scatter of
    /// measured pairs about Eq. 7 for another pair
    std::optional<adhesion::PredictedWork> modified;
    std::optional<adhesion::PredictedWork> persson_tosatti;      ///< (S13)
    std::optional<adhesion::PredictedWork> without_area_change;  ///< (2)
    adhesion::UnloadedContact contact;  ///< contact without load, from simulated patches with equal stored energy
    /// W_app of that contact; the full-contact balance (Eq. 7) in full contact [J/m²]
    std::optional<TracedValue> partial_contact;
    std::optional<adhesion::PairPoint> line;    ///< Eq. 7 as a line in W_int; without measured values
    std::optional<adhesion::DrawnValue> drawn;  ///< max(0, Eq. 7) by draws of all inputs [J/m²]
    /// true-area loss (Eq. 10) at W_int and the contact area, measured or of `loop`, with all its inputs [J]
    std::optional<TracedValue> predicted_loss;
    std::optional<adhesion::PredictedLoop> loop;  ///< where sphere and preload are given and there is contact
    /// W_app by Eq. 7 with waves beyond both ends of the surface's data [J/m²]
    std::optional<Estimate> with_unmeasured_waves;
    /// where the soft side has a strain-dependent surface or interfacial energy
    std::optional<adhesion::ApparentWork> general;
    std::optional<adhesion::PredictionBudget> budget;  ///< budget of `modified`
    std::optional<adhesion::ScaleBalance> scales;
    adhesion::ContactShares seen;  ///< shares of the surface's spectrum that act in this contact
    std::vector<Alert> alerts;

    /// The measured values with all their inputs, each once: the inputs, the fits, and the remaining own standard error
    /// as an additional input, "noise of W_app on SURFACE × ELASTOMER" (W_po, W_ret, E_loss), or the name of a
    /// published value in the study. Empty where the value is not measured.
    [[nodiscard]] std::optional<TracedValue> traced_approach() const;
    [[nodiscard]] std::optional<TracedValue> traced_pull_off() const;
    [[nodiscard]] std::optional<TracedValue> traced_retraction() const;
    [[nodiscard]] std::optional<TracedValue> traced_loss() const;

    /// Formation of full contact for all of its roughness; for a pair with `scales`.
    [[nodiscard]] adhesion::Closing closing() const {
        using adhesion::Closing;
        return scales->bridging                            ? Closing::opens
               : scales->closing_pressure.maxCoeff() > 0.0 ? Closing::under_pressure
                                                           : Closing::spontaneous;
    }
};

/// A smooth reference: from loops, or published.
struct ReferenceResult {
    std::string elastomer;
    std::string stage;
    Estimate approach, retraction;          ///< W of both branches [J/m²]
    std::optional<Estimate> excess_energy;  ///< [J]
    std::optional<double> ideal_loss;       ///< [J]
    std::optional<double> loss_ratio;       ///< mean rough loss on this elastomer divided by the excess energy
    std::optional<double> contact_area;     ///< contact area at the largest preload [m²]
    /// W of retraction minus that of approach, compared with the study's margin [J/m²]
    statistics::Equivalence hysteresis;
    /// excess energy beyond the ideal loss divided by contact area [J/m²]; where both are known
    std::optional<statistics::Equivalence> loss_per_area;
};

/// W of both branches and excess energy after the rough loops minus before.
struct ReferenceDrift {
    std::string elastomer;
    loops::ReferenceChange change;
};

template <class T>
using Outcome = loops::Outcome<T>;

/// W_int with every spectrum cut at one shortest wavelength.
struct CutoffPoint {
    double shortest_wavelength = 0.0;  ///< [m]
    adhesion::WorkFit modified, persson_tosatti;
    std::vector<roughness::SpectralParameters> surfaces;  ///< in the order of StudyResult::surfaces
};

/// One balance for all pairs, for one choice of the cut and of γ1.
struct ComparedBalance {
    std::string balance;               ///< "modified", "partial_contact", "without_area_change", "persson_tosatti",
                                       ///< "free_energies", "strained_interface", "reference_scaled", "pinned_1",
                                       ///< "pinned_2"
    double shortest_wavelength = 0.0;  ///< shortest wavelength of every spectrum [m]; 0: as in the study
    double surface_energy_factor = 1;  ///< factor on γ1 of every elastomer
    adhesion::BalanceScore score;
};

/// Conclusions from surfaces, elastomers and loops, by one spectrum of each surface.
struct Conclusions {
    bool of_averages = false;  ///< whether the spectra are averages over measurements; else those used first
    std::vector<PairResult> pairs;
    Outcome<Estimate> work_of_adhesion;  ///< W_int of the predictions [J/m²]
    std::string work_of_adhesion_source;
    TracedValue traced_work_of_adhesion;                ///< W_int with all its inputs; value 0 where there is none
    adhesion::BalanceDraws draws;                       ///< draws of W_int; those of predictions are in their pairs
    std::vector<adhesion::LeftOutPrediction> left_out;  ///< leave-one-out predictions by Eq. 7, where it was fitted
    /// profiles of Eq. 7 over stated inputs of elastomers, loops and instruments
    std::vector<adhesion::InputProfile> profiles;
    Outcome<adhesion::WorkFit> modified;
    Outcome<adhesion::WorkFit> persson_tosatti;
    Outcome<adhesion::WorkFit> without_area_change;
    Outcome<adhesion::LossFits> loop;
    Outcome<adhesion::FreeEnergyFit> free_energies;
    Outcome<adhesion::StrainedInterfaceFit> strained_interface;
    /// W_int of each elastomer as c times W_app of its smooth reference: c, without unit, in place of W_int.
    Outcome<adhesion::WorkFit> reference_scaled;
    std::vector<ComparedBalance> balances;  ///< first as in the study, then over cuts, then over γ1
    std::vector<CutoffPoint> cutoff_scan;
    Outcome<adhesion::PredictionTest> prediction_test;  ///< test of Eq. 7 with both errors
    std::vector<Alert> failed_parts;                    ///< fits and comparisons that could not be made

    [[nodiscard]] SpectrumMethod method_of(const SurfaceResult& surface) const {
        return of_averages ? SpectrumMethod::average : surface.method;
    }
    [[nodiscard]] const SpectrumResult& spectrum_of(const SurfaceResult& surface) const {
        return of_averages ? surface.average : surface.used();
    }
};

/// E_loss against A_true through the origin.
struct LossSlope {
    Estimate work_per_true_area;  ///< [J/m²]
    int pairs = 0;
};

struct StudyResult : Conclusions {
    Study study;
    std::vector<InputFile> inputs;  ///< every file the study names
    std::vector<SurfaceResult> surfaces;
    std::vector<ElastomerResult> elastomers;
    std::vector<ExperimentResult> experiments;
    std::vector<ElastomerReplicates> replicates;  ///< for elastomers whose loops name a lens, a spot or an exclusion
    std::vector<ReferenceResult> references;
    std::vector<ReferenceDrift> reference_drifts;
    std::vector<Alert> alerts;
    std::optional<Conclusions> by_average;  ///< conclusions with averages, where likelihoods are used first
    Outcome<Hysteresis> hysteresis;         ///< without trials
    /// Loss slope of loops with the measured works, for comparison with published or measured energies.
    std::optional<LossSlope> loss_slope_of_works;

    /// Number of measurements, surfaces, their likelihoods, experiments, elastomers, pairs and comparisons that failed.
    [[nodiscard]] int failures() const;
    [[nodiscard]] std::vector<Alert> alerts_of_failed_parts() const;  ///< warnings of elastomers, pairs and comparisons
    [[nodiscard]] int successes() const;  ///< number of surfaces and experiments that succeeded
    /// @throws InternalError for a name that is not in the study (both).
    [[nodiscard]] const SurfaceResult& surface(const std::string& name) const;
    [[nodiscard]] const ElastomerResult& elastomer(const std::string& name) const;
};

/// Runs a study. Failures of single items are listed in the result and do not stop the rest.
/// The result does not depend on the options: neither on threads nor on the content of a store.
/// @throws Cancelled where the options say so; finished results are in the store.
[[nodiscard]] StudyResult run_study(Study study, const RunOptions& options = {});

/// The result for a study without loops whose only surface is analysed already.
[[nodiscard]] StudyResult predicted_study(Study study, SurfaceResult surface);

/// One step of a study and whether its result is already in the store.
struct PlannedStep {
    std::string stage, item;  ///< as Progress
    std::string error;        ///< reason of its failure, as far as its files show it
    bool cached = false;
};

/// Steps that run_study() would do: files are opened, not analysed.
[[nodiscard]] std::vector<PlannedStep> planned_steps(const Study& study, const RunOptions& options = {});

}  // namespace setae::study
