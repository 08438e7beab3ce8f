// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_trend.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "setae/core/errors.hpp"
#include "setae/topography/first_defined.hpp"

namespace setae::topography {
namespace {

constexpr Index block_rows = 64;

/// Exponents of u and of v of the six basis functions.
constexpr std::array<std::array<int, 2>, 6> exponents{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {0, 2}, {1, 1}}};

Index terms_of(Trend trend) { return trend == Trend::parabola ? 6 : trend == Trend::tilt ? 3 : 1; }

double centred(Index i, Index n) {
    return n > 1 ? 2.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1.0 : 0.0;
}

/// Σ h v^k over the points of a row, and Σ v^k over the defined ones.
struct RowMoments {
    std::array<double, 3> heights{};
    std::array<double, 5> powers{};
};

/// Positions v of a band's lines, v² beside them, and Σ v^k of all.
struct LinePositions {
    Array1D v, v2;
    std::array<double, 5> powers{};

    LinePositions(Index first, Index count, Index ny) : v(count), v2(count) {
        for (Index j = 0; j < count; ++j) v[j] = centred(first + j, ny);
        v2 = v.square();
        powers = {static_cast<double>(count), v.sum(), v2.sum(), (v * v2).sum(), v2.square().sum()};
    }
};

/// Σ h v^k in independent lanes, so that it vectorises without reassociation; NaN where a height is.
std::array<double, 3> height_moments(const double* heights, Index n, double origin, const LinePositions& at) {
    constexpr Index lanes = 4;
    double sum[3][lanes] = {};
    const double *v = at.v.data(), *v2 = at.v2.data();
    const auto add = [&](Index lane, Index j) {
        const double h = heights[j] - origin;
        sum[0][lane] += h;
        sum[1][lane] += h * v[j];
        sum[2][lane] += h * v2[j];
    };
    Index j = 0;
    for (; j + lanes <= n; j += lanes)
        for (Index lane = 0; lane < lanes; ++lane) add(lane, j + lane);
    for (; j < n; ++j) add(0, j);
    const auto total = [](const double* s) { return (s[0] + s[1]) + (s[2] + s[3]); };
    return {total(sum[0]), total(sum[1]), total(sum[2])};
}

RowMoments row_moments(const double* heights, Index n, double origin, const LinePositions& at) {
    RowMoments moments{height_moments(heights, n, origin, at), at.powers};
    if (moments.heights[0] == moments.heights[0]) return moments;
    moments = {};
    for (Index j = 0; j < n; ++j) {
        const double h = heights[j] - origin;
        if (h != h) continue;
        double power = 1.0;
        for (std::size_t k = 0; k < 5; ++k, power *= at.v[j]) {
            moments.powers[k] += power;
            if (k < 3) moments.heights[k] += h * power;
        }
    }
    return moments;
}

void add_row(MapTrendFit::Moments& sums, const RowMoments& row, double u, Index terms) {
    const std::array<double, 5> power{1.0, u, u * u, u * u * u, u * u * u * u};
    sums.defined += row.powers[0];
    for (Index a = 0; a < terms; ++a) {
        const auto [ua, va] = exponents[static_cast<std::size_t>(a)];
        sums.heights[a] += power[static_cast<std::size_t>(ua)] * row.heights[static_cast<std::size_t>(va)];
        for (Index b = 0; b <= a; ++b) {
            const auto [ub, vb] = exponents[static_cast<std::size_t>(b)];
            sums.gram(a, b) += power[static_cast<std::size_t>(ua + ub)] * row.powers[static_cast<std::size_t>(va + vb)];
        }
    }
}

/// body(first, last) for blocks of rows.
template <class Body>
void for_row_blocks(Index rows, parallel::Threads threads, Body body) {
    const auto blocks = static_cast<std::size_t>((rows + block_rows - 1) / block_rows);
    parallel::for_each_index(blocks, threads, [&](std::size_t b) {
        const auto first = static_cast<Index>(b) * block_rows;
        body(b, first, std::min(rows, first + block_rows));
    });
}

}  // namespace

void MapTrend::subtract_from(Eigen::Ref<Array2D> band, Index first, parallel::Threads threads) const {
    const LinePositions at(first, band.cols(), ny);
    const double* v = at.v.data();
    for_row_blocks(band.rows(), threads, [&](std::size_t, Index begin, Index end) {
        for (Index i = begin; i < end; ++i) {
            const double u = centred(i, nx);
            const double c0 = coefficient[0] + coefficient[1] * u + coefficient[3] * u * u + origin;
            const double c1 = coefficient[2] + coefficient[5] * u, c2 = coefficient[4];
            double* row = band.row(i).data();
            for (Index j = 0; j < band.cols(); ++j) row[j] -= c0 + v[j] * (c1 + v[j] * c2);
        }
    });
}

MapTrendFit::MapTrendFit(Trend trend, Index nx, Index ny) : trend_(trend), nx_(nx), ny_(ny) {}

void MapTrendFit::add(const ArrayView2D& band, Index first, parallel::Threads threads) {
    if (!origin_) origin_ = first_defined(band);
    if (!origin_) return;
    const LinePositions at(first, band.cols(), ny_);
    const Index terms = terms_of(trend_);
    std::vector<Moments> partial(static_cast<std::size_t>((band.rows() + block_rows - 1) / block_rows));
    for_row_blocks(band.rows(), threads, [&](std::size_t b, Index begin, Index end) {
        for (Index i = begin; i < end; ++i)
            add_row(partial[b], row_moments(band.row(i).data(), band.cols(), *origin_, at), centred(i, nx_), terms);
    });
    for (const auto& block : partial) {
        moments_.gram += block.gram;
        moments_.heights += block.heights;
        moments_.defined += block.defined;
    }
}

MapTrend MapTrendFit::solved() const {
    const Index terms = terms_of(trend_);
    if (moments_.defined < static_cast<double>(terms))
        throw UndefinedDataError(fmt::format("{} defined heights, a trend with {} coefficients needs more",
                                             static_cast<Index>(moments_.defined), terms));
    const Eigen::MatrixXd gram = moments_.gram.topLeftCorner(terms, terms).selfadjointView<Eigen::Lower>();
    const Eigen::VectorXd solution = gram.ldlt().solve(moments_.heights.head(terms));
    MapTrend trend{nx_, ny_, *origin_, {}};
    std::copy(solution.begin(), solution.end(), trend.coefficient.begin());
    return trend;
}

}  // namespace setae::topography
