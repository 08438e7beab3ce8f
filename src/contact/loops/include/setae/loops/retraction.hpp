// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/fields/describe.hpp"
#include "setae/loops/jkr_fits.hpp"
#include "setae/loops/outcome.hpp"

namespace setae::loops {

/// Pull-off force and the corresponding work of adhesion.
struct PullOff {
    Index index = 0;            ///< sample of the smallest force
    Estimate force;             ///< smallest force [N], < 0; its error includes the noise and that of the baseline
    Estimate work_of_adhesion;  ///< Eq. S1, W = 2|F|/(3πR): a retracting JKR edge passes −3/2 πRW in a machine of any
    ///< stiffness
    Estimate last_force;  ///< force of the last sample before the jump [N]
    /// 6|F|/(5πR) of the last force: the contact separates at −5/6 πRW only in a machine that is stiff compared with
    /// it. δ(F) is vertical at that point: a record with few samples gives too large a value.
    Outcome<Estimate> work_of_adhesion_fixed_grips;
    /// k of the jump [N/m], |ΔF| = k (|Δδ| − vΔt), v the speed of the motor; infinite where δ moves no more than the
    /// motor, NaN where unknown
    double machine_stiffness = 0.0;
};

/// The last points before pull-off as a JKR curve (Eq. S2).
struct RetractionFit {
    Estimate work_of_adhesion;  ///< [J/m²]
    Estimate contact_modulus;   ///< [Pa]; given or fitted
    bool modulus_free = false;
    Index first = 0, last = 0;  ///< samples used
    Index n = 0;
    double rms_residual = 0.0;     ///< [N]
    bool radius_measured = false;  ///< false: a is computed from F, δ and E*
};

/// W (and E* where it is free) from points close to pull-off (Eq. S2).
///
/// The residual is that of force, F = 4E*a³/(3R) − √(8πE*W a³), which is the curve of Eq. S2 solved for F: there a(F)
/// is vertical, and the problem becomes linear in √W. `contact_modulus` is that of the loading branch; `contact_point`,
/// of the unloading branch, is used only where the radius was not measured. The standard error of W includes that of a
/// fixed modulus, but not the contact point's.
/// @throws UndefinedDataError for fewer points than unknowns, or E* free without measured contact radius.
[[nodiscard]] RetractionFit fit_retraction(const BranchData& last_points, double radius,
                                           const Estimate& contact_modulus, double contact_point,
                                           bool modulus_free = false);

}  // namespace setae::loops

namespace setae::fields {

template <>
struct Described<loops::PullOff> {
    using T = loops::PullOff;
    static constexpr std::array rows{
        field<&T::index>("index", "index of the sample"),
        quantity<&T::force>("force", "F_po", "N", "smallest force, at pull-off").as("pull_off_force"),
        quantity<&T::work_of_adhesion>("work_of_adhesion", "W_po", "J/m2", "W")
            .as("work_of_adhesion_pull_off")
            .from("at pull-off, W = 2|F_po|/(3 pi R), the smallest force; [D19], Eq. S1"),
        quantity<&T::last_force>("last_force", "F_last", "N", "force of the last sample in contact"),
        quantity<&T::work_of_adhesion_fixed_grips>("work_of_adhesion_fixed_grips", "W_po", "J/m2",
                                                   "6|F|/(5πR) of the last force")
            .from("W = 6|F_last|/(5 pi R), fixed grips"),
        quantity<&T::machine_stiffness>("machine_stiffness", "k", "N/m", "stiffness k of the testing machine"),
    };
    static constexpr Description description{"pull_off", "smallest force", rows};
};
static_assert(complete<loops::PullOff>);

template <>
struct Described<loops::RetractionFit> {
    using T = loops::RetractionFit;
    static constexpr std::array rows{
        made<T>("work_of_adhesion", "W_ret", "J/m2", "W",
                [](const T& of) { return with_count(of.n, of.work_of_adhesion); })
            .as("work_of_adhesion_retraction")
            .from("at pull-off, [D19], Eq. S2 on the last points"),
        quantity<&T::contact_modulus>("contact_modulus", "E*", "Pa", "E*"),
        field<&T::modulus_free>("contact_modulus_free", "whether E* was fitted, too"),
        field<&T::first>("first", "index of the first sample"),
        field<&T::last>("last", "index of the last sample"),
        quantity<&T::rms_residual>("rms_residual", "rms", "N", "root mean square residual of the force")
            .as("rms_residual_of_force"),
        field<&T::radius_measured>("contact_radius_measured",
                                   "whether the contact radius was measured; otherwise it is computed by JKR"),
        inner<&T::work_of_adhesion>(),
        inner<&T::n>(),
    };
    static constexpr Description description{"retraction", "last points before pull-off", rows};
};
static_assert(complete<loops::RetractionFit>);

}  // namespace setae::fields
