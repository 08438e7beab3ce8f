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

/// Approach [m] from first contact of the highest point: of the far field for free edges, of the base of a layer, of
/// the mean plane of a periodic half-space, whose far field has no defined position.
struct Displacement {
    double value = 0.0;
};

using Control = std::variant<MeanPressure, MeanGap, Displacement>;

/// A rigid rough surface pressed on an elastic body, without adhesion and friction.
struct HardWall {
    Grid grid;
    Body body;
    Edges edges = Edges::periodic;
    Array2D heights;  ///< h [m], finite, peaks positive: towards the body; for processes that share it, their own rows
    Control control;
    std::optional<double> hardness;  ///< H [Pa]: pressure at which the body yields; absent: purely elastic
};

/// Progress of a solution.
struct SolveProgress {
    Index nx = 0, ny = 0;  ///< size of the present grid; the last is that of the map
    bool last_grid = false;
    Index iterations = 0;      ///< iterations on this grid
    double duality_gap = 0.0;  ///< duality gap so far; relative, as in Certificate
};

struct SolveOptions {
    double tolerance = 1e-8;      ///< tolerance of the certificate's relative gap and level error
    Index max_iterations = 2000;  ///< iterations on the map's own grid
    bool nested_grids = true;     ///< whether to begin on coarser grids
    Array2D start;  ///< initial pressures [Pa], such as those of a similar load; empty: from coarser grids
    parallel::Threads threads;
    const parallel::Ranks* ranks = nullptr;  ///< processes that solve it together, each with the rows of slab_of()
    /// called from time to time, from the calling thread; may throw to stop, in all processes equally
    std::function<void(const SolveProgress&)> progress;
};

enum class SolveStatus {
    converged,
    not_converged,  ///< the certificate gives the error of the returned pressures
};

/// Error of the returned pressures, computed independently from them.
struct Certificate {
    /// Upper bound of the energy above its minimum, f(p) − f* <= Σ p (g − min g) A_pixel, divided by twice the stored
    /// energy. With a hardness Σ (p g − H min(g, 0)).
    double duality_gap = 0.0;
    double penetration = 0.0;  ///< largest −g [m]; where the body yields it is the depth of the dent and not included
    double level_error = 0.0;  ///< |Σ p g|/Σ p divided by the mean displacement of the load, 2 U/F
    double load_error = 0.0;   ///< |⟨p⟩/p̄ − 1|; 0 where the load is not prescribed
};

/// The resulting contact.
struct HardWallContact {
    /// p [Pa], >= 0; for processes, their own rows, as for the gaps. Numbers are those of the whole map
    Array2D pressures;
    Array2D gaps;  ///< g [m], >= 0; 0 in contact
    SolveStatus status = SolveStatus::not_converged;
    Certificate certificate;
    Index iterations = 0;        ///< conjugate-gradient iterations on the map's own grid
    Index transform_pairs = 0;   ///< on that grid, each one forward and one inverse transform
    double mean_pressure = 0.0;  ///< [Pa]
    double mean_gap = 0.0;       ///< [m]
    double displacement = 0.0;   ///< as Displacement [m]
    double stored_energy = 0.0;  ///< U = ½ ∫ p u [J]; with a hardness the elastic part
    double flowing_area = 0.0;   ///< area [m²] at the hardness
    double deepest_dent = 0.0;   ///< largest plastic displacement [m]
    MeanDisplacement mean_displacement = MeanDisplacement::finite;
    ContactArea area;
};

/// Pressures p >= 0 and gaps g >= 0 with p g = 0 everywhere.
///
///   minimise f(p) = ½ ⟨p, G p⟩ − ⟨p, h⟩ over p >= 0 (<= H) at the stated load or level;  g = G p − h + c
///
/// The contact set is estimated (under pressure, or overlapping), the residual on it is reduced by conjugate gradients,
/// preconditioned with the body's stiffness k(q); then pressures are cut at zero and the set is estimated again. The
/// reduction of the residual per estimate becomes smaller where estimates fail, down to one step and the activation of
/// Polonsky and Keer. The solution starts on grids of 64 points, doubled each time. Equal bytes and equal iterations
/// for any number of threads, and of processes that share a periodic map: solve() is then called by all together.
/// @throws InvalidArgument for heights that are not finite, a load or level outside its domain, a mean pressure above
/// the hardness, mean gaps with free edges, and pressure on the rim of a map with free edges, beyond which the contact
/// would continue.
/// Sources: Polonsky, Keer, Wear 231 (1999) 206; Hintermüller, Ito, Kunisch, SIAM J. Optim. 13 (2002) 865 (active
/// sets); Almqvist et al., J. Tribol. 129 (2007) 107 (hardness).
[[nodiscard]] HardWallContact solve(const HardWall& problem, const SolveOptions& options = {});

/// Contact stiffness −d⟨p⟩/dc [Pa/m] at fixed contact set, where c is the displacement of the contact's Displacement:
/// for a periodic half-space −d⟨p⟩/d⟨g⟩.
///
/// One linear solution on the set; infinite for full contact of a body whose mean displacement is undefined or blocked.
[[nodiscard]] double contact_stiffness(const HardWall& problem, const HardWallContact& contact,
                                       parallel::Threads threads = {});

}  // namespace setae::half_space
