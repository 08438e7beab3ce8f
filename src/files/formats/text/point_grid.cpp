// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_grid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "setae/core/constants.hpp"

namespace setae::formats {
namespace {

constexpr double max_stray = 0.02;  ///< of a step, as of line scans

struct Axis {
    double first = 0.0, step = 0.0;
    Index count = 0;
    std::string problem;
};

/// The regular positions of values.
Axis axis_of(const Array1D& values, const char* name) {
    const auto fail = [&](const std::string& what) {
        return Axis{.problem = fmt::format("{} of the points {}", name, what)};
    };
    std::vector<double> sorted(values.begin(), values.end());
    for (const double value : sorted)
        if (!std::isfinite(value)) return fail("is undefined at some points");
    std::sort(sorted.begin(), sorted.end());
    const double range = sorted.back() - sorted.front();
    if (!(range > 0.0) || !std::isfinite(range)) return fail("is equal for all points");
    // a grid of n points has fewer than n positions along each direction, so steps are longer than range/n
    const double same = max_stray * range / static_cast<double>(sorted.size());
    std::vector<double> positions{sorted.front()};
    double min_gap = range;
    for (const double value : sorted) {
        const double gap = value - positions.back();
        if (gap <= same) continue;
        min_gap = std::min(min_gap, gap);
        positions.push_back(value);
    }
    if (positions.size() >= sorted.size())
        return fail(fmt::format("has {} values for {} points", positions.size(), sorted.size()));
    double node = 0.0;
    std::vector<double> nodes{0.0};
    for (std::size_t i = 1; i < positions.size(); ++i)
        nodes.push_back(node += std::round((positions[i] - positions[i - 1]) / min_gap));
    const double step = range / node;
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (std::abs(positions[i] - positions[0] - nodes[i] * step) > max_stray * step)
            return fail("has no constant step");
    if (node + 1.0 > static_cast<double>(sorted.size())) return fail("has gaps of too many steps");
    return {positions.front(), step, static_cast<Index>(node) + 1, {}};
}

}  // namespace

PointGrid grid_of(const Array1D& x, const Array1D& y, const Array1D& heights) {
    if (x.size() < 4) return {.problem = fmt::format("{} points do not form a grid", x.size())};
    const auto along_x = axis_of(x, "x"), along_y = axis_of(y, "y");
    for (const auto* axis : {&along_x, &along_y})
        if (!axis->problem.empty()) return {.problem = axis->problem};
    const double nodes = static_cast<double>(along_x.count) * static_cast<double>(along_y.count),
                 points = static_cast<double>(x.size());
    const bool sparse = points < min_filled * nodes || x.size() < along_x.count + along_y.count;
    if (sparse)
        return {.problem = fmt::format("{} points lie on {} × {} nodes, too few to be a map", x.size(), along_x.count,
                                       along_y.count)};
    if (points > nodes)
        return {.problem =
                    fmt::format("{} points lie on {} × {} nodes, some twice", x.size(), along_x.count, along_y.count)};
    PointGrid grid{
        Array2D::Constant(along_x.count, along_y.count, undefined),
        {static_cast<double>(along_x.count) * along_x.step, static_cast<double>(along_y.count) * along_y.step},
        {}};
    std::vector<bool> taken(static_cast<std::size_t>(along_x.count * along_y.count));
    for (Index i = 0; i < x.size(); ++i) {
        const auto column = static_cast<Index>(std::llround((x[i] - along_x.first) / along_x.step)),
                   row = static_cast<Index>(std::llround((y[i] - along_y.first) / along_y.step));
        const auto node = static_cast<std::size_t>(column * along_y.count + row);
        if (taken[node])
            return {.problem =
                        fmt::format("two points, the second on row {}, lie at x = {}, y = {}", i + 1, x[i], y[i])};
        taken[node] = true;
        grid.heights(column, row) = heights[i];
    }
    return grid;
}

}  // namespace setae::formats
