// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>

#include "setae/core/arrays.hpp"
#include "setae/half_space/body.hpp"
#include "setae/half_space/grid.hpp"
#include "setae/half_space/interaction.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::half_space {

/// The mean gap is held, ⟨g⟩ [m] >= 0.
struct HeldGap {
    double mean_gap = 0.0;
};
/// A dead load pulls with a mean tension T [Pa]; below 0 it presses.
struct DeadLoad {
    double tension = 0.0;
};
/// A stage at z [m] pulls through a spring of stiffness k_m [Pa/m] > 0: T = k_m (z − ⟨g⟩).
struct Stage {
    double position = 0.0, stiffness = 0.0;
};
using AdhesiveControl = std::variant<HeldGap, DeadLoad, Stage>;

/// What a contact is in equilibrium; energies per area of the cell.
struct AdhesiveState {
    double mean_gap = 0.0;         ///< [m]
    double tension = 0.0;          ///< T [Pa], > 0 pulls; dE/d⟨g⟩
    double elastic_energy = 0.0;   ///< [J/m²]
    double adhesive_energy = 0.0;  ///< ⟨V⟩ [J/m²], −w in full contact
    double area_fraction = 0.0;    ///< points in contact, over all
    double residual = 0.0;         ///< largest departure from equilibrium over σ = w/ρ
    bool converged = false;
    int iterations = 0;           ///< of the outer loop
    std::int64_t transforms = 0;  ///< pairs of Fourier transforms

    [[nodiscard]] double energy() const { return elastic_energy + adhesive_energy; }
};

struct AdhesiveOptions {
    double tolerance = 1e-4;   ///< of the residual
    int max_iterations = 300;  ///< of the outer loop
    /// Processes that share the cell, each with the rows of slab_of(): heights, gaps and pressures are its own, numbers
    /// of the whole map. They call everything together.
    const parallel::Ranks* ranks = nullptr;
};

/// A periodic cell: an elastic body, a rigid rough surface that it is attracted by and cannot enter.
///
///   E(g) = ½⟨(g + h) K (g + h)⟩ + ⟨V(g)⟩,  g >= 0;  K: stiffness k(q), 0 for the mean
///
/// h: heights of the rigid surface towards the body. E is lowered from one state to the next, never raised: each
/// iteration takes a projected gradient step of 1/k_max, which lowers E for every concave V and finds who touches, and
/// a Newton step of those that do not, by conjugate gradients with the preconditioner 1/(k + k(q_min)), within max|d|
/// <= 2ρ and to that boundary where E curves down; so a state that has become unstable slides down to one close by.
/// Same bytes for any number of threads.
///
/// Mean displacement of a layer is not counted: k(0) is in series with the machine.
/// Sources: Steihaug, SIAM J. Numer. Anal. 20 (1983) 626; Bugnicourt et al., Tribol. Int. 121 (2018) 366.
class AdhesiveCell {
public:
    /// heights [m] of the grid's shape, finite.
    /// @throws InvalidArgument for a grid, body or interaction outside its domain or too coarse a grid (require());
    /// UndefinedDataError for undefined heights.
    AdhesiveCell(const ArrayView2D& heights, const Grid& grid, const Body& body, const Interaction& interaction,
                 const AdhesiveOptions& options = {}, parallel::Threads threads = {});
    ~AdhesiveCell();
    AdhesiveCell(AdhesiveCell&&) noexcept;
    AdhesiveCell& operator=(AdhesiveCell&&) noexcept;

    [[nodiscard]] const Grid& grid() const;
    [[nodiscard]] const parallel::Slab& slab() const;
    [[nodiscard]] const Interaction& interaction() const;
    /// g [m] >= 0, exactly 0 in contact; where the cell is now.
    [[nodiscard]] const Array2D& gaps() const;
    /// p [Pa] on the body in the state solved last, attraction counted: < 0 where it is pulled; its mean is −T.
    [[nodiscard]] Array2D pressures() const;
    /// (E*/4) Σ|q||h_q|² of a half-space [J/m²]: elastic energy of full contact.
    [[nodiscard]] double conformal_energy() const;
    /// Mean gap [m] at which nothing attracts any more, seen from far: the highest point 5ρ away (cubic, dugdale: 3ρ
    /// more than where they end), and beyond where a flat cell would still jump, 1.4 √(w L/E*).
    [[nodiscard]] double far_gap() const;

    /// Mean gap [m] at which the highest point of the body undeformed is felt …
    [[nodiscard]] double felt_gap() const;
    /// … and at which it touches, max h − ⟨h⟩.
    [[nodiscard]] double touching_gap() const;
    /// Holds the displacement δ [m], as half_space::Displacement has it, or a stage at δ on a spring of stiffness
    /// k_m [Pa/m] per area: ⟨g⟩ = max h − ⟨h⟩ − δ − T/k, 1/k = 1/k_m + 1/k(0).
    /// @throws InvalidArgument where a gap that is held would be below 0.
    [[nodiscard]] AdhesiveControl displaced(double displacement, std::optional<double> stage_stiffness = {}) const;
    /// δ of the body in a state.
    [[nodiscard]] double displacement(const AdhesiveState& state) const;

    /// The state from which all others are reached: the body undeformed at a mean gap. Not in equilibrium.
    void begin_at(double mean_gap);
    /// Continues from gaps that were kept. @throws InvalidArgument for another shape or gaps below 0.
    void begin_with(const ArrayView2D& gaps);

    /// Equilibrium under a control, from where the cell is. A dead load moves nothing whose attraction is within the
    /// tolerance: begin where it is felt, some ρ above the highest point.
    /// @throws InvalidArgument for a held gap below 0 or a stage without stiffness.
    AdhesiveState solve(const AdhesiveControl& control);

    /// Slope dT/d⟨g⟩ [Pa/m] and the change of every gap by the mean gap, of the state solved last; kept for
    /// follow_tangent().
    struct Tangent {
        bool stable = false;         ///< E curves up: there is a tangent
        double largest = 1.0;        ///< max|∂g/∂⟨g⟩|
        double tension_slope = 0.0;  ///< dT/d⟨g⟩
    };
    Tangent find_tangent();
    /// Moves the gaps along the tangent by a change of the mean gap; where there is none all free gaps alike.
    void follow_tangent(double mean_gap_change);

    /// Remembers where the cell is, and returns there.
    void keep();
    void restore();

private:
    class Work;
    std::unique_ptr<Work> work_;
};

/// Equilibrium met coming from far: the body undeformed where its highest point is felt, or at the gap that is held
/// where that is wider, and let go. @throws as AdhesiveCell::solve().
AdhesiveState from_far(AdhesiveCell& cell, const AdhesiveControl& control);

}  // namespace setae::half_space
