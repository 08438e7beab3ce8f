// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include "setae/core/extent.hpp"

namespace setae::processing {
namespace {

struct Interval {
    Index first, last;
};

/// Range of a patch along one direction from its occupied places: its first place, and whether it extends all around.
struct Stretch {
    Index origin, length;
    bool wraps;
};

Stretch stretch(const std::vector<bool>& taken) {
    const auto n = static_cast<Index>(taken.size());
    const bool around = taken.front() && taken.back();
    if (!around) {
        const auto first = std::find(taken.begin(), taken.end(), true) - taken.begin();
        Index last = n - 1;
        while (!taken[extent(last)]) --last;
        return {first, last - first + 1, false};
    }
    const auto gap = std::find(taken.begin(), taken.end(), false);
    if (gap == taken.end()) return {0, n, true};
    Index origin = n - 1;
    while (taken[extent(origin)]) --origin;
    return {origin + 1, (gap - taken.begin()) + (n - origin - 1), false};
}

Interval span(const Patch& patch, bool along_x) {
    Interval interval{std::numeric_limits<Index>::max(), 0};
    for (const Run& run : patch.runs) {
        interval.first = std::min(interval.first, along_x ? run.i : run.first);
        interval.last = std::max(interval.last, along_x ? run.i : run.first + run.count - 1);
    }
    return interval;
}

Stretch stretch_of(const Patch& patch, bool along_x, Index n, bool periodic) {
    const Interval interval = span(patch, along_x);
    if (!periodic || interval.first > 0 || interval.last < n - 1)
        return {interval.first, interval.last - interval.first + 1, false};
    std::vector<bool> taken(extent(n), false);
    for (const Run& run : patch.runs) {
        if (along_x) taken[extent(run.i)] = true;
        else std::fill_n(taken.begin() + run.first, run.count, true);
    }
    return stretch(taken);
}

using Visit = std::function<void(Index a, Index b, bool along_x)>;

/// Pairs between runs a … a_end − 1 of one row and b … b_end − 1 of the next.
void visit_between(const PatchGraph& graph, std::size_t a, std::size_t a_end, std::size_t b, std::size_t b_end,
                   const Visit& visit) {
    while (a < a_end && b < b_end) {
        const Run &upper = graph.runs[a], &lower = graph.runs[b];
        const Index first = std::max(upper.first, lower.first),
                    last = std::min(upper.first + upper.count, lower.first + lower.count);
        for (Index j = first; j < last; ++j) {
            const Index p = graph.run_first[a] + j - upper.first, q = graph.run_first[b] + j - lower.first;
            visit(std::min(p, q), std::max(p, q), true);
        }
        if (upper.first + upper.count < lower.first + lower.count) ++a;
        else ++b;
    }
}

}  // namespace

void for_each_edge(const PatchGraph& graph, const Visit& visit) {
    const Index rows = graph.box.shape[0], columns = graph.box.shape[1];
    std::vector<std::size_t> row_begin(extent(rows) + 1, 0);
    for (const Run& run : graph.runs) ++row_begin[extent(run.i) + 1];
    for (Index i = 0; i < rows; ++i) row_begin[extent(i) + 1] += row_begin[extent(i)];
    for (Index i = 0; i < rows; ++i) {
        const std::size_t begin = row_begin[extent(i)], end = row_begin[extent(i) + 1];
        for (std::size_t r = begin; r < end; ++r)
            for (Index k = 1; k < graph.runs[r].count; ++k)
                visit(graph.run_first[r] + k - 1, graph.run_first[r] + k, false);
        const bool closes = graph.box.wraps[1] && columns > 1 && end > begin && graph.runs[begin].first == 0 &&
                            graph.runs[end - 1].first + graph.runs[end - 1].count == columns;
        if (closes) visit(graph.run_first[begin], graph.run_first[end - 1] + graph.runs[end - 1].count - 1, false);
        if (i > 0) visit_between(graph, row_begin[extent(i) - 1], begin, begin, end, visit);
    }
    if (graph.box.wraps[0] && rows > 1)
        visit_between(graph, row_begin[0], row_begin[1], row_begin[extent(rows) - 1], row_begin[extent(rows)], visit);
}

PatchGraph patch_graph(const Patch& patch, std::array<Index, 2> map_shape, bool periodic) {
    PatchGraph graph;
    for (const std::size_t direction : {0u, 1u}) {
        const Stretch along = stretch_of(patch, direction == 0, map_shape[direction], periodic);
        graph.box.origin[direction] = along.origin;
        graph.box.shape[direction] = along.length;
        graph.box.wraps[direction] = along.wraps;
        graph.box.ends[direction] = {!periodic && along.origin == 0,
                                     !periodic && along.origin + along.length == map_shape[direction]};
    }
    for (Run run : patch.runs) {
        run.i = (run.i - graph.box.origin[0] + map_shape[0]) % map_shape[0];
        run.first = (run.first - graph.box.origin[1] + map_shape[1]) % map_shape[1];
        graph.runs.push_back(run);
    }
    std::sort(graph.runs.begin(), graph.runs.end(),
              [](const Run& a, const Run& b) { return a.i != b.i ? a.i < b.i : a.first < b.first; });
    std::vector<Run> merged;
    for (const Run& run : graph.runs) {
        if (!merged.empty() && merged.back().i == run.i && merged.back().first + merged.back().count == run.first)
            merged.back().count += run.count;
        else merged.push_back(run);
    }
    graph.runs = std::move(merged);
    for (const Run& run : graph.runs) {
        graph.run_first.push_back(graph.points);
        graph.points += run.count;
    }
    for_each_edge(graph, [&](Index a, Index b, bool) { graph.bandwidth = std::max(graph.bandwidth, b - a); });
    return graph;
}

PatchBoundary patch_boundary(const PatchGraph& graph, const ArrayView2D& heights, bool periodic,
                             const Couplings& couplings) {
    const Index nx = heights.rows(), ny = heights.cols();
    PatchBoundary boundary{Array1D::Zero(graph.points), Array1D::Zero(graph.points), Array1D::Zero(graph.points)};
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    const auto visit = [&](const auto& found) {
        for (std::size_t r = 0; r < graph.runs.size(); ++r)
            for (Index k = 0; k < graph.runs[r].count; ++k) {
                const Index i = (graph.runs[r].i + graph.box.origin[0]) % nx,
                            j = (graph.runs[r].first + k + graph.box.origin[1]) % ny, point = graph.run_first[r] + k;
                const auto look = [&](Index ni, Index nj, bool along_x) {
                    if (periodic) {
                        ni = (ni + nx) % nx;
                        nj = (nj + ny) % ny;
                    } else if (ni < 0 || nj < 0 || ni >= nx || nj >= ny) return;
                    if (!std::isnan(heights(ni, nj))) found(point, heights(ni, nj), along_x);
                };
                look(i - 1, j, true);
                look(i + 1, j, true);
                look(i, j - 1, false);
                look(i, j + 1, false);
            }
    };
    visit([&](Index point, double height, bool along_x) {
        (along_x ? boundary.leak_x : boundary.leak_y)[point] += along_x ? couplings.x : couplings.y;
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    });
    boundary.centre = 0.5 * lowest + 0.5 * highest;
    boundary.range = highest - lowest;
    visit([&](Index point, double height, bool along_x) {
        boundary.right[point] += (along_x ? couplings.x : couplings.y) * (height - boundary.centre);
    });
    return boundary;
}

}  // namespace setae::processing
