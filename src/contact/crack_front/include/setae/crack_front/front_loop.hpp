// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/crack_front/circular_front.hpp"
#include "setae/loops/jkr_fits.hpp"
#include "setae/loops/retraction.hpp"

namespace setae::crack_front {

/// Controlled quantity of a loop: the displacement [m], a dead load [N], or a stage [m] with a spring.
enum class Drive { displacement, load, stage };

struct LoopPath {
    Drive drive = Drive::displacement;
    double stiffness = 0.0;  ///< k_m of the stage's spring [N/m]
    double furthest = 0.0;   ///< turning point [m], for a load [N]; > 0; the loop starts at 0
    Index steps = 500;       ///< number of steps on approach; steps of equal length lead back until separation
    /// A step is halved while both its dissipation and ½|ΔF Δδ|, the possible error of the trapezoidal rule, exceed
    /// this share of the loss of a smooth sphere in its two jumps. The remaining dissipation of a step is then that of
    /// a jump.
    double jump_share = 1e-3;
    /// Called after each step; false ends the loop.
    std::function<bool(const struct FrontStep&)> progress;
};

/// One equilibrium of a loop, and the dissipation of the step to it.
struct FrontStep {
    FrontState state;
    double position = 0.0;  ///< value of the controlled quantity [m], [N]
    /// D = ½ (F_{n−1} + F_n) Δδ − Δ(U + surface energy) [J]: work of the testing machine that is not stored.
    double dissipation = 0.0;
    double machine_work = 0.0;  ///< ½ (F_{n−1} + F_n) Δδ [J]
    /// On retraction: smallest distance that any point has moved back since the turn [m].
    double min_retreat = 0.0;
    bool approaching = true;
};

/// Approach from first contact, and retraction until separation.
struct FrontLoop {
    std::vector<FrontStep> steps;
    /// ∮ F dδ [J] = Σ D after separation. A dead load moves without limit after separation: its loop ends before.
    double energy_loss = 0.0;
    double approach_dissipation = 0.0,
           retraction_dissipation = 0.0;  ///< Σ D [J], including jumps into and out of contact
    double smallest_dissipation = 0.0;    ///< smallest D [J]; below 0 by the error of the trapezoidal rule
    Index jumps = 0;                      ///< number of steps that dissipated more than `jump_share`
    bool complete = false;                ///< whether the contact separated and every step converged
};

/// @throws InvalidArgument for a path outside its domain, and what CircularFront::solve() throws.
[[nodiscard]] FrontLoop front_loop(CircularFront& front, const LoopPath& path);

/// columns: position [m or N], displacement [m], force [N], mean_radius, area_radius, smallest_radius, largest_radius,
/// perimeter [m], elastic_energy, surface_energy, dissipation, total_dissipation [J], approaching, residual,
/// iterations.
[[nodiscard]] Table loop_table(const FrontLoop& loop, Drive drive);

/// Works of adhesion as an experiment determines them from a loop's two branches, with √(A/π) as the radius.
struct BranchWorks {
    loops::JkrFit approach;           ///< E* and W_appr of a(F) by Eq. 1
    loops::RetractionFit retraction;  ///< W_ret of F(a) with that E*, where the whole edge moves, until separation
    double pull_off_force = 0.0;      ///< the smallest force [N]
    double pull_off_work = 0.0;       ///< corresponding W by Eq. S1 [J/m²]
};

/// @throws UndefinedDataError for too few steps in contact, or an edge that has not moved everywhere before separation.
[[nodiscard]] BranchWorks branch_works(const FrontLoop& loop, const contact::SphereOnFlat& sphere);

}  // namespace setae::crack_front
