// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/contact_area.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/core/extent.hpp"

namespace setae::half_space {
namespace {

/// Which pixels belong together: a forest whose roots are the patches' first pixels.
class Patches {
public:
    explicit Patches(Index points) : parent_(extent(points)) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

    Index root(Index pixel) {
        while (parent_[extent(pixel)] != pixel) {
            parent_[extent(pixel)] = parent_[extent(parent_[extent(pixel)])];
            pixel = parent_[extent(pixel)];
        }
        return pixel;
    }
    void join(Index a, Index b) {
        const Index first = root(a), second = root(b);
        parent_[extent(std::max(first, second))] = std::min(first, second);
    }

private:
    std::vector<Index> parent_;
};

}  // namespace

ContactArea contact_area(const ArrayView2D& pressures, const Grid& grid, Edges edges) {
    require(grid);
    require_shape(pressures, grid, "pressures");
    const bool round_x = edges == Edges::periodic || edges == Edges::periodic_along_x,
               round_y = edges == Edges::periodic || edges == Edges::periodic_along_y;
    Patches patches(grid.points());
    Index touching = 0, edges_along_x = 0, edges_along_y = 0;
    const auto meet = [&](Index i, Index j, Index k, Index m, Index& edge_count) {
        const bool here = pressures(i, j) > 0.0, there = pressures(k, m) > 0.0;
        if (here && there) patches.join(i * grid.ny + j, k * grid.ny + m);
        else if (here != there) ++edge_count;
    };
    for (Index i = 0; i < grid.nx; ++i)
        for (Index j = 0; j < grid.ny; ++j) {
            if (pressures(i, j) > 0.0) ++touching;
            if (i + 1 < grid.nx || (round_x && grid.nx > 1)) meet(i, j, (i + 1) % grid.nx, j, edges_along_y);
            if (j + 1 < grid.ny || (round_y && grid.ny > 1)) meet(i, j, i, (j + 1) % grid.ny, edges_along_x);
        }
    std::vector<Index> sizes(extent(grid.points()), 0);
    ContactArea area;
    for (Index i = 0; i < grid.nx; ++i)
        for (Index j = 0; j < grid.ny; ++j) {
            if (!(pressures(i, j) > 0.0)) continue;
            const Index root = patches.root(i * grid.ny + j);
            if (root == i * grid.ny + j) ++area.patches;
            ++sizes[extent(root)];
        }
    const auto points = static_cast<double>(grid.points());
    constexpr double excess = (pi - 1.0 + std::numbers::ln2) / 24.0;
    area.fraction = static_cast<double>(touching) / points;
    area.corrected_fraction =
        std::max(0.0, area.fraction - excess * static_cast<double>(edges_along_x + edges_along_y) / points);
    area.perimeter =
        static_cast<double>(edges_along_x) * grid.pixel_x() + static_cast<double>(edges_along_y) * grid.pixel_y();
    area.largest_patch = static_cast<double>(*std::max_element(sizes.begin(), sizes.end())) * grid.pixel_area();
    return area;
}

}  // namespace setae::half_space
