// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/contact_area.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/core/extent.hpp"

namespace setae::half_space {
namespace {

/// Connected pixels: a forest whose roots are the patches' first pixels.
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
    /// Returns whether they were separate.
    bool join(Index a, Index b) {
        const Index first = root(a), second = root(b);
        parent_[extent(std::max(first, second))] = std::min(first, second);
        return first != second;
    }

private:
    std::vector<Index> parent_;
};

/// Numbers of pixels and of pixel edges of the rows of one process.
struct Counts {
    double touching = 0.0, edges_along_x = 0.0, edges_along_y = 0.0, patches = 0.0, largest_patch = 0.0;
};

/// A process's first and last rows as its neighbours see them: of every pixel its patch, −1 for none, and that one's
/// size.
struct Rims {
    Array1D first_patch, last_patch, first_size, last_size;
};

/// Counts within the rows of one process, and its rims. Patches are called by their first pixel in the whole map.
std::pair<Counts, Rims> counted(const ArrayView2D& pressures, Index first_row, bool round_y) {
    const Index nx = pressures.rows(), ny = pressures.cols();
    Patches patches(nx * ny);
    Counts counts;
    const auto meet = [&](Index i, Index j, Index k, Index m, double& edges) {
        const bool here = pressures(i, j) > 0.0, there = pressures(k, m) > 0.0;
        if (here && there) patches.join(i * ny + j, k * ny + m);
        else if (here != there) edges += 1.0;
    };
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) {
            if (pressures(i, j) > 0.0) counts.touching += 1.0;
            if (i + 1 < nx) meet(i, j, i + 1, j, counts.edges_along_y);
            if (j + 1 < ny || (round_y && ny > 1)) meet(i, j, i, (j + 1) % ny, counts.edges_along_x);
        }
    std::vector<Index> sizes(extent(nx * ny), 0);
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) {
            if (!(pressures(i, j) > 0.0)) continue;
            const Index root = patches.root(i * ny + j);
            if (root == i * ny + j) counts.patches += 1.0;
            ++sizes[extent(root)];
        }
    counts.largest_patch = static_cast<double>(*std::max_element(sizes.begin(), sizes.end()));
    Rims rims;
    const auto read = [&](Index i, Array1D& patch, Array1D& size) {
        patch = size = Array1D::Constant(ny, -1.0);
        for (Index j = 0; j < ny; ++j) {
            if (!(pressures(i, j) > 0.0)) continue;
            const Index root = patches.root(i * ny + j);
            patch[j] = static_cast<double>(first_row * ny + root);
            size[j] = static_cast<double>(sizes[extent(root)]);
        }
    };
    read(0, rims.first_patch, rims.first_size);
    read(nx - 1, rims.last_patch, rims.last_size);
    return {counts, rims};
}

/// Gathers `each` numbers of every process in all of them.
Array1D gathered(const parallel::Slab& slab, const Array1D& own) {
    std::vector<Index> begins;
    for (int rank = 0; rank <= slab.ranks(); ++rank) begins.push_back(rank * own.size());
    Array1D all(begins.back());
    const auto by_rank = slab.among_same(begins);
    all.segment(by_rank.first(), own.size()) = own;
    by_rank.share(all.data());
    return all;
}

/// Joins patches across the boundary between the rows of two processes.
class Seams {
public:
    Seams(const parallel::Slab& slab, const Rims& own) {
        const Index ny = own.first_patch.size();
        Array1D row(4 * ny);
        row << own.first_patch, own.last_patch, own.first_size, own.last_size;
        const Array1D all = gathered(slab, row);
        for (Index rank = 0; rank < slab.ranks(); ++rank) {
            const auto part = [&](Index k) -> Array1D { return all.segment((4 * rank + k) * ny, ny); };
            rims_.push_back({part(0), part(1), part(2), part(3)});
            number(rims_.back().first_patch, rims_.back().first_size);
            number(rims_.back().last_patch, rims_.back().last_size);
        }
    }

    void join(bool round_x, Counts& counts) {
        Patches patches(std::ssize(sizes_));
        const std::size_t ranks = rims_.size();
        for (std::size_t rank = 0; rank < (round_x ? ranks : ranks - 1); ++rank) {
            const auto &last = rims_[rank].last_patch, &next = rims_[(rank + 1) % ranks].first_patch;
            for (Index j = 0; j < last.size(); ++j) {
                const bool here = last[j] >= 0.0, there = next[j] >= 0.0;
                if (here != there) counts.edges_along_y += 1.0;
                if (here && there && patches.join(numbers_.at(last[j]), numbers_.at(next[j]))) counts.patches -= 1.0;
            }
        }
        std::vector<double> together(sizes_.size(), 0.0);
        for (Index k = 0; k < std::ssize(sizes_); ++k) together[extent(patches.root(k))] += sizes_[extent(k)];
        for (const double size : together) counts.largest_patch = std::max(counts.largest_patch, size);
    }

private:
    void number(const Array1D& patch, const Array1D& size) {
        for (Index j = 0; j < patch.size(); ++j)
            if (patch[j] >= 0.0 && numbers_.emplace(patch[j], std::ssize(sizes_)).second) sizes_.push_back(size[j]);
    }

    std::vector<Rims> rims_;
    std::map<double, Index> numbers_;  ///< numbers of the patches on rims
    std::vector<double> sizes_;
};

}  // namespace

ContactArea contact_area(const ArrayView2D& pressures, const Grid& grid, Edges edges) {
    return contact_area(pressures, grid, parallel::Slab(grid.nx), edges);
}

ContactArea contact_area(const ArrayView2D& pressures, const Grid& grid, const parallel::Slab& slab, Edges edges) {
    require(grid);
    require_shape(pressures, grid, slab, "pressures");
    const bool round_x = edges == Edges::periodic || edges == Edges::periodic_along_x,
               round_y = edges == Edges::periodic || edges == Edges::periodic_along_y;
    const auto [own, rims] = counted(pressures, slab.first(), round_y);
    constexpr Index kinds = 5;
    Array1D numbers(kinds);
    numbers << own.touching, own.edges_along_x, own.edges_along_y, own.patches, own.largest_patch;
    const Array1D all = gathered(slab, numbers);
    Counts counts;
    for (Index rank = 0; rank < slab.ranks(); ++rank) {
        const auto of_rank = all.segment(kinds * rank, kinds);
        counts = {counts.touching + of_rank[0], counts.edges_along_x + of_rank[1], counts.edges_along_y + of_rank[2],
                  counts.patches + of_rank[3], std::max(counts.largest_patch, of_rank[4])};
    }
    Seams(slab, rims).join(round_x && grid.nx > 1, counts);
    const auto points = static_cast<double>(grid.points());
    constexpr double excess = (pi - 1.0 + std::numbers::ln2) / 24.0;
    ContactArea area;
    area.patches = static_cast<Index>(counts.patches);
    area.fraction = counts.touching / points;
    area.corrected_fraction =
        std::max(0.0, area.fraction - excess * (counts.edges_along_x + counts.edges_along_y) / points);
    area.perimeter = counts.edges_along_x * grid.pixel_x() + counts.edges_along_y * grid.pixel_y();
    area.largest_patch = counts.largest_patch * grid.pixel_area();
    return area;
}

}  // namespace setae::half_space
