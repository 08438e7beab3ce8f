// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/jkr_fits.hpp"
#include "setae/loops/outcome.hpp"

namespace setae::loops {

/// Pull-off force and the work of adhesion it stands for.
struct PullOff {
    Index index = 0;  ///< sample of the smallest force
    Estimate force;   ///< the smallest [N], < 0; its error is the noise and the baseline's
    Estimate
        work_of_adhesion;  ///< (S1), W = 2|F|/(3πR): a receding JKR edge passes −3/2 πRW in a machine of any stiffness
    Estimate last_force;  ///< of the last sample before the jump [N]
    /// 6|F|/(5πR) of the last force: the contact parts at −5/6 πRW in a machine that is stiff against it, and only
    /// there. δ(F) is vertical at that point: a record with few samples reads too much.
    Outcome<Estimate> work_of_adhesion_fixed_grips;
    double machine_stiffness = 0.0;  ///< k of the jump [N/m], |ΔF| = k (|Δδ| − vΔt), v the speed of the motor; infinite
                                     ///< where δ moves no more than the motor, NaN where unknown
};

/// The last points before pull-off as a JKR curve (S2).
struct RetractionFit {
    Estimate work_of_adhesion;  ///< [J/m²]
    Estimate contact_modulus;   ///< [Pa]; the value given, or the one fitted
    bool modulus_free = false;
    Index first = 0, last = 0;  ///< samples used
    Index n = 0;
    double rms_residual = 0.0;     ///< [N]
    bool radius_measured = false;  ///< else a is implied by F, δ and E*
};

/// W (and E* where it is left free) from points close to pull-off (S2).
///
/// The residual is taken in force, F = 4E*a³/(3R) − √(8πE*W a³), which is the curve (S2) solved for F: there a(F) is
/// vertical, and the problem becomes linear in √W. `contact_modulus` is that of the loading branch;
/// `contact_point`, of the unloading branch, counts only where the radius was not measured. The standard error of W
/// holds that of a fixed modulus, but not the contact point's.
/// @throws UndefinedDataError for fewer points than unknowns, or E* free without measured contact radius.
[[nodiscard]] RetractionFit fit_retraction(const BranchData& last_points, double radius,
                                           const Estimate& contact_modulus, double contact_point,
                                           bool modulus_free = false);

}  // namespace setae::loops
