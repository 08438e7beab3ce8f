// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/half_space/elastic_operator.hpp"
#include "setae/half_space/grid.hpp"

namespace setae::half_space {

/// Area in contact.
struct ContactArea {
    double fraction = 0.0;  ///< number of pixels under pressure divided by that of all pixels
    /// fraction − (π − 1 + ln 2)/24 · (pixel edges between contact and gap) · pixel area divided by that of the map:
    /// corrects for the partial contact of pixels. >= 0.
    /// Source: Yastrebov, Anciaux, Molinari, J. Mech. Phys. Solids 107 (2017) 469.
    double corrected_fraction = 0.0;
    double perimeter = 0.0;      ///< length of the edges between contact and gap [m]
    Index patches = 0;           ///< number of patches: pixels in contact that share edges are one patch
    double largest_patch = 0.0;  ///< [m²]
};

/// Area, perimeter and patches of pressure > 0; periodic where the map is. Rims of free edges are not part of the
/// perimeter. @throws InvalidArgument for pressures of another shape than the grid's.
[[nodiscard]] ContactArea contact_area(const ArrayView2D& pressures, const Grid& grid, Edges edges = Edges::periodic);
/// Contact area of a map that processes share, each with its rows; all processes call it together.
[[nodiscard]] ContactArea contact_area(const ArrayView2D& pressures, const Grid& grid, const parallel::Slab& slab,
                                       Edges edges = Edges::periodic);

}  // namespace setae::half_space
