// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/crack_front/circular_front.hpp"
#include "setae/loops/jkr_fits.hpp"
#include "setae/loops/retraction.hpp"

namespace setae::crack_front {

/// What drives a loop: the displacement [m], a dead load [N], or a stage [m] behind a spring.
enum class Drive { displacement, load, stage };

struct LoopPath {
    Drive drive = Drive::displacement;
    double stiffness = 0.0;  ///< k_m of the stage's spring [N/m]
    double furthest = 0.0;   ///< where the loop turns [m], of a load [N]; > 0, it begins and counts from 0
    Index steps = 500;       ///< of the way there; as long ones lead back until the contact parts
    /// A step is halved while both its dissipation and ½|ΔF Δδ|, what the trapezoidal rule may miss, exceed this share
    /// of what a smooth sphere loses in its two jumps: what is left in jumps is theirs.
    double jump_share = 1e-3;
    /// Called after each step; false ends the loop.
    std::function<bool(const struct FrontStep&)> progress;
};

/// One equilibrium of a loop, and what the step to it dissipated.
struct FrontStep {
    FrontState state;
    double position = 0.0;  ///< of what drives [m], [N]
    /// D = ½ (F_{n−1} + F_n) Δδ − Δ(U + surface energy) [J]: work of the machine that is stored nowhere.
    double dissipation = 0.0;
    double machine_work = 0.0;  ///< ½ (F_{n−1} + F_n) Δδ [J]
    /// On the way back the least any point has moved back since the turn [m].
    double min_retreat = 0.0;
    bool approaching = true;
};

/// Approach from first touch, and retraction until the contact parts.
struct FrontLoop {
    std::vector<FrontStep> steps;
    /// ∮ F dδ [J] = Σ D where the contact has parted. A dead load that lets go falls without end: its loop ends before.
    double energy_loss = 0.0;
    double approach_dissipation = 0.0,
           retraction_dissipation = 0.0;  ///< Σ D [J], jump into and out of contact included
    double smallest_dissipation = 0.0;    ///< least D [J]: below 0 by what the trapezoidal rule misses
    Index jumps = 0;                      ///< steps within which more than `jump_share` was dissipated
    bool complete = false;                ///< it parted, and every step converged
};

/// @throws InvalidArgument for a path outside its domain, and what CircularFront::solve() throws.
[[nodiscard]] FrontLoop front_loop(CircularFront& front, const LoopPath& path);

/// columns: position [m or N], displacement [m], force [N], mean_radius, area_radius, smallest_radius, largest_radius,
/// perimeter [m], elastic_energy, surface_energy, dissipation, total_dissipation [J], approaching, residual,
/// iterations.
[[nodiscard]] Table loop_table(const FrontLoop& loop, Drive drive);

/// Works of adhesion as an experimenter reads them from a loop's two branches, with √(A/π) for the radius.
struct BranchWorks {
    loops::JkrFit approach;  ///< E* and W_appr of a(F) by (1)
    loops::RetractionFit
        retraction;               ///< W_ret of F(a) with that E*, where the whole edge moves, until the contact parts
    double pull_off_force = 0.0;  ///< the smallest force [N]
    double pull_off_work = 0.0;   ///< W it stands for (S1) [J/m²]
};

/// @throws UndefinedDataError for too few steps in contact, or an edge that has not let go everywhere before it parts.
[[nodiscard]] BranchWorks branch_works(const FrontLoop& loop, const contact::SphereOnFlat& sphere);

}  // namespace setae::crack_front
