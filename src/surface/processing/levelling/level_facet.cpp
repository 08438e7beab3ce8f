// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "pipeline/step_record.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/row_blocks.hpp"
#include "setae/processing/level.hpp"

namespace setae::processing {
namespace {

using numerics::by_row_blocks;
using numerics::RowBlocks;

using topography::HeightMap;
using topography::LineScan;
using topography::Mask;
using topography::Profile;

using Slope = std::array<double, 2>;

constexpr double sharpness = 20.0;  // constant of Gwyddion
constexpr double settled_facet = 1e-6;
constexpr int max_iterations = 100;

/// Σ w, Σ w v and Σ |v − b|² over facets.
struct FacetSums {
    double weight = 0.0, x = 0.0, y = 0.0, squares = 0.0;

    void add(double w, double vx, double vy) {
        weight += w;
        x += w * vx;
        y += w * vy;
    }
    void add(const FacetSums& other) {
        weight += other.weight;
        x += other.x;
        y += other.y;
        squares += other.squares;
    }
};

/// Facets of a map: cells of four points; visit(area, vx, vy) for those with all points used.
struct MapFacets {
    const HeightMap& map;
    const Mask& chosen;

    template <class Visit>
    FacetSums sums(parallel::Threads threads, const Visit& visit) const {
        const auto [nx, ny] = map.shape();
        const auto pixel = map.pixel_size();
        FacetSums all;
        if (nx < 2) return all;
        for (const auto& part : by_row_blocks(
                 RowBlocks(nx - 1, ny), threads, FacetSums{},
                 [&, columns = ny](Index first, Index last, FacetSums& block) {
                     for (Index i = first; i < last; ++i) {
                         const double* const here = map.heights.data() + i * columns;
                         const double* const next = here + columns;
                         for (Index j = 0; j + 1 < columns; ++j) {
                             const double vx = 0.5 * ((next[j] - here[j]) + (next[j + 1] - here[j + 1])) / pixel[0];
                             const double vy = 0.5 * ((here[j + 1] - here[j]) + (next[j + 1] - next[j])) / pixel[1];
                             if (std::isnan(vx) || (chosen.size() > 0 && !(chosen(i, j) && chosen(i, j + 1) &&
                                                                           chosen(i + 1, j) && chosen(i + 1, j + 1))))
                                 continue;
                             visit(block, 1.0, vx, vy);
                         }
                     }
                 }))
            all.add(part);
        return all;
    }
};

/// Facets of a line: segments, weighted by their length.
struct LineFacets {
    const Array1D& heights;
    const Array1D& lengths;
    const Mask& chosen;

    template <class Visit>
    FacetSums sums(parallel::Threads, const Visit& visit) const {
        FacetSums all;
        for (Index i = 0; i + 1 < heights.size(); ++i) {
            const double v = (heights[i + 1] - heights[i]) / lengths[i];
            if (!std::isnan(v) && (chosen.size() == 0 || (chosen(i, 0) && chosen(i + 1, 0))))
                visit(all, lengths[i], v, 0.0);
        }
        return all;
    }
};

struct Dominant {
    Slope slope{};
    int iterations = 0;
    bool converged = false;
};

template <class Facets>
Dominant dominant_slope(const Facets& facets, const topography::Metadata& metadata, parallel::Threads threads) {
    const auto start =
        facets.sums(threads, [](FacetSums& sums, double size, double vx, double vy) { sums.add(size, vx, vy); });
    if (!(start.weight > 0.0))
        throw UndefinedDataError(fmt::format("{}: no facet has all its points inside the region; enlarge the region",
                                             topography::label(metadata)));
    const Slope mean{start.x / start.weight, start.y / start.weight};
    const auto spread = facets.sums(threads, [&mean](FacetSums& sums, double size, double vx, double vy) {
        sums.squares += size * ((vx - mean[0]) * (vx - mean[0]) + (vy - mean[1]) * (vy - mean[1]));
    });
    Dominant found;
    found.slope = mean;
    while (found.iterations < max_iterations && !found.converged) {
        const auto [bx, by] = found.slope;
        const double variance =
            spread.squares / start.weight + (bx - mean[0]) * (bx - mean[0]) + (by - mean[1]) * (by - mean[1]);
        if (!(variance > 0.0)) {
            found.converged = true;
            break;
        }
        const auto weighted =
            facets.sums(threads, [bx, by, variance](FacetSums& sums, double size, double vx, double vy) {
                const double x = vx - bx, y = vy - by;
                const double w = size * std::exp(-sharpness * (x * x + y * y) / variance);
                sums.add(w, x, y);
            });
        ++found.iterations;
        if (!(weighted.weight > 0.0)) break;  // no facet is near the plane
        const Slope change{weighted.x / weighted.weight, weighted.y / weighted.weight};
        found.slope = {bx + change[0], by + change[1]};
        found.converged = std::hypot(change[0], change[1]) <= settled_facet * std::sqrt(variance);
    }
    return found;
}

/// Subtracts the plane with that slope through height 0 at the centre.
void level_by(const Slope& slope, HeightMap& map, parallel::Threads threads) {
    topography::PolynomialSurface plane{Array2D::Zero(2, 2), {}, {}};
    const auto [nx, ny] = map.shape();
    const auto pixel = map.pixel_size();
    for (std::size_t k = 0; k < 2; ++k)
        plane.half_extent[k] = plane.centre[k] = 0.5 * static_cast<double>((k == 0 ? nx : ny) - 1) * pixel[k];
    plane.coefficients(1, 0) = slope[0] * plane.half_extent[0];
    plane.coefficients(0, 1) = slope[1] * plane.half_extent[1];
    subtract(plane, map, threads);
    map.periodic = false;
}

void level_by(const Slope& slope, LineScan& scan, parallel::Threads) {
    const double step = slope[0] * scan.pixel_size();
    for (Index i = 0; i < scan.heights.size(); ++i)
        scan.heights[i] -= step * (static_cast<double>(i) - 0.5 * static_cast<double>(scan.heights.size() - 1));
    scan.periodic = false;
}

void level_by(const Slope& slope, Profile& profile, parallel::Threads) {
    const double middle = 0.5 * (profile.positions[0] + profile.positions[profile.positions.size() - 1]);
    profile.heights -= slope[0] * (profile.positions - middle);
}

Dominant dominant_slope_of(const HeightMap& map, const Mask& chosen, parallel::Threads threads) {
    return dominant_slope(MapFacets{map, chosen}, map.metadata, threads);
}

Dominant dominant_slope_of(const LineScan& scan, const Mask& chosen, parallel::Threads threads) {
    const Array1D lengths = Array1D::Constant(std::max<Index>(scan.heights.size() - 1, 0), scan.pixel_size());
    return dominant_slope(LineFacets{scan.heights, lengths, chosen}, scan.metadata, threads);
}

Dominant dominant_slope_of(const Profile& profile, const Mask& chosen, parallel::Threads threads) {
    const Index n = profile.positions.size();
    const Array1D lengths = profile.positions.tail(n - 1) - profile.positions.head(n - 1);
    for (Index i = 0; i < lengths.size(); ++i)
        if (!(lengths[i] > 0.0))
            throw InvalidArgument(fmt::format(
                "{}: x does not increase at point {}; expected a function h(x); clean_contour makes one from a "
                "traced curve",
                topography::label(profile.metadata), i + 1));
    return dominant_slope(LineFacets{profile.heights, lengths, chosen}, profile.metadata, threads);
}

}  // namespace

Processed apply(const LevelFacet& step, topography::Measurement measurement, parallel::Threads threads) {
    StepRecord record{std::string(step_name(step)), {}, {}};
    std::visit(
        [&](auto& m) {
            const auto chosen = [&] { return step.region.everything() ? Mask() : mask_of(step.region, m, threads); };
            const auto found = dominant_slope_of(m, chosen(), threads);
            level_by(found.slope, m, threads);
            subtract(fitted_polynomial(m, {.total = 0}, chosen(), threads), m, threads);
            record.numbers.push_back(recorded("removed_slope_x", "s_x", found.slope[0], "1"));
            if (std::is_same_v<std::decay_t<decltype(m)>, HeightMap>)
                record.numbers.push_back(recorded("removed_slope_y", "s_y", found.slope[1], "1"));
            record.numbers.push_back(recorded_count("iterations", found.iterations));
            if (!found.converged)
                record.alerts.push_back(
                    {"NOT_CONVERGED", topography::label(m.metadata),
                     fmt::format("the dominant slope of the facets did not converge within {} iterations",
                                 found.iterations),
                     "use level_plane, or a region that contains the facets"});
        },
        measurement);
    return {std::move(measurement), std::move(record)};
}

}  // namespace setae::processing
