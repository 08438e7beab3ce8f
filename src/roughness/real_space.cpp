// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/real_space.hpp"

#include <cmath>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::roughness {
namespace {

/// Sums over one block of map lines, added up in block order afterwards.
struct Sums {
    double h = 0.0, h2 = 0.0;
    double dx2 = 0.0, dy2 = 0.0, laplacian2 = 0.0;
    Index points = 0, dx_points = 0, dy_points = 0, laplacian_points = 0;

    Sums& operator+=(const Sums& other) {
        h += other.h;
        h2 += other.h2;
        dx2 += other.dx2;
        dy2 += other.dy2;
        laplacian2 += other.laplacian2;
        points += other.points;
        dx_points += other.dx_points;
        dy_points += other.dy_points;
        laplacian_points += other.laplacian_points;
        return *this;
    }
};

/// Rows i−1, i, i+1 of a map (previous or next null at an open border) and the pixel sizes.
struct Neighbourhood {
    const double* previous;
    const double* row;
    const double* next;
    Index n;
    double inverse_dx2;
    double inverse_dy2;
    double origin;
    bool periodic;
};

/// Adds the square of a finite difference; NaN drops out by the comparison. Branch-free, so that it vectorises.
inline void add_square(double difference, double& sum, double& count) {
    const bool defined = difference == difference;
    sum += defined ? difference * difference : 0.0;
    count += defined ? 1.0 : 0.0;
}

constexpr Index lanes = 8;

/// Sums of squares kept in independent lanes, so that the compiler needs no reassociation to vectorise.
struct Lanes {
    double sum[lanes] = {};
    double count[lanes] = {};

    void add(Index lane, double difference) { add_square(difference, sum[lane], count[lane]); }
    [[nodiscard]] double total() const { return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7])); }
    [[nodiscard]] Index points() const {
        double all = 0.0;
        for (const double c : count) all += c;
        return static_cast<Index>(all);
    }
};

/// Applies difference(j) for first <= j < last in lanes.
template <class Difference>
Lanes in_lanes(Index first, Index last, Difference difference) {
    Lanes result;
    Index j = first;
    for (; j + lanes <= last; j += lanes)
        for (Index lane = 0; lane < lanes; ++lane) result.add(lane, difference(j + lane));
    for (; j < last; ++j) result.add((j - first) % lanes, difference(j));
    return result;
}

void add_row(const Neighbourhood& at, Sums& sums, double* line_sum, double* line_sum2, double* line_count) {
    const auto n = at.n;
    const double* row = at.row;
    double h_sum[lanes] = {};
    Index j = 0;
    const auto heights = in_lanes(0, n, [&](Index k) { return row[k] - at.origin; });
    for (; j + lanes <= n; j += lanes)
        for (Index lane = 0; lane < lanes; ++lane) {
            const double h = row[j + lane] - at.origin;
            h_sum[lane] += h == h ? h : 0.0;
        }
    for (; j < n; ++j) h_sum[0] += row[j] == row[j] ? row[j] - at.origin : 0.0;
    for (const double s : h_sum) sums.h += s;
    sums.h2 += heights.total();
    sums.points += heights.points();
    for (j = 0; j < n; ++j) {
        const double h = row[j] - at.origin;
        const bool defined = h == h;
        line_sum[j] += defined ? h : 0.0;
        line_sum2[j] += defined ? h * h : 0.0;
        line_count[j] += defined ? 1.0 : 0.0;
    }
    if (at.next) {
        const auto along_x = in_lanes(0, n, [&](Index k) { return at.next[k] - row[k]; });
        sums.dx2 += along_x.total();
        sums.dx_points += along_x.points();
    }
    auto along_y = in_lanes(0, n - 1, [&](Index k) { return row[k + 1] - row[k]; });
    if (at.periodic) along_y.add(0, row[0] - row[n - 1]);
    sums.dy2 += along_y.total();
    sums.dy_points += along_y.points();
    if (at.previous && at.next) {
        const auto laplacian = [&](Index left, Index k, Index right) {
            return (at.previous[k] - 2.0 * row[k] + at.next[k]) * at.inverse_dx2 +
                   (row[left] - 2.0 * row[k] + row[right]) * at.inverse_dy2;
        };
        auto interior = in_lanes(1, n - 1, [&](Index k) { return laplacian(k - 1, k, k + 1); });
        if (at.periodic && n > 2) {
            interior.add(0, laplacian(n - 1, 0, 1));
            interior.add(1, laplacian(n - 2, n - 1, 0));
        }
        sums.laplacian2 += interior.total();
        sums.laplacian_points += interior.points();
    }
}

double ratio(double sum, Index count) { return count > 0 ? sum / static_cast<double>(count) : undefined; }

double variance(double sum, double sum2, double count) {
    if (!(count > 0.0)) return 0.0;
    return std::max(0.0, sum2 / count - (sum / count) * (sum / count));
}

/// A defined height near which sums of squares lose no digits.
double origin_of(const Array2D& heights) {
    for (Index i = 0; i < heights.size(); ++i)
        if (heights.data()[i] == heights.data()[i]) return heights.data()[i];
    throw UndefinedDataError("no defined height to take an rms of");
}

double arithmetic_mean_deviation(const double* heights, Index n, double mean) {
    const auto deviations = in_lanes(0, n, [&](Index k) { return std::sqrt(std::abs(heights[k] - mean)); });
    return ratio(deviations.total(), deviations.points());
}

}  // namespace

RealSpaceParameters real_space_parameters(const topography::HeightMap& map, parallel::Threads threads) {
    constexpr Index block_rows = 64;
    const auto nx = map.heights.rows(), ny = map.heights.cols();
    const auto [dx, dy] = map.pixel_size();
    const double origin = origin_of(map.heights);
    const auto blocks = static_cast<std::size_t>((nx + block_rows - 1) / block_rows);
    std::vector<Sums> partial(blocks);
    Array2D lines = Array2D::Zero(static_cast<Index>(blocks) * 3, ny);
    parallel::for_each_index(blocks, threads, [&](std::size_t b) {
        const auto first = static_cast<Index>(b) * block_rows;
        const auto last = std::min(nx, first + block_rows);
        const auto row = [&](Index i) -> const double* {
            if (map.periodic) i = (i + nx) % nx;
            return i < 0 || i >= nx ? nullptr : map.heights.data() + i * ny;
        };
        for (Index i = first; i < last; ++i) {
            const Neighbourhood at{row(i - 1), row(i), row(i + 1), ny, 1.0 / (dx * dx), 1.0 / (dy * dy), origin, map.periodic};
            const auto line = static_cast<Index>(b) * 3;
            add_row(at, partial[b], lines.row(line).data(), lines.row(line + 1).data(), lines.row(line + 2).data());
        }
    });
    Sums sums;
    for (const auto& block : partial) sums += block;
    Array1D line_sum = Array1D::Zero(ny), line_sum2 = line_sum, line_count = line_sum;
    for (Index b = 0; b < static_cast<Index>(blocks); ++b) {
        line_sum += lines.row(3 * b).transpose();
        line_sum2 += lines.row(3 * b + 1).transpose();
        line_count += lines.row(3 * b + 2).transpose();
    }
    double of_lines = 0.0;
    for (Index j = 0; j < ny; ++j) of_lines += variance(line_sum[j], line_sum2[j], line_count[j]) * line_count[j];

    RealSpaceParameters result;
    const auto points = static_cast<double>(sums.points);
    result.defined = sums.points;
    result.mean_height = origin + sums.h / points;
    result.rms_height = std::sqrt(variance(sums.h, sums.h2, points));
    result.rms_height_of_lines = std::sqrt(of_lines / points);
    result.rms_slope_x = std::sqrt(ratio(sums.dx2, sums.dx_points)) / dx;
    result.rms_slope_y = std::sqrt(ratio(sums.dy2, sums.dy_points)) / dy;
    result.rms_slope = std::hypot(result.rms_slope_x, result.rms_slope_y);
    result.rms_curvature = 0.5 * std::sqrt(ratio(sums.laplacian2, sums.laplacian_points));
    result.arithmetic_height = arithmetic_mean_deviation(map.heights.data(), map.heights.size(), result.mean_height);
    return result;
}

RealSpaceParameters real_space_parameters(const topography::LineScan& scan) {
    const auto n = scan.heights.size();
    const double* h = scan.heights.data();
    const double step = scan.pixel_size();
    const auto at = [&](Index i) { return h[scan.periodic ? (i + n) % n : i]; };
    const auto last_difference = scan.periodic ? n : n - 1;
    const auto defined = (scan.heights == scan.heights).count();
    if (defined == 0) throw UndefinedDataError("no defined height to take an rms of");
    RealSpaceParameters result;
    result.defined = defined;
    result.mean_height = (scan.heights == scan.heights).select(scan.heights, 0.0).sum() / static_cast<double>(defined);
    const auto heights = in_lanes(0, n, [&](Index i) { return h[i] - result.mean_height; });
    const auto slopes = in_lanes(0, last_difference, [&](Index i) { return at(i + 1) - at(i); });
    const auto curvatures = in_lanes(scan.periodic ? 0 : 1, last_difference, [&](Index i) { return at(i - 1) - 2.0 * at(i) + at(i + 1); });
    result.rms_height = result.rms_height_of_lines = std::sqrt(ratio(heights.total(), heights.points()));
    result.rms_slope = result.rms_slope_x = std::sqrt(ratio(slopes.total(), slopes.points())) / step;
    result.rms_slope_y = undefined;
    result.rms_curvature = std::sqrt(ratio(curvatures.total(), curvatures.points())) / (step * step);
    result.arithmetic_height = arithmetic_mean_deviation(h, n, result.mean_height);
    return result;
}

RealSpaceParameters real_space_parameters(const topography::Profile& profile) {
    const auto n = profile.positions.size();
    if (n < 2 || profile.heights.isNaN().any())
        throw UndefinedDataError("a polyline needs at least two points, each with a defined height");
    const Array1D step = profile.positions.tail(n - 1) - profile.positions.head(n - 1);
    const double origin = profile.heights[0];
    const Array1D left = profile.heights.head(n - 1) - origin, right = profile.heights.tail(n - 1) - origin;
    const double length = profile.size();
    const double mean = (0.5 * step * (left + right)).sum() / length;
    const Array1D a = left - mean, b = right - mean;
    const Array1D slope = (right - left) / step;
    RealSpaceParameters result;
    result.defined = n;
    result.mean_height = origin + mean;
    result.rms_height = result.rms_height_of_lines = std::sqrt((step * (a * a + a * b + b * b)).sum() / (3.0 * length));
    result.rms_slope = result.rms_slope_x = std::sqrt((slope.square() * step).sum() / length);
    result.rms_slope_y = result.arithmetic_height = undefined;
    result.rms_curvature = undefined;
    if (n >= 4) {
        const Array1D curvature =
            2.0 * (slope.tail(n - 2) - slope.head(n - 2)) / (step.tail(n - 2) + step.head(n - 2));
        const Array1D squares = curvature.square();
        const Array1D inner = step.segment(1, n - 3);
        const double integral = (0.5 * inner * (squares.head(n - 3) + squares.tail(n - 3))).sum();
        result.rms_curvature = std::sqrt(integral / inner.sum());
    }
    return result;
}

RealSpaceParameters real_space_parameters(const topography::Measurement& measurement, parallel::Threads threads) {
    struct Visitor {
        parallel::Threads threads;
        RealSpaceParameters operator()(const topography::HeightMap& map) const { return real_space_parameters(map, threads); }
        RealSpaceParameters operator()(const topography::LineScan& scan) const { return real_space_parameters(scan); }
        RealSpaceParameters operator()(const topography::Profile& profile) const { return real_space_parameters(profile); }
    };
    return std::visit(Visitor{threads}, measurement);
}

}  // namespace setae::roughness
