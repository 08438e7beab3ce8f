// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/half_space/adhesive_loop.hpp"
#include "setae/patches/patch.hpp"

namespace setae::patches {

/// A patch without load, T = 0.
struct Unloaded {
    double area_fraction = 0.0;
    /// −(U_el + U_adh)/(A w): gained energy. 1 − e in full contact; the remainder is dissipated.
    double gain = 0.0;
    bool converged = false;
};

/// Jumps of a loop: steps that each dissipate more than a share of w.
struct JumpClass {
    double from = 0.0, to = 0.0;  ///< D/w of one jump
    double jumps = 0.0;           ///< number of jumps; for several patches their mean
    double loss = 0.0;            ///< loss of all these jumps, divided by w
};

/// Separated → full contact → separated; works per area divided by w. A cell has a loss of its own, even if flat: it
/// jumps into contact and out of it as a whole.
struct PatchLoop {
    double approach_work = 0.0;    ///< W_appr/w = 1 − e − approach_dissipation
    double separation_work = 0.0;  ///< W_sep/w = 1 − e + separation_dissipation
    double approach_dissipation = 0.0, separation_dissipation = 0.0;
    double greatest_tension = 0.0;  ///< divided by σ = w/ρ
    double leftover = 0.0;          ///< |W − (1 − e) ∓ D| divided by w, error of the trapezoidal rule
    std::vector<JumpClass> approach_jumps, separation_jumps;  ///< by size, the smallest first
    int steps = 0;
    bool complete = false;

    [[nodiscard]] double loss() const { return separation_work - approach_work; }
};

struct PatchContact {
    Unloaded from_far;       ///< released where the attraction of its highest point begins
    Unloaded after_preload;  ///< after a pressure `preload`
    double preload = 0.0;    ///< divided by h'_rms E*
    /// Mean pressure divided by h'_rms E* for contact on closed_area of the patch, from separated bodies; 0 for
    /// spontaneous contact, absent where max_pressure is not sufficient.
    std::optional<double> closing_pressure;
    /// Mean tension divided by σ at which the first point of full contact opens; below 0 where a pressure is required.
    double opening_tension = 0.0;
    std::optional<PatchLoop> loop;
};

inline constexpr double closed_area = 0.99;

struct ContactProtocol {
    double preload = 1.0;       ///< divided by h'_rms E*, > 0
    double max_pressure = 8.0;  ///< divided by h'_rms E*
    bool loop = false;
};

/// Contact behaviour of a patch. The closing pressure is determined to 3 %.
/// @throws InvalidArgument for a protocol outside its domain, as AdhesiveCell for a patch outside its own.
[[nodiscard]] PatchContact bring_into_contact(const Patch& patch, const ContactProtocol& protocol = {},
                                              parallel::Threads threads = {});

/// Only the loop.
[[nodiscard]] PatchLoop loop_of(const Patch& patch, parallel::Threads threads = {});

}  // namespace setae::patches
