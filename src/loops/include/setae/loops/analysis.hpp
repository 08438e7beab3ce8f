// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/contact/relaxation.hpp"
#include "setae/core/quantity.hpp"
#include "setae/loops/contact_point.hpp"
#include "setae/loops/crack_speed_fit.hpp"
#include "setae/loops/energy_ledger.hpp"
#include "setae/loops/jkr_fits.hpp"
#include "setae/loops/loop_energy.hpp"
#include "setae/loops/outcome.hpp"
#include "setae/loops/record_checks.hpp"
#include "setae/loops/retraction.hpp"
#include "setae/loops/segments.hpp"
#include "setae/loops/work_along_retraction.hpp"

namespace setae::loops {

/// Limits beyond which a result carries an alert.
struct AlertLimits {
    double contact_radius_per_sphere_radius = 0.2;    ///< LARGE_STRAIN
    double contact_radius_per_thickness = 0.1;        ///< THIN_LAYER
    double contact_radius_per_unknown_height = 0.01;  ///< HEIGHT_UNKNOWN, of R: E* from F–δ is then 1 % high and more
    double tabor_parameter = 5.0;                     ///< TABOR_RANGE: JKR holds above
    double relative_residual = 0.015;                 ///< POOR_FIT: rms residual over the fitted range, beyond noise
    double relative_misfit = 0.003;                   ///< BEYOND_NOISE: likewise
    double work_deviations = 3.0;                     ///< WORK_NEGATIVE: W below 0 by so many standard errors
    double drift_share = 0.05;                        ///< FORCE_DRIFT: of the largest tension
    double noise_share = 0.05;                        ///< NOISY_RECORD: of largest tension or penetration
    double contact_point_share = 0.05;                ///< CONTACT_POINT_SPREAD: of the largest penetration
    double loop_sampling_share = 0.05;                ///< LOOP_UNDERSAMPLED: sampling error over energy
    double stiffness_ratio = 10.0;                    ///< STIFFNESS_UNRESOLVED: contact over machine stiffness
    double pinned_modulus_ratio = 1.5;                ///< of E* of a later press or release to that of first loading
    double frames_missing = 0.05;                     ///< FRAME_MISSING: share of the frames in contact
    double contact_modulus_least = 1e3, contact_modulus_most = 1e12;  ///< UNITS_IMPLAUSIBLE outside [Pa]
    double work_of_adhesion_most = 10.0;                              ///< UNITS_IMPLAUSIBLE above [J/m²]
    double work_spread = 0.2;  ///< RANGE_SENSITIVE: spread of W over the fit ranges tried, over W
};

struct AnalysisOptions {
    SegmentOptions segments;
    Index samples_dropped = 3;  ///< after the jump-in; the result depends on it, see BranchAnalysis::sensitivity
    std::vector<Index> sensitivity_dropped{0, 3, 10, 30};
    bool effective_variance = true;  ///< fits allow for the errors of force too, where they are known
    double displacement_drift_rate =
        0.0;                       ///< [m/s] of the displacement where a reference tells it, such as thermal drift
    bool leave_pinned_out = true;  ///< the unloading fits begin where the contact edge lets go
    std::optional<double> contact_radius_noise;       ///< σ_a [m]; else from the radii's second differences
    std::optional<double> machine_stiffness;          ///< [N/m] where `displacement` is the stage's: δ = stage − F/k
    double machine_stiffness_standard_error = 0.0;    ///< [N/m]
    ContactPointChoice contact_point;                 ///< where F–δ fits take the contact point from
    double true_area_ratio = 1.0;                     ///< r of the hard surface, for losses per true area
    Index retraction_points = 6;                      ///< of (S2)
    bool retraction_modulus_free = false;             ///< E* of (S2) fitted, not taken from loading
    Estimate interaction_range{.value = 0.3e-9};      ///< z0 of the Tabor parameter [m]
    std::vector<contact::RelaxationTerm> relaxation;  ///< by which the bulk relaxes: LoopAnalysis::bulk
    AlertLimits limits;
};

/// Samples a fit rests on.
struct FitRange {
    std::string name;           ///< such as "loading, from 3 samples after jump-in to the largest force"
    Index first = 0, last = 0;  ///< samples of the record
    Index n = 0;               ///< fewer than last − first + 1 where partial releases or missing frames were left out
    double force_first = 0.0;  ///< [N]
    double force_last = 0.0;   ///< [N]
};

/// E* and W with so many samples dropped after the jump-in.
struct RangeSensitivity {
    Index dropped = 0;
    Outcome<JkrFit> fit;
};

/// All routes to E* and W on one branch, side by side.
struct BranchAnalysis {
    FitRange range;
    Outcome<JkrFit> radius_force;                     ///< Eq. (1)
    Outcome<JkrFit> radius_force_effective_variance;  ///< Eq. (1), errors in both
    Outcome<JkrFit> linear_form;
    Outcome<JkrFit> force_displacement;
    Outcome<JkrFit> joint;  ///< force, displacement and contact radius together
    Outcome<PointwiseModulus> pointwise;
    EnergyReleaseRate energy_release_rate;      ///< of measured radii on unloading with E* of loading
    std::vector<RangeSensitivity> sensitivity;  ///< empty on unloading
    bool effective_variance_first = false;

    /// Eq. (1) where the contact radius was measured, else force against displacement.
    [[nodiscard]] const JkrFit& primary() const;
};

/// The size of the contact at the largest force, and what a smooth ideal sphere would lose.
struct LoopContext {
    /// [m]: loading fit at the largest force, moved to the last five frames before unloading, at the end of a hold
    double largest_contact_radius = 0.0;
    bool radius_measured = false;           ///< else from the fit alone
    double largest_contact_area = 0.0;      ///< π a_max² [m²]
    double ideal_smooth_sphere_loss = 0.0;  ///< of the jumps under fixed grips, with E* and W of loading [J]
    Estimate tabor_parameter;               ///< with W and E* of loading; errors of that fit and of the range
    std::string
        applicable_model;  ///< a sentence: which model of adhesion applies at the largest force; empty where W <= 0
};

/// One press and release. The first loading of a contact and the release that parts it are JKR branches; a partial
/// release, and the press after it, are only where their E* agrees with that of first loading: where the contact edge
/// is pinned, the contact answers with its stiffness at constant radius, and W would mean nothing.
struct CycleAnalysis {
    Cycle cycle;
    Outcome<BranchAnalysis> loading;
    Outcome<BranchAnalysis> unloading;
    Outcome<double> energy;              ///< ∮F dδ of the cycle [J]
    double energy_standard_error = 0.0;  ///< [J]; NaN where unknown
};

/// What the machine's stiffness, known within its standard error, leaves open.
struct ComplianceEffect {
    Estimate stiffness;           ///< k as given [N/m]
    double modulus_change = 0.0;  ///< of E* from F–δ of loading, k one standard error higher [Pa]
    double work_change = 0.0;     ///< of W likewise [J/m²]
    double energy_change = 0.0;   ///< of the energy of the approach [J]; that of the closed loop does not change
};

/// A quantity at the beginning and at the end of a stretch: means of a tenth of its samples each.
struct Change {
    Estimate first, last;
};

/// What changes while the force is held: creep, and adhesion that grows with the time of contact.
struct HoldGrowth {
    IndexRange samples;
    double duration = 0.0;                   ///< [s]; NaN without time
    Change force;                            ///< [N]
    std::optional<Change> displacement;      ///< [m], where measured
    std::optional<Change> contact_radius;    ///< [m], where measured
    std::optional<Change> work_of_adhesion;  ///< G of the measured radii with E* of loading [J/m²]
};

/// All that one touch tells.
struct ContactAnalysis {
    BranchAnalysis loading;             ///< to where a hold begins, partial releases left out
    std::optional<HoldGrowth> hold;     ///< where the force is held
    std::optional<IndexRange> pinned;   ///< after the last press, while the contact radius stays at its largest
    Outcome<BranchAnalysis> unloading;  ///< behind the pinned stretch where that is left out
    Outcome<PullOff> pull_off;
    Outcome<RetractionFit> retraction;
    Outcome<WorkAlongRetraction> work_along_retraction;  ///< from where the edge lets go
    Outcome<LoopEnergy> loop;
    LoopContext context;
    Outcome<ContactPoints> contact_points;
    Outcome<EnergyLedger> ledger;
    std::optional<ComplianceEffect> compliance;  ///< where the machine's stiffness has a standard error
};

/// What a bulk that relaxes does to a contact, contact::relaxation_force().
struct BulkRelaxation {
    double energy_loss = 0.0;    ///< ∮ F₁ dδ [J], part of the loop's
    double largest_force = 0.0;  ///< |F₁| [N]
};

/// A record: its first contact in full, and what there is beside it.
struct LoopAnalysis : ContactAnalysis {
    Loop corrected;  ///< the record as analysed: force counted from its zero, drift and the machine's own deflection
                     ///< taken off
    ForceZero force_zero;  ///< what was taken off the force
    Segments segments;
    std::vector<Outcome<ContactAnalysis>> further_contacts;  ///< of segments.contacts 1, 2, …
    std::vector<CycleAnalysis> cycles;
    std::vector<ForceStep> steps_in_contact;  ///< sudden changes of the force
    RecordFaults faults;
    /// Where a relaxation is stated. F₁ is taken off the force before everything else is found in it; the loop's energy
    /// has what it costs.
    std::optional<BulkRelaxation> bulk;
    std::vector<Alert> alerts;
};

/// Everything that one contact experiment tells: segments, fits of both branches, pull-off, loop energy, alerts.
///
/// `subject` names the loop in the alerts.
/// @throws InvalidArgument for impossible bodies or series; UndefinedDataError where there is no contact to analyse
/// (see find_segments) or the loading branch has too few samples. A missing retraction is no error: see the reasons.
[[nodiscard]] LoopAnalysis analyse(const Loop& loop, const LensAndCounterBody& bodies,
                                   const AnalysisOptions& options = {}, const std::string& subject = "loop");

enum class LoopBranch { loading, unloading };

/// The samples that the fits of a branch of the first contact rest on.
struct BranchSamples {
    BranchData data;  ///< force counted from its zero
    Array1D time;     ///< [s]; empty where not recorded
};

/// @throws UndefinedDataError with the analysis' reason where it has no such branch.
[[nodiscard]] BranchSamples branch_samples(const LoopAnalysis& analysis, LoopBranch branch,
                                           const AnalysisOptions& options);

/// The samples of the unloading branch of the first contact from the last press on, the pinned stretch included, with
/// and without a camera frame.
/// @throws UndefinedDataError where it has no such branch, or the record no time or no measured contact radius.
[[nodiscard]] RecedingEdge receding_edge(const LoopAnalysis& analysis, const AnalysisOptions& options);

}  // namespace setae::loops
