// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/geometry/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "checks.hpp"

namespace setae::geometry {
namespace {

using topography::Mask;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Index block_lines = 16;  ///< columns a block gathers: two cache lines of doubles a row

Index block_count(Index lines) { return (lines + block_lines - 1) / block_lines; }

/// Steps along y from every point to the nearest chosen one of its own line, signed; `none` where the line has none.
using Steps = Eigen::Array<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();

Steps steps_along_lines(const Mask& mask, bool periodic, parallel::Threads threads) {
    const Index nx = mask.rows(), ny = mask.cols();
    Steps steps(nx, ny);
    parallel::for_each_index(static_cast<std::size_t>(block_count(nx)), threads, [&](std::size_t block) {
        const Index first = static_cast<Index>(block) * block_lines;
        for (Index i = first; i < std::min(nx, first + block_lines); ++i) {
            const std::uint8_t* row = mask.row(i).data();
            std::int32_t* out = steps.row(i).data();
            // index of the chosen point last met; a periodic line is entered from its other end
            constexpr Index nowhere = std::numeric_limits<Index>::min() / 2;
            Index last = nowhere;
            if (periodic)
                for (Index j = ny - 1; j >= 0 && last == nowhere; --j)
                    if (row[j] != 0) last = j - ny;
            for (Index j = 0; j < ny; ++j) {
                if (row[j] != 0) last = j;
                out[j] = last == nowhere ? none : static_cast<std::int32_t>(last - j);
            }
            Index next = nowhere;
            if (periodic)
                for (Index j = 0; j < ny && next == nowhere; ++j)
                    if (row[j] != 0) next = j + ny;
            for (Index j = ny - 1; j >= 0; --j) {
                if (row[j] != 0) next = j;
                if (next != nowhere && (out[j] == none || next - j < -out[j]))
                    out[j] = static_cast<std::int32_t>(next - j);
            }
        }
    });
    return steps;
}

/// Lower envelope of the parabolas f_k + (x − k)² Δ² of one column, and who forms it.
class Envelope {
public:
    /// values: f_k [m²], infinite ones take no part. spacing: Δ [m].
    void build(const std::vector<double>& values, Index first, double spacing) {
        vertices_.clear();
        starts_.clear();
        const double curvature = spacing * spacing;
        for (Index k = 0; k < static_cast<Index>(values.size()); ++k) {
            const double f = values[static_cast<std::size_t>(k)];
            if (f == infinite) continue;
            const auto place = static_cast<double>(k + first);
            double start = -infinite;
            while (!vertices_.empty()) {
                const auto& v = vertices_.back();
                const auto other = static_cast<double>(v.index);
                start = 0.5 * ((f - v.value) / (curvature * (place - other)) + place + other);
                if (start > starts_.back()) break;
                vertices_.pop_back();
                starts_.pop_back();
                start = -infinite;
            }
            vertices_.push_back({k + first, f});
            starts_.push_back(start);
        }
    }
    /// Calls found(x, index, value) for x = 0 … n − 1 with the parabola that is lowest there.
    template <class Found>
    void visit(Index n, Found found) const {
        if (vertices_.empty()) return;
        std::size_t v = 0;
        for (Index x = 0; x < n; ++x) {
            while (v + 1 < vertices_.size() && starts_[v + 1] < static_cast<double>(x)) ++v;
            found(x, vertices_[v].index, vertices_[v].value);
        }
    }

private:
    struct Vertex {
        Index index;
        double value;
    };
    std::vector<Vertex> vertices_;
    std::vector<double> starts_;
};

/// Calls found(i, j, k, value) with the line k whose chosen point is nearest to (i, j), k outside 0 … nx − 1 across a
/// border, and the squared distance along y there [m²].
template <class Found>
void for_each_nearest(const Steps& steps, const PointGrid& grid, parallel::Threads threads, Found found) {
    const Index nx = steps.rows(), ny = steps.cols();
    // half a period beyond either end holds all that can be nearest
    const Index margin = grid.periodic ? (nx + 1) / 2 : 0;
    parallel::for_each_index(static_cast<std::size_t>(block_count(ny)), threads, [&](std::size_t block) {
        const Index first = static_cast<Index>(block) * block_lines, width = std::min(block_lines, ny - first);
        std::vector<std::vector<double>> columns(static_cast<std::size_t>(width),
                                                 std::vector<double>(static_cast<std::size_t>(nx + 2 * margin)));
        for (Index i = -margin; i < nx + margin; ++i) {
            const std::int32_t* row = steps.row((i + nx) % nx).data() + first;
            for (Index c = 0; c < width; ++c) {
                const double along_y = static_cast<double>(row[c]) * grid.pixel_size[1];
                columns[static_cast<std::size_t>(c)][static_cast<std::size_t>(i + margin)] =
                    row[c] == none ? infinite : along_y * along_y;
            }
        }
        Envelope envelope;
        for (Index c = 0; c < width; ++c) {
            envelope.build(columns[static_cast<std::size_t>(c)], -margin, grid.pixel_size[0]);
            envelope.visit(nx, [&](Index i, Index k, double value) { found(i, first + c, k, value); });
        }
    });
}

}  // namespace

Array2D distance_map(const Mask& mask, const PointGrid& grid, parallel::Threads threads) {
    require_points(mask);
    require_pixels(grid);
    const auto steps = steps_along_lines(mask, grid.periodic, threads);
    Array2D distance = Array2D::Constant(mask.rows(), mask.cols(), infinite);
    for_each_nearest(steps, grid, threads, [&](Index i, Index j, Index k, double value) {
        const double along_x = static_cast<double>(i - k) * grid.pixel_size[0];
        distance(i, j) = std::sqrt(along_x * along_x + value);
    });
    return distance;
}

PatchNumbers closest_patch_map(const Patches& patches, std::array<double, 2> pixel_size, parallel::Threads threads) {
    const PointGrid grid{pixel_size, patches.periodic};
    const Mask mask = (patches.numbers > 0).cast<std::uint8_t>();
    require_points(mask);
    require_pixels(grid);
    const auto steps = steps_along_lines(mask, grid.periodic, threads);
    const Index nx = mask.rows(), ny = mask.cols();
    PatchNumbers closest = PatchNumbers::Zero(nx, ny);
    for_each_nearest(steps, grid, threads, [&](Index i, Index j, Index k, double) {
        const Index line = (k + nx) % nx;
        closest(i, j) = patches.numbers(line, (j + steps(line, j) + ny) % ny);
    });
    return closest;
}

}  // namespace setae::geometry
