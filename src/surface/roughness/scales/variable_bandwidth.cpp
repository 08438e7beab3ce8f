// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/scales/variable_bandwidth.hpp"

#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "cell_moments.hpp"
#include "polyline_pieces.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"

namespace setae::scales {
namespace {

/// Sum of residual squares and weight, by level: level p has 2^p times the cells of level 0.
struct LevelSums {
    std::vector<double> residual, weight;
    explicit LevelSums(Index levels) : residual(extent(levels)), weight(extent(levels)) {}
    void add(Index level, const CellMoments& cell) {
        residual[extent(level)] += cell.residual();
        weight[extent(level)] += cell.weight;
    }
    void add(const LevelSums& other) {
        for (std::size_t level = 0; level < residual.size(); ++level) {
            residual[level] += other.residual[level];
            weight[level] += other.weight[level];
        }
    }
};

/// First point of cell c of m: the smallest i with floor(i m/n) = c.
Index first_point(Index cell, Index cells, Index points) { return (cell * points + cells - 1) / cells; }

/// Heights in memory that are divided into cells.
struct Grid {
    const double* heights;
    Index nx, ny;
    Index stride;                ///< between neighbours in x
    std::array<Index, 2> cells;  ///< along x and y at level 0
    bool halves_y;               ///< cells are also halved along y
    Index levels;
};

CellMoments moments_of(const Grid& grid, Index x0, Index x1, Index y0, Index y1) {
    CellMoments cell;
    double origin = undefined, sx = 0.0, sy = 0.0, sh = 0.0;
    double n = 0.0;
    for (Index i = x0; i < x1; ++i)
        for (Index j = y0; j < y1; ++j) {
            const double h = grid.heights[i * grid.stride + j];
            if (std::isnan(h)) continue;
            if (std::isnan(origin)) origin = h;
            const double x = static_cast<double>(i - x0), y = static_cast<double>(j - y0), z = h - origin;
            n += 1.0;
            sx += x;
            sy += y;
            sh += z;
            cell.xx += x * x;
            cell.xy += x * y;
            cell.yy += y * y;
            cell.xh += x * z;
            cell.yh += y * z;
            cell.hh += z * z;
        }
    if (!(n > 0.0)) return {};
    const double one_over_n = 1.0 / n, mx = sx * one_over_n, my = sy * one_over_n, mh = sh * one_over_n;
    cell.weight = n;
    cell.xx -= sx * mx;
    cell.xy -= sx * my;
    cell.yy -= sy * my;
    cell.xh -= sx * mh;
    cell.yh -= sy * mh;
    cell.hh = std::max(0.0, cell.hh - sh * mh);
    cell.x = static_cast<double>(x0) + mx;
    cell.y = static_cast<double>(y0) + my;
    cell.h = origin + mh;
    return cell;
}

/// Moments of a cell from those of its parts, which are added to the sums.
CellMoments visit(const Grid& grid, Index level, Index cx, Index cy, LevelSums& sums) {
    const Index cells_x = grid.cells[0] << level, cells_y = grid.halves_y ? grid.cells[1] << level : grid.cells[1];
    CellMoments cell;
    if (level + 1 == grid.levels) {
        cell = moments_of(grid, first_point(cx, cells_x, grid.nx), first_point(cx + 1, cells_x, grid.nx),
                          first_point(cy, cells_y, grid.ny), first_point(cy + 1, cells_y, grid.ny));
    } else {
        for (Index part = 0; part < 2; ++part) {
            if (!grid.halves_y) cell.add(visit(grid, level + 1, 2 * cx + part, cy, sums));
            else
                for (Index part_y = 0; part_y < 2; ++part_y)
                    cell.add(visit(grid, level + 1, 2 * cx + part, 2 * cy + part_y, sums));
        }
    }
    sums.add(level, cell);
    return cell;
}

/// Levels with at least `fewest` points per cell along each direction that is halved.
Index levels_of(Index points, Index cells, Index fewest) {
    Index levels = 0;
    while (points / (cells << levels) >= fewest) ++levels;
    return levels;
}

void require_cells(Index levels, const VariableBandwidthOptions& options, const topography::Metadata& metadata) {
    if (options.min_points < 2)
        throw InvalidArgument(fmt::format("cells of at least {} points; expected 2 or more", options.min_points));
    if (levels < 1)
        throw InvalidArgument(fmt::format("{}: too few points for a cell of {}; use more points or smaller cells",
                                          topography::label(metadata), options.min_points));
}

/// One value per level, finest first.
FunctionOfScale result_of(const LevelSums& sums, double longest, double reliable_from,
                          const topography::Metadata& metadata) {
    const auto levels = static_cast<Index>(sums.residual.size());
    if (!(sums.weight[0] > 0.0))
        throw UndefinedDataError(fmt::format("{}: no height is defined", topography::label(metadata)));
    FunctionOfScale result;
    result.quantity = "variable_bandwidth";
    result.unit = "m";
    result.distance = result.value = result.count = Array1D(levels);
    result.standard_error = Array1D::Constant(levels, undefined);
    result.reliable_from = reliable_from;
    result.metadata = metadata;
    for (Index k = 0; k < levels; ++k) {
        const auto level = extent(levels - 1 - k);
        result.distance[k] = std::ldexp(longest, -static_cast<int>(level));
        result.value[k] = std::sqrt(sums.residual[level] / sums.weight[level]);
        result.count[k] = sums.weight[level];
    }
    return result;
}

/// Points of a polyline by cell of the finest level, walked from left to right.
class Pieces {
public:
    explicit Pieces(const topography::Profile& profile) : profile_(profile) {}
    /// Moments of the segments from the end of the last call to `end` [m] from the first point.
    CellMoments up_to(double end) {
        CellMoments cell;
        const Index last = profile_.positions.size() - 2;
        for (;;) {
            const double x0 = profile_.positions[segment_] - profile_.positions[0],
                         x1 = profile_.positions[segment_ + 1] - profile_.positions[0];
            const double h0 = profile_.heights[segment_] - profile_.heights[0],
                         slope = (profile_.heights[segment_ + 1] - profile_.heights[segment_]) / (x1 - x0);
            const double stop = segment_ == last ? end : std::min(end, x1);
            if (stop > place_) {
                const double length = stop - place_, middle = 0.5 * (place_ + stop),
                             cube = length * length * length / 12.0;
                cell.add({length, middle, 0.0, h0 + slope * (middle - x0), cube, 0.0, 0.0, slope * cube, 0.0,
                          slope * slope * cube});
                place_ = stop;
            }
            if (end < x1 || segment_ == last) return cell;
            ++segment_;
        }
    }

private:
    const topography::Profile& profile_;
    Index segment_ = 0;
    double place_ = 0.0;
};

CellMoments visit(Pieces& pieces, double length, Index levels, Index level, Index c, LevelSums& sums) {
    CellMoments cell;
    if (level + 1 == levels) {
        cell = pieces.up_to(length * static_cast<double>(c + 1) / static_cast<double>(Index{1} << level));
    } else {
        cell = visit(pieces, length, levels, level + 1, 2 * c, sums);
        cell.add(visit(pieces, length, levels, level + 1, 2 * c + 1, sums));
    }
    sums.add(level, cell);
    return cell;
}

}  // namespace

FunctionOfScale variable_bandwidth(const topography::LineScan& scan, const VariableBandwidthOptions& options) {
    const Index n = scan.heights.size(), levels = levels_of(n, 1, std::max<Index>(2, options.min_points));
    require_cells(levels, options, scan.metadata);
    LevelSums sums(levels);
    visit(Grid{scan.heights.data(), n, 1, 1, {1, 1}, false, levels}, 0, 0, 0, sums);
    return result_of(sums, scan.size, shortest_reliable_wavelength(scan, options.reliability, options.threads),
                     scan.metadata);
}

FunctionOfScale variable_bandwidth_of_lines(const topography::HeightMap& map, const VariableBandwidthOptions& options) {
    constexpr Index gathered = 16;
    const Index nx = map.heights.rows(), ny = map.heights.cols(),
                levels = levels_of(nx, 1, std::max<Index>(2, options.min_points));
    require_cells(levels, options, map.metadata);
    const Index blocks = (ny + gathered - 1) / gathered;
    std::vector<LevelSums> partial(extent(blocks), LevelSums(levels));
    parallel::for_each_index(extent(blocks), options.threads, [&](std::size_t block) {
        const Index first = static_cast<Index>(block) * gathered, lines = std::min(gathered, ny - first);
        const Array2D taken = map.heights.middleCols(first, lines).transpose();
        for (Index j = 0; j < lines; ++j)
            visit(Grid{taken.row(j).data(), nx, 1, 1, {1, 1}, false, levels}, 0, 0, 0, partial[block]);
    });
    LevelSums sums(levels);
    for (const auto& block : partial) sums.add(block);
    return result_of(sums, map.size[0], shortest_reliable_wavelength(map, options.reliability, options.threads),
                     map.metadata);
}

FunctionOfScale variable_bandwidth_of_area(const topography::HeightMap& map, const VariableBandwidthOptions& options) {
    constexpr Index split = 3;  // cells of this level are divided among threads
    const Index nx = map.heights.rows(), ny = map.heights.cols(), fewest = std::max<Index>(2, options.min_points);
    const double shorter = std::min(map.size[0], map.size[1]);
    const std::array<Index, 2> cells{static_cast<Index>(std::lround(map.size[0] / shorter)),
                                     static_cast<Index>(std::lround(map.size[1] / shorter))};
    const Index levels = std::min(levels_of(nx, cells[0], fewest), levels_of(ny, cells[1], fewest));
    require_cells(levels, options, map.metadata);
    const Grid grid{map.heights.data(), nx, ny, ny, cells, true, levels};
    const Index shared = std::min(split, levels - 1), across = cells[0] << shared, down = cells[1] << shared;
    std::vector<LevelSums> partial(extent(across * down), LevelSums(levels));
    std::vector<CellMoments> moments(extent(across * down));
    parallel::for_each_index(moments.size(), options.threads, [&](std::size_t c) {
        moments[c] = visit(grid, shared, static_cast<Index>(c) / down, static_cast<Index>(c) % down, partial[c]);
    });
    LevelSums sums(levels);
    for (const auto& part : partial) sums.add(part);
    for (Index level = shared - 1; level >= 0; --level) {
        const Index columns = cells[1] << level;
        std::vector<CellMoments> joined(extent((cells[0] << level) * columns));
        for (std::size_t c = 0; c < joined.size(); ++c) {
            const Index cx = static_cast<Index>(c) / columns, cy = static_cast<Index>(c) % columns;
            for (Index part = 0; part < 4; ++part)
                joined[c].add(moments[extent((2 * cx + part / 2) * 2 * columns + 2 * cy + part % 2)]);
            sums.add(level, joined[c]);
        }
        moments = std::move(joined);
    }
    const double longest =
        0.5 * (map.size[0] / static_cast<double>(cells[0]) + map.size[1] / static_cast<double>(cells[1]));
    return result_of(sums, longest, shortest_reliable_wavelength(map, options.reliability, options.threads),
                     map.metadata);
}

FunctionOfScale variable_bandwidth(const topography::Profile& profile, const VariableBandwidthOptions& options) {
    require_polyline(profile);
    const Index levels = levels_of(profile.positions.size(), 1, std::max<Index>(2, options.min_points));
    require_cells(levels, options, profile.metadata);
    LevelSums sums(levels);
    Pieces pieces(profile);
    visit(pieces, profile.size(), levels, 0, 0, sums);
    auto result =
        result_of(sums, profile.size(), shortest_reliable_wavelength(profile, options.reliability, options.threads),
                  profile.metadata);
    result.count_unit = "m";
    return result;
}

FunctionOfScale variable_bandwidth_along_lines(const topography::Measurement& measurement,
                                               const VariableBandwidthOptions& options) {
    struct Visitor {
        const VariableBandwidthOptions& options;
        FunctionOfScale operator()(const topography::HeightMap& map) const {
            return variable_bandwidth_of_lines(map, options);
        }
        FunctionOfScale operator()(const topography::LineScan& scan) const { return variable_bandwidth(scan, options); }
        FunctionOfScale operator()(const topography::Profile& profile) const {
            return variable_bandwidth(profile, options);
        }
    };
    return std::visit(Visitor{options}, measurement);
}

}  // namespace setae::scales
