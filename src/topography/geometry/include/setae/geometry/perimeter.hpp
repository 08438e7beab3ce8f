// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/geometry/point_grid.hpp"
#include "setae/topography/mask.hpp"

namespace setae::geometry {

/// Length of the stepped line between chosen points and others.
///
///   S_d = n_x Δy + n_y Δx
///
/// n_x, n_y: neighbours along x and along y of which one is chosen. The border of a grid that is not periodic is no
/// edge: what lies beyond is unknown.
struct EdgeLength {
    double along_x = 0.0;  ///< n_y Δx: edges that run along x [m]
    double along_y = 0.0;  ///< n_x Δy [m]
    [[nodiscard]] double total() const { return along_x + along_y; }
};

/// One pass over the mask. @throws InvalidArgument for a mask without points or a pixel size that is not positive.
[[nodiscard]] EdgeLength edge_length(const topography::Mask& mask, const PointGrid& grid);

/// Perimeter [m] of shapes whose edges have no preferred direction: a line at the angle φ has edges (|cos φ| + |sin φ|)
/// times its length, 4/π times on average over all directions.
///
///   S = (π/4) S_d
[[nodiscard]] double isotropic_perimeter(double edge_length);

/// Area of contact from a computed one, freed of what its stepped edge adds.
///
///   A = A_d − (π − 1 + ln 2)/24 · S_d Δ
///
/// A_d: points in contact times Δ² [m²]. S_d: edge_length [m]. Δ: pixel size [m], both directions alike.
/// For the contact areas of solvers, where a point counts as in contact as soon as it carries load; a mask from heights
/// at points, such as a threshold, has no such bias.
/// @throws InvalidArgument for arguments that are negative or not finite.
/// Source: Yastrebov, Anciaux, Molinari, Tribol. Int. 114 (2017) 161.
[[nodiscard]] double corrected_contact_area(double counted_area, double edge_length, double pixel_size);

/// Chosen points that touch one that is not chosen.
[[nodiscard]] topography::Mask inner_perimeter(const topography::Mask& mask,
                                               Neighbours neighbours = Neighbours::edges_and_corners,
                                               bool periodic = false);

/// Points that are not chosen and touch a chosen one.
[[nodiscard]] topography::Mask outer_perimeter(const topography::Mask& mask,
                                               Neighbours neighbours = Neighbours::edges_and_corners,
                                               bool periodic = false);

}  // namespace setae::geometry
