// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <functional>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/parallel/slab.hpp"

namespace setae::fourier {

/// Real factors T(k, m) of a filter that is even along x and along y; see MapFilter::multiplier.
template <class Real>
struct MultiplierOf {
    Index modes_x = 0;     ///< k = 0 … period_x/2
    Index modes_y = 0;     ///< m = 0 … period_y/2
    Index first_line = 0;  ///< m of the first line held: 0, or that of this process
    Buffer<Real> values;   ///< T(k, m)/(period_x period_y) at (m − first_line) · modes_x + k

    [[nodiscard]] const Real* line(Index m) const { return values.data() + (m - first_line) * modes_x; }
};
using Multiplier = MultiplierOf<double>;

/// Writes the ny values of row i of the input; called once per row, from any thread.
template <class Real>
using LoadRowOf = std::function<void(Index i, Real* line)>;
using LoadRow = LoadRowOf<double>;
/// Takes the ny values of row i of the output; called once per row, from any thread, after the last LoadRow.
template <class Real>
using StoreRowOf = std::function<void(Index i, const Real* line)>;
using StoreRow = StoreRowOf<double>;

/// Multiplies a map by an even function of the wavevector.
///
///   y_ij = 1/(P_x P_y) Σ_{k,m} T(k, m) X(k, m) exp(2πi (ik/P_x + jm/P_y)),  i < nx, j < ny
///
/// X is the transform of the map, padded with zeros to the periods P_x >= nx and P_y >= ny. Both transforms are real
/// and in place: three passes over one half spectrum of nx (P_y/2 + 1) modes. Rows and columns of zeros are neither
/// stored nor transformed. No memory is allocated after construction. The arithmetic of the caller is part of the first
/// and the last pass. O(P_x P_y log(P_x P_y)). Same bytes for any number of threads. An object filters one map at a
/// time.
///
/// If processes share the map, each loads and stores its own rows, counted from 0, and holds the factors of its own
/// lines of the spectrum. Two exchanges transpose the spectrum and restore it. Same bytes for any number of processes;
/// apply() and quadratic_form() are collective.
template <class Real>
class MapFilterOf {
public:
    /// @throws InvalidArgument for nx or ny < 1, or a period shorter than its side.
    MapFilterOf(Index nx, Index ny, Index period_x, Index period_y, parallel::Threads threads = {})
        : MapFilterOf(parallel::Slab(nx), ny, period_x, period_y, threads) {}
    MapFilterOf(const parallel::Slab& rows, Index ny, Index period_x, Index period_y, parallel::Threads threads = {});

    [[nodiscard]] Index period_x() const { return along_x_.points(); }
    [[nodiscard]] Index period_y() const { return along_y_.points(); }

    /// T(k, m) = factor(k, m), k = 0 … period_x/2, m = 0 … period_y/2. `factor` is called from any thread.
    [[nodiscard]] MultiplierOf<Real> multiplier(const std::function<double(Index k, Index m)>& factor) const;

    /// T of a filter given by an even kernel of the distance in points.
    ///
    ///   y_ij = Σ K(i − i', j − j') x_i'j'
    ///
    /// For one axis only, the other argument is a mode as in T.
    /// `kernel` is called for i = 0 … period_x/2, j = 0 … period_y/2, from any thread.
    /// @throws InvalidArgument for an odd period along an axis of the kernel, and if processes share the map. Only for
    /// double.
    enum class KernelAxes { x, y, both };
    [[nodiscard]] MultiplierOf<Real> kernel_multiplier(const std::function<double(Index i, Index j)>& kernel,
                                                       KernelAxes along = KernelAxes::both) const
        requires std::same_as<Real, double>;

    /// `load` and `store` may read and write the same map.
    void apply(const MultiplierOf<Real>& multiplier, const LoadRowOf<Real>& load, const StoreRowOf<Real>& store);

    /// Σ_ij x_ij y_ij, summed over modes: one transform. With zero padding, y also counts beyond nx and ny, where x =
    /// 0.
    [[nodiscard]] double quadratic_form(const MultiplierOf<Real>& multiplier, const LoadRowOf<Real>& load);

private:
    struct Room {
        Buffer<Real> line;
        Buffer<ComplexOf<Real>> modes;
        Buffer<ComplexOf<Real>> columns;
    };
    /// Rows of one rank, from begin to begin of a block.
    [[nodiscard]] Index block_stride(int rank) const;
    [[nodiscard]] Index own_stride() const;
    ComplexOf<Real>* block(Index index);
    /// Rows of a rank in a block whose columns are transformed here.
    ComplexOf<Real>* piece(int rank, Index block);
    void hand_on();
    void hand_back();
    void forward_rows(const LoadRowOf<Real>& load);
    void gather(Index index, ComplexOf<Real>* columns);
    void scatter(Index index, const ComplexOf<Real>* columns);
    /// Calls visit(column, line) for every line of a block, after the transform along x.
    template <class Visit>
    void each_column(Index block, Room& room, const Visit& visit);
    void with_rooms(Index tasks, const std::function<void(Index task, Room& room)>& body);

    parallel::Slab rows_;
    Index ny_, modes_y_, column_stride_;
    parallel::Slab blocks_, lines_;  ///< blocks and lines of the spectrum that are transformed along x here
    RealTransformOf<Real> along_y_;
    InverseRealTransformOf<Real> back_along_y_;
    ComplexTransformOf<Real> along_x_, back_along_x_;
    parallel::Threads threads_;
    Buffer<ComplexOf<Real>> half_;                   ///< all blocks of own rows
    Buffer<ComplexOf<Real>> columns_;                ///< own blocks of all rows, if processes share the map
    std::vector<Index> row_begins_, column_begins_;  ///< begins of the share of every rank in half_ and in columns_
                                                     ///< [bytes]
    std::vector<Room> rooms_;
};
using MapFilter = MapFilterOf<double>;

}  // namespace setae::fourier
