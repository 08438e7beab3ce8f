// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/half_space/adhesive_cell.hpp"

namespace setae::half_space {

/// One equilibrium of a loop, and the dissipation of the step to it.
struct LoopStep {
    AdhesiveState state;
    /// Controlled position [m]: the mean gap, or the stage z = ⟨g⟩ + T/k_m.
    double position = 0.0;
    /// D_n = ½ (T_{n−1} + T_n) Δ⟨g⟩ − ΔE [J/m²]: work of the testing machine that is not stored; equal for a controlled
    /// gap, load or stage, and 0 for the first.
    double dissipation = 0.0;
    bool approaching = true;
};

/// State of a loop after some of its steps: all data for a continuation with equal bytes.
struct LoopCheckpoint {
    std::vector<LoopStep> steps;
    Array2D gaps;         ///< [m] of the last step
    double halved = 0.0;  ///< longest step after the last one [m]; infinity: any
};

struct LoopOptions {
    /// Positions [m] of the start of the approach and the end of the separation; absent: AdhesiveCell::far_gap().
    std::optional<double> first;
    double turn = 0.0;  ///< turning position; a mean gap of 0: full contact. A stage may move below 0.
    /// k_m [Pa/m] per area of the cell of a moving stage; absent: the mean gap is controlled.
    std::optional<double> stage_stiffness;
    /// The loop turns earlier where the pressure reaches this value [Pa].
    double max_pressure = std::numeric_limits<double>::infinity();
    /// A step is halved while both its dissipation and ½|ΔT Δposition|, the possible error of the trapezoidal rule,
    /// exceed this share of w. The remaining dissipation of a step is then that of a jump.
    double jump_share = 1e-3;
    double largest_move = 1.0;  ///< largest change of any gap by the tangent, divided by ρ
    double min_step = 0.01;     ///< smallest change of the mean gap by the tangent, divided by ρ
    /// Called after each step; false ends the loop.
    std::function<bool(const LoopStep&)> progress;
    /// Called every given number of steps with the data for a continuation.
    std::function<void(const LoopCheckpoint&)> checkpoint;
    /// Continues from this checkpoint; the cell and the other options must be the same.
    const LoopCheckpoint* resume = nullptr;
};

/// A loop from separated bodies to the turning position, and back.
struct AdhesiveLoop {
    std::vector<LoopStep> steps;
    double approach_work = 0.0;    ///< W_appr = −∫ T d⟨g⟩ on approach: work of the attraction [J/m²]
    double separation_work = 0.0;  ///< W_sep = ∫ T d⟨g⟩ of the separation [J/m²]
    double approach_dissipation = 0.0, separation_dissipation = 0.0;  ///< Σ D_n
    double smallest_dissipation = 0.0;  ///< smallest D_n; below 0 by the error of the trapezoidal rule
    double conformal_energy = 0.0;      ///< e of the cell, AdhesiveCell::conformal_energy()
    bool complete = false;              ///< whether the loop returned to its start and every step converged

    /// Area of the loop, Σ D_n where it ends in the state it began with.
    [[nodiscard]] double loss() const { return separation_work - approach_work; }
};

/// A contact that still exists at the start position, as of a sphere, is pulled further until separation, and returns.
///
/// Steps follow the tangent (AdhesiveCell::find_tangent), so that none moves a gap by more than ρ, are halved where the
/// cell jumps, and end in a sequence of halved steps close to full contact.
///
/// W_appr = w − e − D_appr and W_sep = w − e + D_sep, for a loop between separated bodies and full contact.
/// A soft stage is a dead load in the limit: in a jump of the cell, its tension hardly changes.
/// @throws InvalidArgument for positions out of order, a stage without stiffness, a pressure of 0 or less.
[[nodiscard]] AdhesiveLoop adhesive_loop(AdhesiveCell& cell, const LoopOptions& options = {});

/// columns: position, mean_gap [m], tension [Pa], elastic_energy, adhesive_energy [J/m2], area_fraction, dissipation,
/// total_dissipation [J/m2], approaching, residual, iterations, transforms.
[[nodiscard]] Table loop_table(const AdhesiveLoop& loop);

}  // namespace setae::half_space
