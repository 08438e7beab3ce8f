// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/contact/elasticity.hpp"
#include "setae/fields/describe.hpp"
#include "setae/loops/loop_energy.hpp"

namespace setae::loops {

/// Work ∫F dδ over a section of a loop with its known errors.
struct WorkEntry {
    IndexRange range;
    double energy = 0.0;  ///< [J]
    LoopErrorBudget standard_error;
};

/// Energy budget of one contact. The parts follow each other and add up to the loop's energy.
struct EnergyBudget {
    Index contact = 0;
    LoopEnergy loop;                   ///< ∮F dδ
    WorkEntry before_contact;          ///< free flight: remainder of noise and drift
    std::optional<WorkEntry> jump_in;  ///< work over the samples of the jump
    WorkEntry approach;                ///< up to the end of the last loading
    WorkEntry retraction;              ///< from there to the jump out; negative where energy is recovered
    std::optional<WorkEntry> jump_out;
    WorkEntry after_contact;
    double recovered_share = 0.0;  ///< −retraction divided by approach

    double ideal_fixed_grips = 0.0;   ///< loss of the smooth JKR sphere with W and E* of loading under fixed grips [J]
    double ideal_this_machine = 0.0;  ///< the loss at the stiffness of the testing machine [J]
    double machine_stiffness = 0.0;   ///< machine stiffness [N/m], infinite for fixed grips

    double largest_contact_area = 0.0;    ///< π a_max² [m²], apparent
    double true_area_ratio = 1.0;         ///< ratio r of the surface
    double loss_per_apparent_area = 0.0;  ///< [J/m²]
    double loss_per_true_area = 0.0;      ///< loss divided by r π a_max² [J/m²]

    /// r π a_max² [m²]. Losses of many loops against it are on a line whose slope is the energy loss per cycle and
    /// area.
    [[nodiscard]] double largest_true_area() const { return true_area_ratio * largest_contact_area; }
};

struct EnergyBudgetInputs {
    contact::AdhesiveContact smooth_sphere;  ///< R, E* and W of loading
    double largest_contact_area = 0.0;       ///< [m²]
    double true_area_ratio = 1.0;            ///< >= 1
    double machine_stiffness = 0.0;          ///< [N/m], > 0; infinite for fixed grips
    DriftModel drift = DriftModel::automatic;
    std::optional<Estimate> displacement_stiffness;  ///< k that made δ = stage − F/k of the record
};

/// @throws UndefinedDataError as loop_energy; InvalidArgument outside the domain.
/// Cost: linear; about 0.02 µs per sample.
[[nodiscard]] EnergyBudget energy_budget(const Loop& loop, const Segments& segments, Index contact,
                                         const EnergyBudgetInputs& inputs);

/// Energies along one contact, sample by sample: work = elastic + surface + dissipated.
struct EnergyCourse {
    IndexRange range;        ///< samples, from the start of the contact's extent to its end
    Array1D work;            ///< ∫F dδ [J]
    Array1D elastic;         ///< U_E = E* [δ²a − 2/3 δa³/R + a⁵/(5R²)] [J]
    Array1D surface;         ///< −W π a², with W of loading [J]
    Array1D dissipated;      ///< remainder [J]
    Array1D released;        ///< ∫G dA over the growing and shrinking contact, without jumps [J]
    Array1D contact_radius;  ///< measured, else computed from F, δ and E* [m]; 0 out of contact
    bool radius_measured = false;
    double residual = 0.0;  ///< work − elastic + released between the jumps [J]: 0 where F, δ, a and E* agree
};

struct CourseInputs {
    contact::AdhesiveContact contact;  ///< R, E* and W of loading
    double contact_point = 0.0;        ///< δ0 [m]
};

/// The force of `loop` is relative to its zero, as in LoopAnalysis::corrected. Between frames the radius is
/// interpolated linearly.
/// @throws UndefinedDataError without displacement.
/// Cost: linear; about 0.01 µs per sample with a measured radius, 0.02 µs with a computed one.
[[nodiscard]] EnergyCourse energy_course(const Loop& loop, const ContactSegments& contact, const CourseInputs& inputs);

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::WorkEntry> {
    using T = loops::WorkEntry;
    static constexpr std::array rows{
        made<T>("first", "index of the first sample", [](const T& of) { return of.range.first; }),
        made<T>("last", "index of the last sample", [](const T& of) { return of.range.last; }),
        made<T>("work", "int F d(delta)", "J", "∫F dδ",
                [](const T& of) {
                    return Estimate{
                        .value = of.energy, .standard_error = of.standard_error.total, .method = "error budget"};
                }),
        field<&T::standard_error>("standard_error_budget", "contributions to the standard error"),
        inner<&T::range>(),
        inner<&T::energy>(),
    };
    static constexpr Description description{"work", "work between two samples", rows};
};
static_assert(complete<loops::WorkEntry>);

template <>
struct Described<loops::EnergyBudget> {
    using T = loops::EnergyBudget;
    static constexpr std::array rows{
        field<&T::before_contact>("before_contact", "work before contact"),
        field<&T::jump_in>("jump_in", "work in the jump into contact").or_null(),
        field<&T::approach>("approach", "work of the approach"),
        field<&T::retraction>("retraction", "work of the retraction"),
        field<&T::jump_out>("jump_out", "work in the jump out of contact").or_null(),
        field<&T::after_contact>("after_contact", "work after contact"),
        quantity<&T::recovered_share>("recovered_share", "recovered", "1", "share of the work that is recovered"),
        quantity<&T::ideal_fixed_grips>("ideal_loss_fixed_grips", "E_ideal", "J",
                                        "energy loss of the jumps of the ideal smooth sphere under fixed grips"),
        quantity<&T::ideal_this_machine>(
            "ideal_loss_this_machine", "E_ideal", "J",
            "energy loss of the jumps of the ideal smooth sphere at the stiffness of the testing machine"),
        quantity<&T::machine_stiffness>("machine_stiffness", "k", "N/m", "stiffness k of the testing machine"),
        quantity<&T::true_area_ratio>("true_area_ratio", "A_true/A_app", "1", "A_true/A_app"),
        made<T>("largest_true_area", "r pi a_max^2", "m2", "r π a_max²",
                [](const T& of) { return of.largest_true_area(); }),
        quantity<&T::loss_per_apparent_area>("loss_per_apparent_area", "E_loss/A", "J/m2", "E_loss/A"),
        quantity<&T::loss_per_true_area>("loss_per_true_area", "E_loss/A_true", "J/m2", "E_loss/A_true"),
        inner<&T::contact>(),
        inner<&T::loop>(),
        inner<&T::largest_contact_area>(),
    };
    static constexpr Description description{"energy_ledger", "energy budget of a loop", rows};
};
static_assert(complete<loops::EnergyBudget>);

}  // namespace setae::fields
