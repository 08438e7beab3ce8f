// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/half_space/elastic_operator.hpp"
#include "setae/half_space/grid.hpp"

namespace setae::half_space {

/// Where pressure is.
struct ContactArea {
    double fraction = 0.0;  ///< pixels under pressure over all
    /// fraction − (π − 1 + ln 2)/24 · (pixel edges between contact and gap) · pixel area over the map's: pixels count
    /// too much of what they only touch. >= 0.
    /// Source: Yastrebov, Anciaux, Molinari, J. Mech. Phys. Solids 107 (2017) 469.
    double corrected_fraction = 0.0;
    double perimeter = 0.0;      ///< length of the edges between contact and gap [m]
    Index patches = 0;           ///< pixels in contact that share edges are one patch
    double largest_patch = 0.0;  ///< [m²]
};

/// Area, perimeter and patches of pressure > 0; across edges where the map repeats itself, too. Rims of free edges do
/// not count as perimeter. @throws InvalidArgument for pressures of another shape than the grid's.
[[nodiscard]] ContactArea contact_area(const ArrayView2D& pressures, const Grid& grid, Edges edges = Edges::periodic);
/// The same of a map that processes share, each with its rows; they call it together.
[[nodiscard]] ContactArea contact_area(const ArrayView2D& pressures, const Grid& grid, const parallel::Slab& slab,
                                       Edges edges = Edges::periodic);

}  // namespace setae::half_space
