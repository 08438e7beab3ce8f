// SPDX-License-Identifier: GPL-3.0-or-later
#include "second_differences.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"

namespace setae::spectra {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The p-quantile of the defined values, p = 0 the smallest; NaN if there is none.
double quantile(std::vector<double> values, double percentile) {
    std::erase_if(values, [](double value) { return std::isnan(value); });
    return values.empty() ? undefined : lower_quantile(std::move(values), percentile);
}

/// Half a stencil in steps, `whole` + `fraction`.
struct Reach {
    Index whole;
    double fraction;

    explicit Reach(double steps) : whole(static_cast<Index>(std::floor(steps))), fraction(steps - std::floor(steps)) {
        // a fraction from rounding must not touch the next point, which may be undefined or missing
        constexpr double rounding = 1e-9;
        if (fraction > 1.0 - rounding) ++whole;
        if (fraction < rounding || fraction > 1.0 - rounding) fraction = 0.0;
    }
    [[nodiscard]] Index outer() const { return whole + (fraction > 0.0 ? 1 : 0); }
};

/// Heights for the stencils of neighbouring points; entry j belongs to point j.
struct StencilRows {
    const double *left_outer, *left, *centre, *right, *right_outer;
};

double second_difference(const StencilRows& rows, double fraction, Index j) {
    return (1.0 - fraction) * (rows.left[j] + rows.right[j]) + fraction * (rows.left_outer[j] + rows.right_outer[j]) -
           2.0 * rows.centre[j];
}

/// Smallest second difference of n neighbouring points; undefined ones compare false and are left out.
double smallest(const StencilRows& rows, double fraction, Index n) {
    double least = infinite;
    for (Index j = 0; j < n; ++j) {
        const double value = second_difference(rows, fraction, j);
        least = value < least ? value : least;
    }
    return least;
}

/// Calls visit(rows, n) for all stencils of lines first … last − 1 along the first index.
template <class Visit>
void visit_along_x(const CurvatureGrid& grid, const Reach& reach, Index first, Index last, const Visit& visit) {
    const Index n = grid.heights.rows();
    const auto row = [&](Index i) { return grid.heights.row((i + n) % n).data(); };
    for (Index i = first; i < last; ++i) {
        if (!grid.periodic && (i < reach.outer() || i + reach.outer() >= n)) continue;
        visit(StencilRows{row(i - reach.outer()), row(i - reach.whole), row(i), row(i + reach.whole),
                          row(i + reach.outer())},
              grid.heights.cols());
    }
}

/// Calls visit(rows, n) for all stencils along the second index.
template <class Visit>
void visit_along_y(const CurvatureGrid& grid, const Reach& reach, Index first, Index last, const Visit& visit) {
    const Index n = grid.heights.cols(), outer = reach.outer();
    std::vector<double> wrapped;
    for (Index i = first; i < last; ++i) {
        const double* line = grid.heights.row(i).data();
        Index points = n - 2 * outer;
        if (grid.periodic) {
            wrapped.resize(static_cast<std::size_t>(n + 2 * outer));
            for (Index j = 0; j < n + 2 * outer; ++j) wrapped[static_cast<std::size_t>(j)] = line[(j + n - outer) % n];
            line = wrapped.data();
            points = n;
        }
        const double* centre = line + outer;
        if (points > 0)
            visit(StencilRows{line, centre - reach.whole, centre, centre + reach.whole, centre + outer}, points);
    }
}

}  // namespace

CurvatureAtScale curvature_on_grid(const CurvatureGrid& grid, double percentile, parallel::Threads threads) {
    return [grid, percentile, threads](double length) {
        const Reach reach(0.5 * length / grid.step);
        constexpr Index block = 16;
        const Index rows = grid.heights.rows(), blocks = (rows + block - 1) / block;
        std::vector<double> least(static_cast<std::size_t>(blocks), infinite);
        std::vector<std::vector<double>> all(static_cast<std::size_t>(percentile > 0.0 ? blocks : 0));
        parallel::for_each_index(static_cast<std::size_t>(blocks), threads, [&](std::size_t b) {
            const Index first = static_cast<Index>(b) * block, last = std::min(rows, first + block);
            const auto visit = [&](const StencilRows& stencil, Index n) {
                if (percentile > 0.0)
                    for (Index j = 0; j < n; ++j) all[b].push_back(second_difference(stencil, reach.fraction, j));
                else least[b] = std::min(least[b], smallest(stencil, reach.fraction, n));
            };
            if (grid.along_x) visit_along_x(grid, reach, first, last, visit);
            else visit_along_y(grid, reach, first, last, visit);
        });
        double value = *std::min_element(least.begin(), least.end());
        if (percentile > 0.0) {
            std::vector<double> joined;
            for (const auto& part : all) joined.insert(joined.end(), part.begin(), part.end());
            value = quantile(std::move(joined), percentile);
        } else if (value == infinite) {
            value = undefined;
        }
        return value / (0.25 * length * length);
    };
}

CurvatureAtScale curvature_of_profile(const topography::Profile& profile, double percentile) {
    return [&profile, percentile](double length) {
        const auto& x = profile.positions;
        const auto& h = profile.heights;
        const double half = 0.5 * length;
        const Index n = x.size();
        const auto at = [&](double position, Index& segment) {
            while (segment + 2 < n && x[segment + 1] < position) ++segment;
            const double t = (position - x[segment]) / (x[segment + 1] - x[segment]);
            return h[segment] + t * (h[segment + 1] - h[segment]);
        };
        std::vector<double> values;
        for (const double offset : {-half, 0.0, half}) {
            Index left = 0, middle = 0, right = 0;  // segments of the points of the stencil
            for (Index k = 0; k < n; ++k) {
                const double centre = x[k] + offset;
                if (centre - half < x[0] || centre + half > x[n - 1]) continue;
                values.push_back((at(centre - half, left) - 2.0 * at(centre, middle) + at(centre + half, right)) /
                                 (half * half));
            }
        }
        return quantile(std::move(values), percentile);
    };
}

}  // namespace setae::spectra
