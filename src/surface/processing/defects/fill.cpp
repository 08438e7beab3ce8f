// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/fill.hpp"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "patch_multigrid.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/gaps.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;
using topography::LineScan;

/// Wider bands take longer than a multigrid solution.
constexpr Index widest_band = 40;
/// Patches solved by one task: many have a few points.
constexpr std::size_t patches_per_task = 32;

/// Banded Cholesky factorisation of the equations of the patch, row by row.
Array1D solve_by_band(const PatchGraph& graph, const PatchBoundary& boundary, const Couplings& couplings) {
    const Index n = graph.points, band = graph.bandwidth;
    Array2D factor = Array2D::Zero(n, band + 1);  // column band − (a − b) of row a: entry (a, b)
    factor.col(band) = boundary.leak_x + boundary.leak_y;
    for_each_edge(graph, [&](Index a, Index b, bool along_x) {
        const double coupling = along_x ? couplings.x : couplings.y;
        factor(a, band) += coupling;
        factor(b, band) += coupling;
        factor(b, band - (b - a)) -= coupling;
    });
    Array1D values = boundary.right;
    for (Index a = 0; a < n; ++a) {
        const Index first = std::max<Index>(0, a - band);
        double* row = &factor(a, band - a + first);  // entries (a, first …)
        for (Index b = first; b < a; ++b) {
            const Index start = std::max<Index>(first, b - band);
            const double* other = &factor(b, band - b + start);
            double sum = row[b - first];
            for (Index k = start; k < b; ++k) sum -= row[k - first] * other[k - start];
            row[b - first] = sum / factor(b, band);
        }
        double pivot = factor(a, band), sum = values[a];
        for (Index k = first; k < a; ++k) {
            pivot -= row[k - first] * row[k - first];
            sum -= row[k - first] * values[k];
        }
        factor(a, band) = std::sqrt(pivot);
        values[a] = sum / factor(a, band);
    }
    for (Index a = n - 1; a >= 0; --a) {
        values[a] /= factor(a, band);
        for (Index b = std::max<Index>(0, a - band); b < a; ++b) values[b] -= factor(a, band - (a - b)) * values[a];
    }
    return values;
}

void fill_patch(const Patch& patch, Array2D& heights, bool periodic, const Couplings& couplings) {
    const std::array<Index, 2> shape{heights.rows(), heights.cols()};
    const PatchGraph graph = patch_graph(patch, shape, periodic);
    const PatchBoundary boundary = patch_boundary(graph, heights, periodic, couplings);
    const Array1D values = boundary.range == 0.0            ? Array1D(Array1D::Zero(graph.points))
                           : graph.bandwidth <= widest_band ? solve_by_band(graph, boundary, couplings)
                                                            : solve_by_multigrid(graph, boundary, couplings);
    for (std::size_t r = 0; r < graph.runs.size(); ++r) {
        const Index i = (graph.runs[r].i + graph.box.origin[0]) % shape[0];
        for (Index k = 0; k < graph.runs[r].count; ++k)
            heights(i, (graph.runs[r].first + k + graph.box.origin[1]) % shape[1]) =
                boundary.centre + values[graph.run_first[r] + k];
    }
}

struct Filling {
    Index points = 0;
    Index patches = 0;
};

[[noreturn]] void refuse_empty(const topography::Metadata& metadata) {
    throw UndefinedDataError(
        fmt::format("{}: no height is defined, so that nothing can be filled", topography::label(metadata)));
}

Filling fill_in_place(HeightMap& map, parallel::Threads threads) {
    const std::vector<Patch> patches = undefined_patches(map.heights, map.periodic);
    Filling filling{0, static_cast<Index>(patches.size())};
    for (const Patch& patch : patches) filling.points += patch.points;
    if (filling.points == map.heights.size()) refuse_empty(map.metadata);
    const auto pixel = map.pixel_size();
    // up to a factor, so that square pixels have 1
    const Couplings couplings{std::max(1.0, (pixel[1] * pixel[1]) / (pixel[0] * pixel[0])),
                              std::max(1.0, (pixel[0] * pixel[0]) / (pixel[1] * pixel[1]))};
    parallel::for_each_index((patches.size() + patches_per_task - 1) / patches_per_task, threads,
                             [&](std::size_t task) {
                                 const std::size_t end = std::min(patches.size(), (task + 1) * patches_per_task);
                                 for (std::size_t p = task * patches_per_task; p < end; ++p)
                                     fill_patch(patches[p], map.heights, map.periodic, couplings);
                             });
    return filling;
}

Filling fill_in_place(LineScan& scan) {
    const auto gaps = topography::bridge_gaps(scan.heights, scan.periodic);
    if (gaps.points == scan.heights.size()) refuse_empty(scan.metadata);
    return {gaps.points, gaps.count};
}

StepRecord record_of(const Filling& filling, Index points) {
    StepRecord record{.step = std::string(step_name(FillUndefined{}))};
    const auto share = static_cast<double>(filling.points) / static_cast<double>(points);
    record.numbers.push_back({.quantity = "filled_points",
                              .symbol = "n",
                              .estimate = {.value = static_cast<double>(filling.points), .standard_error = 0.0},
                              .unit = "1"});
    record.numbers.push_back({.quantity = "filled_share",
                              .symbol = "n/N",
                              .estimate = {.value = share, .standard_error = 0.0},
                              .unit = "1"});
    record.numbers.push_back({.quantity = "filled_patches",
                              .symbol = "n_p",
                              .estimate = {.value = static_cast<double>(filling.patches), .standard_error = 0.0},
                              .unit = "1"});
    return record;
}

}  // namespace

HeightMap filled(HeightMap map, parallel::Threads threads) {
    fill_in_place(map, threads);
    return map;
}

LineScan filled(LineScan scan) {
    fill_in_place(scan);
    return scan;
}

Processed apply(const FillUndefined&, topography::Measurement measurement, parallel::Threads threads) {
    if (auto* map = std::get_if<HeightMap>(&measurement)) {
        StepRecord record = record_of(fill_in_place(*map, threads), map->heights.size());
        return {std::move(measurement), std::move(record)};
    }
    if (auto* scan = std::get_if<LineScan>(&measurement)) {
        StepRecord record = record_of(fill_in_place(*scan), scan->heights.size());
        return {std::move(measurement), std::move(record)};
    }
    const Index points = std::get<topography::Profile>(measurement).positions.size();
    return {std::move(measurement), record_of({}, points)};
}

}  // namespace setae::processing
