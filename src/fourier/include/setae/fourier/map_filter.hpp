// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::fourier {

/// Real factors T(k, m) of a filter that is even along x and along y, made by MapFilter::multiplier.
struct Multiplier {
    Index modes_x = 0;      ///< k = 0 … period_x/2
    Index modes_y = 0;      ///< m = 0 … period_y/2
    Buffer<double> values;  ///< T(k, m)/(period_x period_y) at m · modes_x + k

    [[nodiscard]] const double* line(Index m) const { return values.data() + m * modes_x; }
};

/// Writes the ny values of row i of what is filtered; called once a row, from any thread.
using LoadRow = std::function<void(Index i, double* line)>;
/// Takes the ny values of row i of what came out; called once a row, from any thread, after the last LoadRow.
using StoreRow = std::function<void(Index i, const double* line)>;

/// A map times an even function of the wavevector.
///
///   y_ij = 1/(P_x P_y) Σ_{k,m} T(k, m) X(k, m) exp(2πi (ik/P_x + jm/P_y)),  i < nx, j < ny
///
/// X is the transform of the map, zeros added up to the periods P_x >= nx and P_y >= ny. Both transforms are real and
/// in place: three passes over one half spectrum of nx (P_y/2 + 1) modes, rows and columns of zeros are neither stored
/// nor transformed, and nothing is allocated after construction. The caller's own arithmetic rides along in the first
/// and the last pass. O(P_x P_y log(P_x P_y)). Same bytes for any number of threads. An object filters one map at a
/// time.
class MapFilter {
public:
    /// @throws InvalidArgument for nx or ny < 1, or a period shorter than its side.
    MapFilter(Index nx, Index ny, Index period_x, Index period_y, parallel::Threads threads = {});

    [[nodiscard]] Index period_x() const { return along_x_.points(); }
    [[nodiscard]] Index period_y() const { return along_y_.points(); }

    /// T(k, m) = factor(k, m), k = 0 … period_x/2, m = 0 … period_y/2. `factor` is called from any thread.
    [[nodiscard]] Multiplier multiplier(const std::function<double(Index k, Index m)>& factor) const;

    /// T of a filter given as an even kernel of the distance, counted in points.
    ///
    ///   y_ij = Σ K(i − i', j − j') x_i'j'
    ///
    /// Along one axis alone, the other argument is a mode as in T.
    /// `kernel` is called for i = 0 … period_x/2, j = 0 … period_y/2, from any thread.
    /// @throws InvalidArgument for an odd period along an axis of the kernel.
    enum class KernelAxes { x, y, both };
    [[nodiscard]] Multiplier kernel_multiplier(const std::function<double(Index i, Index j)>& kernel,
                                               KernelAxes along = KernelAxes::both) const;

    /// `load` and `store` may read and write the same map.
    void apply(const Multiplier& multiplier, const LoadRow& load, const StoreRow& store);

    /// Σ_ij x_ij y_ij, summed over modes: one transform. With zeros added, y counts beyond nx and ny, too, where x = 0.
    [[nodiscard]] double quadratic_form(const Multiplier& multiplier, const LoadRow& load);

private:
    struct Room {
        Buffer<double> line;
        Buffer<Complex> modes;
        Buffer<Complex> columns;
    };
    Complex* block(Index index);
    void forward_rows(const LoadRow& load);
    void gather(Index index, Complex* columns);
    void scatter(Index index, const Complex* columns);
    /// visit(column, line) of every line of a block, transformed along x in the room.
    template <class Visit>
    void each_column(Index block, Room& room, const Visit& visit);
    void with_rooms(Index tasks, const std::function<void(Index task, Room& room)>& body);

    Index nx_, ny_, modes_y_, block_stride_, column_stride_;
    RealTransform along_y_;
    InverseRealTransform back_along_y_;
    ComplexTransform along_x_, back_along_x_;
    parallel::Threads threads_;
    Buffer<Complex> half_;
    std::vector<Room> rooms_;
};

}  // namespace setae::fourier
