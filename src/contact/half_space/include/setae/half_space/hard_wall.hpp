// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <variant>

#include "setae/core/arrays.hpp"
#include "setae/half_space/contact_area.hpp"
#include "setae/half_space/elastic_operator.hpp"

namespace setae::half_space {

/// Mean pressure [Pa] over the map, > 0.
struct MeanPressure {
    double value = 0.0;
};

/// Mean gap [m] over the map, >= 0; edges are periodic.
struct MeanGap {
    double value = 0.0;
};

/// Approach [m] from where the highest point touches: of the far field for free edges, of the base of a layer, of the
/// mean plane of a periodic half-space, whose far field has no place.
struct Displacement {
    double value = 0.0;
};

using Control = std::variant<MeanPressure, MeanGap, Displacement>;

/// A rigid rough surface pressed on an elastic body, without adhesion and friction.
struct HardWall {
    Grid grid;
    Body body;
    Edges edges = Edges::periodic;
    Array2D heights;  ///< h [m], finite, peaks positive: towards the body; of processes that share it, the own rows
    Control control;
    std::optional<double> hardness;  ///< H [Pa]: pressure at which the body flows; absent: purely elastic
};

/// Where a solution stands.
struct SolveProgress {
    Index nx = 0, ny = 0;  ///< of the grid at work; the last is the map's own
    bool last_grid = false;
    Index iterations = 0;      ///< on this grid
    double duality_gap = 0.0;  ///< reached; relative, as in Certificate
};

struct SolveOptions {
    double tolerance = 1e-8;      ///< of the certificate's relative gap and level error
    Index max_iterations = 2000;  ///< of the map's own grid
    bool nested_grids = true;     ///< begin on coarser grids
    Array2D start;  ///< pressures [Pa] to begin with, such as those of a load close by; empty: coarser grids find them
    parallel::Threads threads;
    const parallel::Ranks* ranks = nullptr;  ///< processes that solve it together, each with the rows of slab_of()
    std::function<void(const SolveProgress&)> progress;  ///< now and then, from the calling thread; may throw to stop,
                                                         ///< in all processes alike
};

enum class SolveStatus {
    converged,
    not_converged,  ///< the certificate says how far off the returned pressures are
};

/// How far the returned pressures are from the solution, computed from them anew.
struct Certificate {
    /// Bound of the energy above the least, f(p) − f* <= Σ p (g − min g) A_pixel, over twice the stored energy. With a
    /// hardness Σ (p g − H min(g, 0)).
    double duality_gap = 0.0;
    double penetration = 0.0;  ///< largest −g [m]; where the body flows it is the depth of the dent and not counted
    double level_error = 0.0;  ///< |Σ p g|/Σ p over the mean displacement of the load, 2 U/F
    double load_error = 0.0;   ///< |⟨p⟩/p̄ − 1|; 0 where the load is not prescribed
};

/// The contact found.
struct HardWallContact {
    Array2D pressures;  ///< p [Pa], >= 0; of processes the own rows, as the gaps. Numbers are of the whole map
    Array2D gaps;       ///< g [m], >= 0; 0 in contact
    SolveStatus status = SolveStatus::not_converged;
    Certificate certificate;
    Index iterations = 0;        ///< conjugate-gradient iterations on the map's own grid
    Index transform_pairs = 0;   ///< there, each one transform to Fourier space and one back
    double mean_pressure = 0.0;  ///< [Pa]
    double mean_gap = 0.0;       ///< [m]
    double displacement = 0.0;   ///< as Displacement [m]
    double stored_energy = 0.0;  ///< U = ½ ∫ p u [J]; with a hardness the elastic part
    double flowing_area = 0.0;   ///< [m²] at the hardness
    double deepest_dent = 0.0;   ///< [m] by which the body has flowed where it flowed most
    MeanDisplacement mean_displacement = MeanDisplacement::finite;
    ContactArea area;
};

/// Pressures p >= 0 and gaps g >= 0 with p g = 0 everywhere.
///
///   minimise f(p) = ½ ⟨p, G p⟩ − ⟨p, h⟩ over p >= 0 (<= H) at the stated load or level;  g = G p − h + c
///
/// The set of contact is guessed (pressed, or overlapping) and on it the residual is reduced by conjugate gradients,
/// preconditioned with the body's stiffness k(q); then pressures are cut at zero and the set is guessed anew. How far
/// the residual goes before that shrinks where guesses fail, down to one step and the careful activation of Polonsky
/// and Keer. Grids of 64 points and twice as many each time come first. Same bytes and the same iterations for any
/// number of threads, and of processes that share a periodic map: solve() is then called by all together.
/// @throws InvalidArgument for heights that are not finite, a load or level outside its domain, a mean pressure that
/// the hardness does not carry, mean gaps with free edges, and pressure on the rim of a map with free edges, beyond
/// which contact would go on.
/// Sources: Polonsky, Keer, Wear 231 (1999) 206; Hintermüller, Ito, Kunisch, SIAM J. Optim. 13 (2002) 865 (active
/// sets); Almqvist et al., J. Tribol. 129 (2007) 107 (hardness).
[[nodiscard]] HardWallContact solve(const HardWall& problem, const SolveOptions& options = {});

/// How much more mean pressure the next approach takes, −d⟨p⟩/dc [Pa/m] at the contact's own set, where c is the
/// displacement of the contact's Displacement: of a periodic half-space −d⟨p⟩/d⟨g⟩.
///
/// One linear solution on the set; infinite where a body whose mean displacement is undefined or blocked touches
/// everywhere.
[[nodiscard]] double contact_stiffness(const HardWall& problem, const HardWallContact& contact,
                                       parallel::Threads threads = {});

}  // namespace setae::half_space
