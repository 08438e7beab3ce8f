// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tip.hpp"

namespace setae::topography {

/// How a tip touches a surface.
struct DilationOptions {
    parallel::Threads threads;
    /// Parts of the tip higher than this above its apex never touch [m]; unset: highest minus lowest height, which is
    /// exact.
    std::optional<double> height_range;
    /// Results at undefined heights are undefined; false: what the tip reads there, from the defined heights it
    /// reaches.
    bool keep_undefined = true;
};

/// What a tip reads on a surface: the height of its apex where it first touches.
///
///   i(x) = max_u [h(x + u) − t(u)]   over the grid points x + u, t(u) the tip's height above its apex
///
/// Same points, same reading at both ends of the window: beyond it there is no surface (a periodic map goes on).
/// Undefined heights never touch. Trends stay. Axis of the tip along z, tilt of the map not removed. i >= h; exact in
/// double precision, the same bytes for any number of threads. Cost: search of the highest candidate over blocks of 8²,
/// 64², … pixels whose highest point could still touch; on rough surfaces 0.2 µs a point under a tip of 41² pixels, 0.6
/// µs under one of 321² (src/files/topography/benchmarks).
/// @throws InvalidArgument for a tip outside its domain, or one that reaches farther than a map that is not periodic
/// (an analytic tip reaches as far as the height range lets it, an ArrayTip to its last finite point). Source:
/// Villarrubia, J. Res. Natl. Inst. Stand. Technol. 102, 425 (1997), eq. (2).
[[nodiscard]] HeightMap dilated(const HeightMap& surface, const Tip& tip, const DilationOptions& options = {});

/// The same for a line: the surface is the line alone, which lifts the reading less than the surface around it would.
[[nodiscard]] LineScan dilated(const LineScan& surface, const Tip& tip, const DilationOptions& options = {});

/// Readings at scattered points: metres from the map's first point, each read at its nearest grid point.
/// A periodic map goes on beyond its ends.
/// @throws InvalidArgument as dilated, for x and y of different length, and for a point outside a map that is not
/// periodic.
[[nodiscard]] Array1D dilated_at(const HeightMap& surface, const Tip& tip, const ArrayView1D& x, const ArrayView1D& y,
                                 const DilationOptions& options = {});

/// The surface that a scan i with this tip proves: the lowest that no position of the tip passes through.
///
///   r(x) = min_u [i(x − u) + t(u)]
///
/// An upper bound of the true surface, equal to it where the tip touched: r >= h, dilated(r) = i for i = dilated(h).
/// Offsets outside the map and undefined heights prove nothing.
/// @throws InvalidArgument as dilated.
/// Source: Villarrubia 1997, eq. (3).
[[nodiscard]] HeightMap eroded(const HeightMap& image, const Tip& tip, const DilationOptions& options = {});
[[nodiscard]] LineScan eroded(const LineScan& image, const Tip& tip, const DilationOptions& options = {});

/// Dilation with set-up done once: readings on one surface, by grid point.
class Dilator {
public:
    /// Keeps a reference to the surface, which must outlive it.
    /// @throws InvalidArgument as dilated.
    Dilator(const HeightMap& surface, const Tip& tip, const DilationOptions& options = {});
    ~Dilator();
    Dilator(Dilator&&) noexcept;
    Dilator& operator=(Dilator&&) noexcept;

    /// The reading at a grid point; NaN where the tip reaches no defined height (or by keep_undefined).
    /// Indices outside a periodic map wrap.
    /// @throws InvalidArgument for a point outside a map that is not periodic.
    [[nodiscard]] double reading(Index x, Index y) const;

    /// Readings at the nearest grid points of scattered positions [m], in the given order.
    /// Neighbours in the list that are neighbours on the surface are read faster.
    /// @throws InvalidArgument as dilated_at.
    [[nodiscard]] Array1D readings(const ArrayView1D& x, const ArrayView1D& y) const;

    /// Readings everywhere.
    [[nodiscard]] Array2D readings() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace setae::topography
