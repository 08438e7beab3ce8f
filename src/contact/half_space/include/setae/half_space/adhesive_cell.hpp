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

/// Fixed mean gap ⟨g⟩ [m] >= 0.
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

/// A contact in equilibrium; energies per area of the cell.
struct AdhesiveState {
    double mean_gap = 0.0;         ///< [m]
    double tension = 0.0;          ///< T [Pa], > 0 pulls; dE/d⟨g⟩
    double elastic_energy = 0.0;   ///< [J/m²]
    double adhesive_energy = 0.0;  ///< ⟨V⟩ [J/m²], −w in full contact
    double area_fraction = 0.0;    ///< points in contact divided by all points
    double residual = 0.0;         ///< largest deviation from equilibrium divided by σ = w/ρ
    bool converged = false;
    int iterations = 0;           ///< iterations of the outer loop
    std::int64_t transforms = 0;  ///< pairs of Fourier transforms

    [[nodiscard]] double energy() const { return elastic_energy + adhesive_energy; }
};

struct AdhesiveOptions {
    double tolerance = 1e-4;   ///< tolerance of the residual
    int max_iterations = 300;  ///< iterations of the outer loop
    /// Processes that share the cell, each with the rows of slab_of(): heights, gaps and pressures are those of the
    /// process, numbers those of the whole map. All processes call every function together.
    const parallel::Ranks* ranks = nullptr;
};

/// A periodic cell: an elastic body and a rigid rough surface with mutual attraction and without penetration.
///
///   E(g) = ½⟨(g + h) K (g + h)⟩ + ⟨V(g)⟩,  g >= 0;  K: stiffness k(q), 0 for the mean
///
/// h: heights of the rigid surface towards the body. E decreases from one state to the next: each iteration takes a
/// projected gradient step of 1/k_max, which lowers E for every concave V and determines the points in contact, and a
/// Newton step of the other points, by conjugate gradients with the preconditioner 1/(k + k(q_min)), within max|d| <=
/// 2ρ and to that boundary where E has negative curvature; an unstable state thus moves to a nearby stable one. Equal
/// bytes for any number of threads.
///
/// Mean displacement of a layer is not included: k(0) is in series with the testing machine.
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
    /// g [m] >= 0, exactly 0 in contact; of the present state.
    [[nodiscard]] const Array2D& gaps() const;
    /// p [Pa] on the body in the last solved state, including attraction: < 0 under tension; its mean is −T.
    [[nodiscard]] Array2D pressures() const;
    /// (E*/4) Σ|q||h_q|² of a half-space [J/m²]: elastic energy of full contact.
    [[nodiscard]] double conformal_energy() const;
    /// Mean gap [m] beyond which attraction is negligible: the highest point 5ρ away (cubic, dugdale: 3ρ more than
    /// their cutoff), and beyond the jump of a flat cell, 1.4 √(w L/E*).
    [[nodiscard]] double far_gap() const;

    /// Mean gap [m] at which the attraction of the highest point of the undeformed body begins …
    [[nodiscard]] double felt_gap() const;
    /// … and at which it is in contact, max h − ⟨h⟩.
    [[nodiscard]] double touching_gap() const;
    /// Control at the displacement δ [m] of half_space::Displacement, or by a stage at δ on a spring of stiffness k_m
    /// [Pa/m] per area: ⟨g⟩ = max h − ⟨h⟩ − δ − T/k, 1/k = 1/k_m + 1/k(0).
    /// @throws InvalidArgument where a fixed gap would be below 0.
    [[nodiscard]] AdhesiveControl displaced(double displacement, std::optional<double> stage_stiffness = {}) const;
    /// δ of the body in a state.
    [[nodiscard]] double displacement(const AdhesiveState& state) const;

    /// The initial state: the undeformed body at a mean gap. Not in equilibrium.
    void begin_at(double mean_gap);
    /// Continues from stored gaps. @throws InvalidArgument for another shape or gaps below 0.
    void begin_with(const ArrayView2D& gaps);

    /// Equilibrium under a control, from the present state. A dead load does not move a state whose attraction is
    /// within the tolerance: begin in the range of the attraction, some ρ above the highest point.
    /// @throws InvalidArgument for a fixed gap below 0 or a stage without stiffness.
    AdhesiveState solve(const AdhesiveControl& control);

    /// Slope dT/d⟨g⟩ [Pa/m] and the derivative of every gap by the mean gap, for the last solved state; stored for
    /// follow_tangent().
    struct Tangent {
        bool stable = false;         ///< E has positive curvature: there is a tangent
        double largest = 1.0;        ///< max|∂g/∂⟨g⟩|
        double tension_slope = 0.0;  ///< dT/d⟨g⟩
    };
    Tangent find_tangent();
    /// Moves the gaps along the tangent by a change of the mean gap; without a tangent all free gaps equally.
    void follow_tangent(double mean_gap_change);

    /// Stores the present state, and returns to it.
    void keep();
    void restore();

private:
    class Work;
    std::unique_ptr<Work> work_;
};

/// Equilibrium reached from separated bodies: the undeformed body where the attraction of its highest point begins, or
/// at the fixed gap where that is wider, and released. @throws as AdhesiveCell::solve().
AdhesiveState from_far(AdhesiveCell& cell, const AdhesiveControl& control);

}  // namespace setae::half_space
