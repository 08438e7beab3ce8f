// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/half_space/adhesive_cell.hpp"

namespace setae::half_space {

/// One equilibrium of a loop, and what the step to it dissipated.
struct LoopStep {
    AdhesiveState state;
    /// What is moved [m]: the mean gap, or the stage z = ⟨g⟩ + T/k_m.
    double position = 0.0;
    /// D_n = ½ (T_{n−1} + T_n) Δ⟨g⟩ − ΔE [J/m²]: work of the machine that is stored nowhere; the same whether the gap,
    /// the load or a stage is held, and 0 for the first.
    double dissipation = 0.0;
    bool approaching = true;
};

/// Where a loop stands after some of its steps: what it takes to go on as if it had not been stopped, to the last byte.
struct LoopCheckpoint {
    std::vector<LoopStep> steps;
    Array2D gaps;         ///< [m] of the last step
    double halved = 0.0;  ///< longest step that its last one allows [m]; infinity: any
};

struct LoopOptions {
    /// Positions [m]: from where it approaches and to where it parts; absent: AdhesiveCell::far_gap().
    std::optional<double> first;
    double turn = 0.0;  ///< where it turns; a mean gap of 0: full contact. A stage may go on below 0.
    /// k_m [Pa/m] per area of the cell of a stage that is moved; absent: the mean gap is.
    std::optional<double> stage_stiffness;
    /// It turns earlier where the pressure reaches this [Pa].
    double max_pressure = std::numeric_limits<double>::infinity();
    /// A step is halved while both its dissipation and ½|ΔT Δposition|, what the trapezoidal rule may miss, exceed this
    /// share of w: what is left in jumps is theirs.
    double jump_share = 1e-3;
    double largest_move = 1.0;  ///< of any gap by the tangent, over ρ
    double min_step = 0.01;     ///< of the mean gap by the tangent, over ρ
    /// Called after each step; false ends the loop.
    std::function<bool(const LoopStep&)> progress;
    /// Called every so many steps with what resumes the loop.
    std::function<void(const LoopCheckpoint&)> checkpoint;
    /// Goes on from there; the same cell and the other options as they were.
    const LoopCheckpoint* resume = nullptr;
};

/// A loop from far to where it turns, and back.
struct AdhesiveLoop {
    std::vector<LoopStep> steps;
    double approach_work = 0.0;    ///< W_appr = −∫ T d⟨g⟩ on approach: what the attraction did [J/m²]
    double separation_work = 0.0;  ///< W_sep = ∫ T d⟨g⟩ to part [J/m²]
    double approach_dissipation = 0.0, separation_dissipation = 0.0;  ///< Σ D_n
    double smallest_dissipation = 0.0;  ///< least D_n: below 0 by what the trapezoidal rule misses
    double conformal_energy = 0.0;      ///< e of the cell, AdhesiveCell::conformal_energy()
    bool complete = false;              ///< it came back to where it began, and every step converged

    /// Area of the loop, Σ D_n where it ends in the state it began with.
    [[nodiscard]] double loss() const { return separation_work - approach_work; }
};

/// Where it still holds on at the place where it began, as a sphere does, it is drawn on until it parts, and comes
/// back.
///
/// Steps follow the tangent (AdhesiveCell::find_tangent), so that none moves a gap by more than ρ, halve where the cell
/// jumps, and end in a ladder of halves close to full contact.
///
/// W_appr = w − e − D_appr and W_sep = w − e + D_sep, of a loop between far and full contact.
/// A soft stage is a dead load in the limit: where the cell jumps, its tension hardly changes.
/// @throws InvalidArgument for positions out of order, a stage without stiffness, a pressure of 0 or less.
[[nodiscard]] AdhesiveLoop adhesive_loop(AdhesiveCell& cell, const LoopOptions& options = {});

/// columns: position, mean_gap [m], tension [Pa], elastic_energy, adhesive_energy [J/m2], area_fraction, dissipation,
/// total_dissipation [J/m2], approaching, residual, iterations, transforms.
[[nodiscard]] Table loop_table(const AdhesiveLoop& loop);

}  // namespace setae::half_space
