// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "setae/core/arrays.hpp"
#include "setae/fourier/map_filter.hpp"
#include "setae/half_space/body.hpp"
#include "setae/half_space/grid.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::half_space {

/// Boundary condition at the edges of the map.
enum class Edges {
    periodic,          ///< the map is repeated periodically
    free,              ///< a surface without pressure
    periodic_along_x,  ///< periodic along x, no pressure beyond the map along y
    periodic_along_y,  ///< periodic along y, no pressure beyond the map along x
};

/// Relation between mean pressure and mean displacement.
enum class MeanDisplacement {
    finite,     ///< ⟨u⟩ = ⟨p⟩/k(0), or that of the free surface
    undefined,  ///< an infinite body with unlimited load: only differences of u are defined; ⟨u⟩ = 0 if periodic
    blocked,    ///< an incompressible layer: k(0) is infinite and ⟨u⟩ = 0
};

/// Normal response of an elastic body to pressure on its surface.
///
///   u_q = p_q/k(q),  p_q = k(q) u_q      k(q): stiffness(), q = 2π (k/size_x, m/size_y) folded to the nearest zero
///
/// along periodic axes: pressures are waves. Along free axes they are constant over pixels, displacements are those at
/// pixels' centres, and the map is padded with as many points without pressure, which makes the sum over pixels exact;
/// layers need periodic edges. For a body loaded all along one axis the zero of u is arbitrary (strip_displacement in
/// pixel_kernels.hpp defines it). p [Pa] presses where > 0, u [m] > 0 is into the body. Maps have the grid's shape;
/// input and output may be the same map. One forward and one inverse real transform, in three passes over a persistent
/// buffer: nothing is allocated per call. An object serves one call at a time. Equal bytes for any number of threads
/// and of processes, which may share a periodic map: each then has only the rows of its slab, in the multipliers and in
/// apply(), which they call together.
class ElasticOperator {
public:
    /// @throws InvalidArgument for a grid or body outside its domain, a layer without periodic edges, one line of
    /// points with free edges (a line contact is periodic along its length), and free edges of a map that processes
    /// share.
    ElasticOperator(const Grid& grid, const Body& body, Edges edges = Edges::periodic, parallel::Threads threads = {},
                    const parallel::Ranks* ranks = nullptr);

    [[nodiscard]] const Grid& grid() const { return grid_; }
    [[nodiscard]] const parallel::Slab& slab() const { return slab_; }
    [[nodiscard]] const Body& body() const { return body_; }
    [[nodiscard]] Edges edges() const { return edges_; }
    [[nodiscard]] MeanDisplacement mean_displacement() const;

    /// k(q_min) [Pa/m] of the longest wave of the map.
    [[nodiscard]] double min_stiffness() const { return min_stiffness_; }
    /// k_max [Pa/m] of the shortest wave, in the corner of the spectrum.
    [[nodiscard]] double greatest_stiffness() const { return greatest_stiffness_; }

    void displacements(const ArrayView2D& pressures, Eigen::Ref<Array2D> displacements);
    /// The mean of the displacements is used only where mean_displacement() is finite. @throws InvalidArgument unless
    /// edges are periodic: displacements beyond free edges are unknown.
    void pressures(const ArrayView2D& displacements, Eigen::Ref<Array2D> pressures);

    /// Stored energy [J] from the modes, one transform: A/2 Σ_q |p_q|²/k(q), and A/2 Σ_q k(q) |u_q|².
    [[nodiscard]] double energy_of_pressures(const ArrayView2D& pressures);
    [[nodiscard]] double energy_of_displacements(const ArrayView2D& displacements);

    // For solvers that combine other operations with the transforms.

    /// factor(k(q)) of every mode, for apply(); factor(k(0)) is called with 0 where the mean displacement is undefined,
    /// with infinity where it is blocked. For free edges, the modes of the padded map.
    [[nodiscard]] fourier::Multiplier multiplier(const std::function<double(double stiffness)>& factor) const;
    /// 1/k and k, 0 for the mean where it is undefined or blocked. Made on first use.
    [[nodiscard]] const fourier::Multiplier& compliance();
    [[nodiscard]] const fourier::Multiplier& stiffness();
    /// A map, row by row, times a multiplier of this operator.
    void apply(const fourier::Multiplier& multiplier, const fourier::LoadRow& load, const fourier::StoreRow& store) {
        filter_.apply(multiplier, load, store);
    }
    /// Applies the same multipliers in float, in half the memory.
    [[nodiscard]] fourier::MapFilterOf<float> float_filter(parallel::Threads threads) const {
        return {slab_, grid_.ny, filter_.period_x(), filter_.period_y(), threads};
    }
    /// Σ x y of a map x and of its product y with the multiplier.
    [[nodiscard]] double quadratic_form(const fourier::Multiplier& multiplier, const fourier::LoadRow& load) {
        return filter_.quadratic_form(multiplier, load);
    }

private:
    [[nodiscard]] double wavevector(Index k, Index m) const;
    [[nodiscard]] fourier::Multiplier made_compliance() const;

    Grid grid_;
    Body body_;
    Edges edges_;
    parallel::Slab slab_;
    fourier::MapFilter filter_;
    double min_stiffness_, greatest_stiffness_;
    std::optional<fourier::Multiplier> compliance_, stiffness_;
};

/// Stored energy [J] in real space, ½ Σ p u times the area of a pixel. @throws InvalidArgument for maps of other
/// shapes than the grid's.
[[nodiscard]] double stored_energy(const ArrayView2D& pressures, const ArrayView2D& displacements, const Grid& grid);

}  // namespace setae::half_space
