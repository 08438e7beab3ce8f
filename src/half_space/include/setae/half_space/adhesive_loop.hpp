// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/half_space/adhesive_cell.hpp"

namespace setae::half_space {

/// One equilibrium of a loop, and what the step to it dissipated.
struct LoopStep {
    AdhesiveState state;
    /// D_n = ½ (T_{n−1} + T_n) Δ⟨g⟩ − ΔE [J/m²]: work of the machine that is stored nowhere; the same whether the gap,
    /// the load or a stage is held, and 0 for the first.
    double dissipation = 0.0;
    bool approaching = true;
};

struct LoopOptions {
    double first_gap = 0.0;    ///< [m] from where it approaches and to where it parts; 0: AdhesiveCell::far_gap()
    double closest_gap = 0.0;  ///< [m] where it turns; 0: full contact
    /// A step is halved while both its dissipation and ½|ΔT Δ⟨g⟩|, what the trapezoidal rule may miss, exceed this
    /// share of w: what is left in jumps is theirs.
    double jump_share = 1e-3;
    double largest_move = 1.0;  ///< of any gap by the tangent, over ρ
    double least_step = 0.01;   ///< of the mean gap by the tangent, over ρ
    /// Called after each step; false ends the loop.
    std::function<bool(const LoopStep&)> progress;
};

/// A loop from far to the closest gap and back, the mean gap held.
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

/// Steps follow the tangent (AdhesiveCell::find_tangent), so that none moves a gap by more than ρ, halve where the cell
/// jumps, and end in a ladder of halves close to full contact.
///
/// W_appr = w − e − D_appr and W_sep = w − e + D_sep, of a loop between far and full contact.
/// @throws InvalidArgument for gaps out of order.
[[nodiscard]] AdhesiveLoop adhesive_loop(AdhesiveCell& cell, const LoopOptions& options = {});

/// columns: mean_gap [m], tension [Pa], elastic_energy, adhesive_energy [J/m2], area_fraction, dissipation,
/// total_dissipation [J/m2], approaching, residual, iterations, transforms.
[[nodiscard]] Table loop_table(const AdhesiveLoop& loop);

}  // namespace setae::half_space
