// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/half_space/adhesive_loop.hpp"
#include "setae/patches/patch.hpp"

namespace setae::patches {

/// A patch that nothing presses or pulls, T = 0.
struct Unloaded {
    double area_fraction = 0.0;
    /// −(U_el + U_adh)/(A w): what reaching it gained. 1 − e in full contact; what is left is lost on the way, as heat.
    double gain = 0.0;
    bool converged = false;
};

/// Jumps of a loop: steps that each lose more than a share of w.
struct JumpClass {
    double from = 0.0, to = 0.0;  ///< D/w of one jump
    double jumps = 0.0;           ///< how many; of several patches their mean
    double loss = 0.0;            ///< of them all, over w
};

/// Far → full contact → far; works per area over w. A cell loses by itself, even a flat one: it jumps into contact and
/// out of it as a whole.
struct PatchLoop {
    double approach_work = 0.0;    ///< W_appr/w = 1 − e − approach_dissipation
    double separation_work = 0.0;  ///< W_sep/w = 1 − e + separation_dissipation
    double approach_dissipation = 0.0, separation_dissipation = 0.0;
    double greatest_tension = 0.0;  ///< over σ = w/ρ
    double leftover = 0.0;          ///< |W − (1 − e) ∓ D| over w, what the trapezoidal rule missed
    std::vector<JumpClass> approach_jumps, separation_jumps;  ///< by size, the smallest first
    int steps = 0;
    bool complete = false;

    [[nodiscard]] double loss() const { return separation_work - approach_work; }
};

struct PatchContact {
    Unloaded from_far;       ///< let go where its highest point is felt
    Unloaded after_preload;  ///< pressed at `preload` first
    double preload = 0.0;    ///< over h'_rms E*
    /// Mean pressure over h'_rms E* at which closed_area of the patch touch, pressed from afar; 0 where it closes by
    /// itself, absent where max_pressure does not close it.
    std::optional<double> closing_pressure;
    /// Mean tension over σ at which the first point of full contact opens; below 0 where it opens unless pressed.
    double opening_tension = 0.0;
    std::optional<PatchLoop> loop;
};

inline constexpr double closed_area = 0.99;

struct ContactProtocol {
    double preload = 1.0;       ///< over h'_rms E*, > 0
    double max_pressure = 8.0;  ///< over h'_rms E*
    bool loop = false;
};

/// What a patch does. The pressure that closes it is found to 3 %.
/// @throws InvalidArgument for a protocol outside its domain, as AdhesiveCell for a patch outside its own.
[[nodiscard]] PatchContact bring_into_contact(const Patch& patch, const ContactProtocol& protocol = {},
                                              parallel::Threads threads = {});

/// The loop alone.
[[nodiscard]] PatchLoop loop_of(const Patch& patch, parallel::Threads threads = {});

}  // namespace setae::patches
