// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/tip.hpp"

namespace setae::topography {

/// A grid point of the surface and the height of the apex in contact there.
struct Contact {
    double apex_height = -std::numeric_limits<double>::infinity();
    Index x = -1, y = -1;  ///< -1: none
};

/// Finds the point of a surface in contact with a tip: max_u [h(x + u) − t(u)].
///
/// The surface is stored as a pyramid of highest heights over blocks of 8, 64, … points square. A block is skipped if
/// its highest height minus the lowest of the tip over it does not exceed the best candidate so far. For this the table
/// of the tip contains, at every offset, the lowest tip height at that or a farther offset of the same quadrant, so any
/// shape is allowed.
class ContactSearch {
public:
    /// Keeps a view of the heights, which must outlive this object. NaN never touches.
    ContactSearch(const Array2D& heights, bool periodic_x, bool periodic_y, const TipImage& tip,
                  parallel::Threads threads);

    /// The highest candidate for the apex at a grid point. `guess`: a probable contact (that of the neighbour), which
    /// saves time and never changes the height found.
    [[nodiscard]] Contact highest(Index x, Index y, const Contact& guess = {}) const;

    /// Number of points with the apex at `apex_height` or higher, counted up to two; the last is `contact`.
    struct Touching {
        int points = 0;
        Contact contact;
    };
    [[nodiscard]] Touching touching(Index x, Index y, double apex_height) const;

    /// Lowest height of the tip over all offsets of at least (x, y) away, same signs; at 0 over both signs. Infinite
    /// outside.
    [[nodiscard]] double lowest_beyond(Index x, Index y) const;

private:
    struct Window;
    template <class Finder>
    void search(Index x, Index y, Finder& finder) const;
    template <class Finder>
    void descend(std::size_t level, const Window& window, Finder& finder) const;
    template <class Finder>
    void visit_points(const Window& window, Finder& finder) const;
    [[nodiscard]] double tip_at(Index offset_x, Index offset_y) const;

    Eigen::Map<const Array2D> heights_;
    bool periodic_x_, periodic_y_;
    Index reach_x_ = 0, reach_y_ = 0;
    Array2D tip_;                   ///< with a margin of infinite heights, one block wide
    Array2D bound_;                 ///< lowest_beyond of the offsets within reach
    std::vector<Array2D> highest_;  ///< [k]: over blocks of 8^(k+1) points square; undefined blocks −∞
};

}  // namespace setae::topography
