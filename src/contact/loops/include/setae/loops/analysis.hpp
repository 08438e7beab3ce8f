// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/contact/relaxation.hpp"
#include "setae/core/quantity.hpp"
#include "setae/fields/describe.hpp"
#include "setae/loops/contact_point.hpp"
#include "setae/loops/crack_speed_fit.hpp"
#include "setae/loops/energy_budget.hpp"
#include "setae/loops/jkr_fits.hpp"
#include "setae/loops/loop_energy.hpp"
#include "setae/loops/outcome.hpp"
#include "setae/loops/record_checks.hpp"
#include "setae/loops/retraction.hpp"
#include "setae/loops/segments.hpp"
#include "setae/loops/work_along_retraction.hpp"

namespace setae::loops {

/// Limits beyond which a result has a warning.
struct AlertLimits {
    double contact_radius_per_sphere_radius = 0.2;  ///< LARGE_STRAIN
    double contact_radius_per_thickness = 0.1;      ///< THIN_LAYER
    /// HEIGHT_UNKNOWN, divided by R: E* from F–δ is then at least 1 % too high
    double contact_radius_per_unknown_height = 0.01;
    double tabor_parameter = 5.0;       ///< TABOR_RANGE: JKR applies above
    double relative_residual = 0.015;   ///< POOR_FIT: rms residual divided by the fitted range, beyond noise
    double relative_misfit = 0.003;     ///< BEYOND_NOISE: rms residual divided by the fitted range
    double work_deviations = 3.0;       ///< WORK_NEGATIVE: W below 0 by this number of standard errors
    double drift_share = 0.05;          ///< FORCE_DRIFT: share of the largest tension
    double noise_share = 0.05;          ///< NOISY_RECORD: share of largest tension or penetration
    double contact_point_share = 0.05;  ///< CONTACT_POINT_SPREAD: share of the largest penetration
    double loop_sampling_share = 0.05;  ///< LOOP_UNDERSAMPLED: sampling error divided by energy
    double stiffness_ratio = 10.0;      ///< STIFFNESS_UNRESOLVED: contact stiffness divided by machine stiffness
    double pinned_modulus_ratio = 1.5;  ///< E* of a later loading or unloading divided by that of first loading
    double frames_missing = 0.05;       ///< FRAME_MISSING: share of the frames in contact
    double contact_modulus_min = 1e3, contact_modulus_max = 1e12;  ///< UNITS_IMPLAUSIBLE outside [Pa]
    double work_of_adhesion_max = 10.0;                            ///< UNITS_IMPLAUSIBLE above [J/m²]
    double work_spread = 0.2;  ///< RANGE_SENSITIVE: spread of W over the fit ranges, divided by W
};

struct AnalysisOptions {
    SegmentOptions segments;
    Index samples_dropped = 3;  ///< number after the jump-in; the result depends on it, see BranchAnalysis::sensitivity
    std::vector<Index> sensitivity_dropped{0, 3, 10, 30};
    bool effective_variance = true;  ///< whether fits take the errors of force into account, too, where they are known
    double displacement_drift_rate =
        0.0;  ///< drift rate [m/s] of the displacement from a reference measurement, such as thermal drift
    bool leave_pinned_out = true;  ///< whether the unloading fits begin where the contact edge starts to move
    std::optional<double> contact_radius_noise;  ///< σ_a [m]; else from the radii's second differences
    std::optional<double> machine_stiffness;  ///< [N/m] where `displacement` is that of the stage: δ = stage − F/k
    double machine_stiffness_standard_error = 0.0;    ///< [N/m]
    ContactPointChoice contact_point;                 ///< contact point of F–δ fits
    double true_area_ratio = 1.0;                     ///< r of the hard surface, for losses per true area
    Index retraction_points = 6;                      ///< number of points for Eq. S2
    bool retraction_modulus_free = false;             ///< whether E* of Eq. S2 is fitted, not taken from loading
    Estimate interaction_range{.value = 0.3e-9};      ///< z0 of the Tabor parameter [m]
    std::vector<contact::RelaxationTerm> relaxation;  ///< terms of the bulk relaxation: LoopAnalysis::bulk
    AlertLimits limits;
};

/// Samples of a fit.
struct FitRange {
    std::string name;           ///< such as "loading, from 3 samples after jump-in to the largest force"
    Index first = 0, last = 0;  ///< samples of the record
    Index n = 0;               ///< fewer than last − first + 1 where partial releases or missing frames were left out
    double force_first = 0.0;  ///< [N]
    double force_last = 0.0;   ///< [N]
};

/// E* and W with a given number of samples dropped after the jump-in.
struct RangeSensitivity {
    Index dropped = 0;
    Outcome<JkrFit> fit;
};

/// All routes to E* and W on one branch.
struct BranchAnalysis {
    FitRange range;
    Outcome<JkrFit> radius_force;                     ///< Eq. (1)
    Outcome<JkrFit> radius_force_effective_variance;  ///< Eq. 1, errors in both
    Outcome<JkrFit> linear_form;
    Outcome<JkrFit> force_displacement;
    Outcome<JkrFit> joint;  ///< force, displacement and contact radius together
    Outcome<PointwiseModulus> pointwise;
    EnergyReleaseRate energy_release_rate;      ///< for measured radii on unloading with E* of loading
    std::vector<RangeSensitivity> sensitivity;  ///< empty on unloading
    bool effective_variance_first = false;

    /// Eq. 1 where the contact radius was measured, else force against displacement.
    [[nodiscard]] const JkrFit& primary() const;
};

/// A route from the samples of a branch to E* and W.
struct FitRoute {
    Outcome<JkrFit> BranchAnalysis::*fit;
    const char* name;   ///< JkrFit::method
    const char* title;  ///< title in figures
};
inline constexpr std::array<FitRoute, 5> fit_routes{
    {{&BranchAnalysis::radius_force, "radius_force", "a(F)"},
     {&BranchAnalysis::radius_force_effective_variance, "radius_force_effective_variance", "a(F), errors in both"},
     {&BranchAnalysis::linear_form, "linear_form", "linear form"},
     {&BranchAnalysis::force_displacement, "force_displacement", "F(δ)"},
     {&BranchAnalysis::joint, "joint", "joint"}}};

/// The size of the contact at the largest force, and the loss of a smooth ideal sphere.
struct LoopContext {
    /// [m]: loading fit at the largest force, shifted to the last five frames before unloading, at the end of a hold
    double largest_contact_radius = 0.0;
    bool radius_measured = false;           ///< false: from the fit only
    double largest_contact_area = 0.0;      ///< π a_max² [m²]
    double ideal_smooth_sphere_loss = 0.0;  ///< loss of the jumps under fixed grips, with E* and W of loading [J]
    Estimate tabor_parameter;               ///< with W and E* of loading; errors of that fit and of the range
    std::string applicable_model;  ///< sentence: applicable model of adhesion at the largest force; empty where W <= 0
};

/// One loading and unloading. The first loading of a contact and the unloading that ends it are JKR branches; a partial
/// unloading, and the loading after it, are analysed only where their E* agrees with that of first loading. Where the
/// contact edge is pinned, the contact has the stiffness of a constant radius, and W is undefined.
struct CycleAnalysis {
    Cycle cycle;
    Outcome<BranchAnalysis> loading;
    Outcome<BranchAnalysis> unloading;
    Outcome<double> energy;              ///< ∮F dδ of the cycle [J]
    double energy_standard_error = 0.0;  ///< [J]; NaN where unknown
};

/// Effect of the standard error of the stiffness of the testing machine.
struct ComplianceEffect {
    Estimate stiffness;           ///< k as given [N/m]
    double modulus_change = 0.0;  ///< change of E* from F–δ of loading for k one standard error higher [Pa]
    double work_change = 0.0;     ///< change of W for k one standard error higher [J/m²]
    double energy_change = 0.0;   ///< change of the energy of the approach [J]; that of the closed loop does not change
};

/// A quantity at the beginning and at the end of a section: means of a tenth of its samples each.
struct Change {
    Estimate first, last;
};

/// Changes while the force is held: creep, and adhesion that grows with the time of contact.
struct HoldGrowth {
    IndexRange samples;
    double duration = 0.0;                   ///< [s]; NaN without time
    Change force;                            ///< [N]
    std::optional<Change> displacement;      ///< [m], where measured
    std::optional<Change> contact_radius;    ///< [m], where measured
    std::optional<Change> work_of_adhesion;  ///< G of the measured radii with E* of loading [J/m²]
};

/// All results of one contact.
struct ContactAnalysis {
    BranchAnalysis loading;             ///< to where a hold begins, partial releases left out
    std::optional<HoldGrowth> hold;     ///< where the force is held
    std::optional<IndexRange> pinned;   ///< after the last loading, while the contact radius stays at its largest
    Outcome<BranchAnalysis> unloading;  ///< after the pinned section where that is left out
    Outcome<PullOff> pull_off;
    Outcome<RetractionFit> retraction;
    Outcome<WorkAlongRetraction> work_along_retraction;  ///< from where the edge starts to move
    Outcome<LoopEnergy> loop;
    LoopContext context;
    Outcome<ContactPoints> contact_points;
    Outcome<EnergyBudget> budget;
    std::optional<ComplianceEffect> compliance;  ///< where the stiffness of the testing machine has a standard error
};

/// Effect of bulk relaxation on a contact, contact::relaxation_force().
struct BulkRelaxation {
    double energy_loss = 0.0;    ///< ∮ F₁ dδ [J], part of the loop's
    double largest_force = 0.0;  ///< |F₁| [N]
};

/// Results of a record: its first contact in full, and further parts.
struct LoopAnalysis : ContactAnalysis {
    /// the record as analysed: force relative to its zero, drift and deflection of the testing machine subtracted
    Loop corrected;
    ForceZero force_zero;  ///< zero that was subtracted from the force
    Segments segments;
    std::vector<Outcome<ContactAnalysis>> further_contacts;  ///< contacts 1, 2, … of segments.contacts
    std::vector<CycleAnalysis> cycles;
    std::vector<ForceStep> steps_in_contact;  ///< sudden changes of the force
    RecordFaults faults;
    /// Where a relaxation is stated. F₁ is subtracted from the force before all other analysis; the loop's energy
    /// includes its loss.
    std::optional<BulkRelaxation> bulk;
    std::vector<Alert> alerts;
};

/// Analyses one contact experiment: segments, fits of both branches, pull-off, loop energy, warnings.
///
/// `subject` names the loop in the warnings.
/// @throws InvalidArgument for impossible bodies or series; UndefinedDataError where there is no contact to analyse
/// (see find_segments) or the loading branch has too few samples. A missing retraction is no error: see the reasons.
[[nodiscard]] LoopAnalysis analyse(const Loop& loop, const LensAndCounterBody& bodies,
                                   const AnalysisOptions& options = {}, const std::string& subject = "loop");

enum class LoopBranch { loading, unloading };

/// The samples of the fits of a branch of the first contact.
struct BranchSamples {
    BranchData data;  ///< force relative to its zero
    Array1D time;     ///< [s]; empty where not recorded
};

/// @throws UndefinedDataError with the analysis' reason where it has no such branch.
[[nodiscard]] BranchSamples branch_samples(const LoopAnalysis& analysis, LoopBranch branch,
                                           const AnalysisOptions& options);

/// The samples of the unloading branch of the first contact from the last loading on, including the pinned section,
/// with and without a camera frame.
/// @throws UndefinedDataError where it has no such branch, or the record no time or no measured contact radius.
[[nodiscard]] RetractingEdge retracting_edge(const LoopAnalysis& analysis, const AnalysisOptions& options);

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::FitRange> {
    using T = loops::FitRange;
    static constexpr std::array rows{
        field<&T::name>("name", "name in the file, or given by the user"),
        field<&T::first>("first", "index of the first sample"),
        field<&T::last>("last", "index of the last sample"),
        field<&T::n>("n", "number of points, measurements or pairs"),
        quantity<&T::force_first>("force_first", "F", "N", "force at the first sample").as("force"),
        quantity<&T::force_last>("force_last", "F", "N", "force at the last sample").as("force"),
    };
    static constexpr Description description{"", "range of the fitted samples", rows};
};
static_assert(complete<loops::FitRange>);

template <>
struct Described<loops::RangeSensitivity> {
    using T = loops::RangeSensitivity;
    static constexpr std::array rows{
        field<&T::dropped>("samples_dropped", "number of dropped samples"),
        fields_of<T>(Described<loops::JkrFit>::moduli,
                     [](const T& of) -> const loops::Outcome<loops::JkrFit>& { return of.fit; }),
        made<T>("reason", "reason for which it is missing or left out",
                [](const T& of) { return of.fit ? std::nullopt : std::optional(of.fit.reason); }),
        inner<&T::fit>(),
    };
    static constexpr Description description{"", "fit without some samples at the low-load end", rows};
};
static_assert(complete<loops::RangeSensitivity>);

template <>
struct Described<loops::BranchAnalysis> {
    using T = loops::BranchAnalysis;
    static constexpr std::array route_rows{
        field<&T::radius_force>("radius_force", "fit of contact radius against force"),
        field<&T::radius_force_effective_variance>("radius_force_effective_variance",
                                                   "fit of contact radius against force with errors of both"),
        field<&T::linear_form>("linear_form", "fit of the linear form of contact radius against force"),
        field<&T::force_displacement>("force_displacement", "fit of force against displacement"),
        field<&T::joint>("joint", "fit of force, displacement and contact radius together"),
        field<&T::pointwise>("pointwise", "E* of each single point"),
    };
    static constexpr Description routes{"", "fits by each route", route_rows};
    static constexpr std::array rows{
        fields_of<T>(Described<loops::JkrFit>::moduli,
                     [](const T& of) -> const loops::JkrFit& { return of.primary(); }),
        made<T>("method", "route whose results are reported", [](const T& of) { return of.primary().method; }),
        field<&T::range>("range", "range of the fitted samples"),
        part<T>("fits", "fits by each route", routes),
        field<&T::energy_release_rate>("energy_release_rate", "energy release rate G at each point"),
        field<&T::sensitivity>("sensitivity_to_range", "fit without some samples at the low-load end"),
        inner<&T::effective_variance_first>(),
    };
    static constexpr Description description{"branch", "loading or unloading branch of a loop", rows};
};
static_assert(complete<loops::BranchAnalysis>);

template <>
struct Described<loops::ComplianceEffect> {
    using T = loops::ComplianceEffect;
    static constexpr std::array rows{
        quantity<&T::stiffness>("machine_stiffness", "k", "N/m", "stiffness k of the testing machine"),
        quantity<&T::modulus_change>("modulus_change", "E*(k + SE) - E*(k)", "Pa", "change of E*"),
        quantity<&T::work_change>("work_change", "W(k + SE) - W(k)", "J/m2", "change of W"),
        quantity<&T::energy_change>("energy_change", "change of the energy", "J", "change of the energy"),
    };
    static constexpr Description description{
        "compliance", "effect of one standard error of the stiffness of the testing machine", rows};
};
static_assert(complete<loops::ComplianceEffect>);

template <>
struct Described<loops::HoldGrowth> {
    using T = loops::HoldGrowth;
    using Changed = std::optional<loops::Change> T::*;
    /// One end of a quantity that may not be measured.
    static std::optional<Estimate> end(const T& of, Changed changed, Estimate loops::Change::*which) {
        if (!(of.*changed)) return {};
        return (*(of.*changed)).*which;
    }
    static constexpr auto first = &loops::Change::first, last = &loops::Change::last;
    static constexpr std::string_view at_first = "value at the first sample", at_last = "value at the last sample";
    static constexpr std::array rows{
        field<&T::samples>("samples", "first and last sample"),
        quantity<&T::duration>("duration", "t", "s", "duration of the hold"),
        made<T>("force_first", "F", "N", at_first, [](const T& of) { return of.force.first; }),
        made<T>("force_last", "F", "N", at_last, [](const T& of) { return of.force.last; }),
        made<T>("displacement_first", "delta", "m", at_first,
                [](const T& of) { return end(of, &T::displacement, first); }),
        made<T>("displacement_last", "delta", "m", at_last,
                [](const T& of) { return end(of, &T::displacement, last); }),
        made<T>("contact_radius_first", "a", "m", at_first,
                [](const T& of) { return end(of, &T::contact_radius, first); }),
        made<T>("contact_radius_last", "a", "m", at_last,
                [](const T& of) { return end(of, &T::contact_radius, last); }),
        made<T>("work_of_adhesion_first", "W", "J/m2", at_first,
                [](const T& of) { return end(of, &T::work_of_adhesion, first); }),
        made<T>("work_of_adhesion_last", "W", "J/m2", at_last,
                [](const T& of) { return end(of, &T::work_of_adhesion, last); }),
        inner<&T::force>(),
        inner<&T::displacement>(),
        inner<&T::contact_radius>(),
        inner<&T::work_of_adhesion>(),
    };
    static constexpr Description description{"hold", "changes while the load is held", rows};
};
static_assert(complete<loops::HoldGrowth>);

/// The energy of a closed loop and that of an ideal sphere.
struct ClosedLoop {
    loops::LoopEnergy loop;
    double ideal_smooth_sphere = 0.0;  ///< LoopContext::ideal_smooth_sphere_loss [J]
};

template <>
struct Described<ClosedLoop> {
    using T = ClosedLoop;
    static constexpr std::array rows{
        made<T>("energy", "E_loss", "J", "energy of the closed loop, drift removed",
                [](const T& of) { return of.loop.estimate(); })
            .from("closed integral of F d(delta), baseline and linear drift removed"),
        made<T>("energy_without_drift", "E_loss", "J", "energy of the closed loop without removal of drift",
                [](const T& of) { return of.loop.without_drift; }),
        made<T>("standard_error_budget", "contributions to the standard error",
                [](const T& of) { return of.loop.standard_error; }),
        quantity<&T::ideal_smooth_sphere>("ideal_smooth_sphere_loss", "E_ideal", "J",
                                          "energy loss of the jumps of the ideal smooth JKR sphere under fixed grips")
            .from("jumps of the ideal smooth JKR sphere under fixed grips, E* and W of loading"),
        inner<&T::loop>(),
    };
    static constexpr Description description{"loop_energy", "energy of a closed loop", rows};
};
static_assert(complete<ClosedLoop>);

template <>
struct Described<loops::ContactAnalysis> {
    using T = loops::ContactAnalysis;
    static loops::Outcome<ClosedLoop> closed_loop(const T& of) {
        if (!of.loop) return loops::Outcome<ClosedLoop>::missing(of.loop.reason);
        return ClosedLoop{*of.loop, of.context.ideal_smooth_sphere_loss};
    }
    static constexpr Row loop =
        made<T>("loop", "energy of the closed loop", [](const T& of) { return closed_loop(of); });
    static constexpr Row budget = field<&T::budget>("ledger", "energy budget of the loop");
    static constexpr std::array rows{
        field<&T::loading>("loading", "loading branch"),
        field<&T::hold>("hold", "changes while the load is held"),
        field<&T::unloading>("unloading", "unloading branch; null where there is none"),
        field<&T::retraction>("retraction", "W_ret at pull-off from the last points, Eq. S2 of [D19]"),
        field<&T::work_along_retraction>(
            "work_along_retraction",
            "W_ret along the retraction, linear in the contact radius; null where only the pull-off is known"),
        field<&T::pull_off>("pull_off", "smallest force"),
        loop,
        budget,
        field<&T::contact_points>("contact_points", "estimates of the displacement at first contact"),
        field<&T::compliance>("compliance", "effect of one standard error of the stiffness of the testing machine"),
        made<T>("largest_contact_radius", "a_max", "m", "a_max",
                [](const T& of) {
                    return Quantity{
                        .estimate = {.value = of.context.largest_contact_radius},
                        .source = of.context.radius_measured ? "measured" : "JKR at the largest force, loading fit"};
                }),
        made<T>("largest_contact_area", "pi a_max^2", "m2", "π a_max²",
                [](const T& of) { return of.context.largest_contact_area; }),
        made<T>("tabor_parameter", "mu", "1", "Tabor parameter μ; JKR applies for large μ",
                [](const T& of) { return of.context.tabor_parameter; }),
        made<T>("applicable_model", "contact model that applies at this μ",
                [](const T& of) { return of.context.applicable_model; }),
        inner<&T::pinned>(),
        inner<&T::loop>(),
        inner<&T::context>(),
    };
    static constexpr Description description{"contact", "results of one contact", rows};
    static constexpr std::array energy_rows{loop, budget};
    static constexpr Description energies{"", "energies of one contact", energy_rows};
};
static_assert(complete<loops::ContactAnalysis>);

template <>
struct Described<loops::CycleAnalysis> {
    using T = loops::CycleAnalysis;
    static loops::Outcome<Estimate> lost(const T& of) {
        if (!of.energy) return loops::Outcome<Estimate>::missing(of.energy.reason);
        return Estimate{.value = *of.energy, .standard_error = of.energy_standard_error, .method = "error budget"};
    }
    static constexpr Row contact =
        made<T>("contact", "number of the contact, counted from 0", [](const T& of) { return of.cycle.contact; });
    static constexpr Row energy =
        made<T>("energy", "E_loss", "J", "energy of the closed loop", [](const T& of) { return lost(of); });
    static constexpr std::array rows{
        field<&T::loading>("loading", "loading branch"),
        field<&T::unloading>("unloading", "unloading branch; null where there is none"),
        made<T>("loading_samples", "first and last sample", [](const T& of) { return of.cycle.loading; }),
        made<T>("unloading_samples", "first and last sample", [](const T& of) { return of.cycle.unloading; }),
        contact,
        energy,
        inner<&T::cycle>(),
        inner<&T::energy>(),
        inner<&T::energy_standard_error>(),
    };
    static constexpr Description description{"", "cycle of unloading and loading within one contact", rows};
    static constexpr std::array energy_rows{contact, energy};
    static constexpr Description energies{"", "energy of one cycle of unloading and loading", energy_rows};
};
static_assert(complete<loops::CycleAnalysis>);

template <>
struct Described<loops::BulkRelaxation> {
    using T = loops::BulkRelaxation;
    static constexpr std::array rows{
        quantity<&T::energy_loss>("energy_loss", "E_bulk", "J", "∮ F₁ dδ").as("bulk_energy_loss"),
        quantity<&T::largest_force>("largest_force", "F_1", "N", "largest |F₁|")};
    static constexpr Description description{"", "relaxation in the bulk", rows};
};
static_assert(complete<loops::BulkRelaxation>);

/// A later contact of a record, without a copy of the record.
struct FurtherContact {
    const loops::Outcome<loops::ContactAnalysis>* contact;
};

template <>
struct Described<FurtherContact> {
    using T = FurtherContact;
    static constexpr std::array rows{
        made<T>("contact", "number of the contact, counted from 0",
                [](const T& of) -> const loops::Outcome<loops::ContactAnalysis>& { return *of.contact; }),
        inner<&T::contact>(),
    };
    static constexpr Description description{"", "later contact of a record", rows};
};
static_assert(complete<FurtherContact>);

template <>
struct Described<loops::LoopAnalysis> {
    using T = loops::LoopAnalysis;
    static constexpr std::array force_zero_rows{
        fields_of<T>([](const T& of) -> const loops::ForceDrift& { return of.force_zero.drift; }),
        made<T>("steps", "steps of force in free flight, where the record was split",
                [](const T& of) -> const std::vector<loops::ForceStep>& { return of.segments.steps; }),
        field<&T::steps_in_contact>("steps_in_contact", "steps of force within contact"),
    };
    static constexpr Description force_zero{"force_zero", "zero of force and its drift, which were removed",
                                            force_zero_rows};
    static constexpr std::array rows{
        inherited<loops::ContactAnalysis, T>(),
        field<&T::bulk>("bulk_relaxation",
                        "relaxation in the bulk, where it is stated: subtracted from the force before the fits, "
                        "included in the energy of the loop"),
        made<T>("further_contacts", "later contacts in the same record",
                [](const T& of) {
                    std::vector<FurtherContact> contacts;
                    for (const auto& contact : of.further_contacts) contacts.push_back({&contact});
                    return contacts;
                }),
        field<&T::segments>("segments", "segments of the record"),
        part<T>("force_zero", "zero of force and its drift, which were removed", force_zero),
        field<&T::cycles>("cycles", "further loading and unloading within one contact"),
        field<&T::alerts>("alerts", "warnings"),
        inner<&T::corrected>(),
        inner<&T::force_zero>(),
        inner<&T::further_contacts>(),
        inner<&T::faults>(),
    };
    static constexpr Description description{"loop", "results of a loop", rows};
};
static_assert(complete<loops::LoopAnalysis>);

}  // namespace setae::fields
