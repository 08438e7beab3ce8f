// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tip.hpp"

namespace setae::topography {

/// Options of tip dilation.
struct DilationOptions {
    parallel::Threads threads;
    /// Parts of the tip higher than this above its apex never touch [m]; not given: highest minus lowest height, which
    /// is exact.
    std::optional<double> height_range;
    /// Results at undefined heights are undefined; false: reading of the tip there, from the defined heights in reach.
    bool keep_undefined = true;
};

/// Reading of a tip on a surface: the height of the apex at first contact.
///
///   i(x) = max_u [h(x + u) − t(u)]   over the grid points x + u, t(u) the tip's height above its apex
///
/// The points are those of the surface. There is no surface outside the window (a periodic map continues). Undefined
/// heights never touch. Trends are kept. The axis of the tip is along z; the tilt of the map is not removed. i >= h;
/// exact in double precision, the same bytes for any number of threads. Cost: search of the highest candidate over
/// blocks of 8², 64², … pixels whose highest point could still touch; on rough surfaces 0.2 µs per point under a tip of
/// 41² pixels, 0.6 µs under one of 321² (src/files/topography/benchmarks).
/// @throws InvalidArgument for a tip outside its domain, or one that reaches farther than a map that is not periodic
/// (the height range limits the reach of an analytic tip, the last finite point that of an ArrayTip). Source:
/// Villarrubia, J. Res. Natl. Inst. Stand. Technol. 102, 425 (1997), eq. (2).
[[nodiscard]] HeightMap dilated(const HeightMap& surface, const Tip& tip, const DilationOptions& options = {});

/// Dilation of a line: without the surface on both sides of it, the reading is lifted less.
[[nodiscard]] LineScan dilated(const LineScan& surface, const Tip& tip, const DilationOptions& options = {});

/// Readings at scattered points: metres from the first point of the map, each at its nearest grid point. A periodic map
/// continues beyond its ends.
/// @throws InvalidArgument as dilated, for x and y of different length, and for a point outside a map that is not
/// periodic.
[[nodiscard]] Array1D dilated_at(const HeightMap& surface, const Tip& tip, const ArrayView1D& x, const ArrayView1D& y,
                                 const DilationOptions& options = {});

/// Reconstruction of the surface from a scan i with this tip: the upper limit set by all positions of the tip.
///
///   r(x) = min_u [i(x − u) + t(u)]
///
/// An upper bound of the true surface, equal to it at points that the tip touched: r >= h, dilated(r) = i for i =
/// dilated(h). Offsets outside the map and undefined heights give no limit.
/// @throws InvalidArgument as dilated.
/// Source: Villarrubia 1997, eq. (3).
[[nodiscard]] HeightMap eroded(const HeightMap& image, const Tip& tip, const DilationOptions& options = {});
[[nodiscard]] LineScan eroded(const LineScan& image, const Tip& tip, const DilationOptions& options = {});

/// Dilation with one set-up: readings on one surface, by grid point.
class Dilator {
public:
    /// Keeps a reference to the surface, which must outlive this object.
    /// @throws InvalidArgument as dilated.
    Dilator(const HeightMap& surface, const Tip& tip, const DilationOptions& options = {});
    ~Dilator();
    Dilator(Dilator&&) noexcept;
    Dilator& operator=(Dilator&&) noexcept;

    /// The reading at a grid point; NaN if the tip reaches no defined height (or by keep_undefined). Indices outside a
    /// periodic map wrap.
    /// @throws InvalidArgument for a point outside a map that is not periodic.
    [[nodiscard]] double reading(Index x, Index y) const;

    /// Readings at the nearest grid points of scattered positions [m], in the given order. Lists in spatial order are
    /// faster.
    /// @throws InvalidArgument as dilated_at.
    [[nodiscard]] Array1D readings(const ArrayView1D& x, const ArrayView1D& y) const;

    /// Readings at all grid points.
    [[nodiscard]] Array2D readings() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace setae::topography
