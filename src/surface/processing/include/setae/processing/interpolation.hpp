// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::processing {

/// Heights between the points of a map, linear on two triangles per pixel.
///
/// The pixel between (i, j) and (i+1, j+1) is cut from (i+1, j) to (i, j+1), as in SurfaceTopography. Periodic maps
/// wrap; for others a point outside [0, (n−1) Δ] is NaN (tolerance 1e-9 of a pixel). NaN if one of the three corners is
/// undefined; a corner with weight zero is ignored. The map is not copied and must outlive the interpolator.
class LinearInterpolator {
public:
    explicit LinearInterpolator(const topography::HeightMap& map) : map_(&map) {}
    /// Height [m] at (x, y) [m].
    [[nodiscard]] double operator()(double x, double y) const;

private:
    const topography::HeightMap* map_;
};

/// Linear interpolation between the points of a line.
class LinearLineInterpolator {
public:
    explicit LinearLineInterpolator(const topography::LineScan& scan) : scan_(&scan) {}
    [[nodiscard]] double operator()(double x) const;

private:
    const topography::LineScan* scan_;
};

/// Height and slopes at a point.
struct SurfacePoint {
    double height = 0.0;   ///< [m]
    double slope_x = 0.0;  ///< ∂h/∂x
    double slope_y = 0.0;  ///< ∂h/∂y
};

/// Heights between the points of a map, bicubic with continuous slopes.
///
/// Hermite cubics in x and y from heights and slopes at the four corners, mixed derivatives 0. Slopes: periodic
/// complete maps from the Fourier derivative (Nyquist mode left out), as in SurfaceTopography; others by central
/// differences, three-point one-sided ones at ends (exact for parabolas), next to undefined points one-sided ones of
/// three or two points, 0 without a defined neighbour. NaN if a corner is undefined or the point is outside. Memory:
/// two maps of slopes. The map is not copied and must outlive the interpolator.
class BicubicInterpolator {
public:
    explicit BicubicInterpolator(const topography::HeightMap& map, parallel::Threads threads = {});
    [[nodiscard]] double operator()(double x, double y) const { return at(x, y).height; }
    [[nodiscard]] SurfacePoint at(double x, double y) const;

private:
    const topography::HeightMap* map_;
    Array2D slopes_x_, slopes_y_;
};

/// Cubic interpolation between the points of a line, from heights and slopes.
class CubicLineInterpolator {
public:
    explicit CubicLineInterpolator(const topography::LineScan& scan);
    [[nodiscard]] double operator()(double x) const;

private:
    const topography::LineScan* scan_;
    Array1D slopes_;
};

/// A periodic map on another grid, finer or coarser independently in each direction, by its Fourier series.
///
/// Modes of both grids are kept, the others are 0. The mode at the Nyquist wavevector of an even direction is a cosine:
/// it is divided between ±q on a finer grid, and ±q are added to it on a coarser one. Transposing and interpolating
/// therefore commute, and a finer grid has the old heights at the old points. O(n log n).
/// @throws InvalidArgument for a map that is not periodic or a grid without points; UndefinedDataError for undefined
/// heights.
[[nodiscard]] topography::HeightMap fourier_interpolated(const topography::HeightMap& map, Index nx, Index ny,
                                                         parallel::Threads threads = {});
[[nodiscard]] topography::LineScan fourier_interpolated(const topography::LineScan& scan, Index points);

}  // namespace setae::processing
