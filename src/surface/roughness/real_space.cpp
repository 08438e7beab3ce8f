// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/real_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/first_defined.hpp"

namespace setae::roughness {
namespace {

/// Sums over one block of map lines, added in block order afterwards.
struct Sums {
    double h = 0.0, h2 = 0.0, dx2 = 0.0, dy2 = 0.0, laplacian2 = 0.0;
    double points = 0.0, dx_points = 0.0, dy_points = 0.0, laplacian_points = 0.0;

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
    [[nodiscard]] bool defined() const {
        const double all = h2 + dx2 + dy2 + laplacian2;
        return !std::isnan(all);
    }
};

/// Row i of a map, or of a band of its lines, with its neighbours (null beyond an open border) and the scales of their
/// differences. Sums run over the points begin … end − 1; those next to them are also read.
struct Neighbourhood {
    const double* previous;
    const double* row;
    const double* next;
    Index n;
    Index begin;
    Index end;
    double inverse_dx2;
    double inverse_dy2;
    double origin;
    bool periodic;
};

/// Per-line sums along x, one entry per line: Σ h, Σ h², points.
struct LineSums {
    double* h;
    double* h2;
    double* points;
};

/// Sum and number of terms. Unchecked, a NaN makes the sum NaN, which the caller detects; checked, it is left out.
struct Sum {
    double sum = 0.0;
    double count = 0.0;
};

/// Σ term(j), first <= j < last, in independent lanes, for vectorisation without reassociation.
template <bool checked, class Term>
Sum sum_of(Index first, Index last, Term term) {
    constexpr Index lanes = 8;
    double sum[lanes] = {}, count[lanes] = {};
    const auto add = [&](Index lane, double value) {
        if constexpr (checked) {
            const bool defined = !std::isnan(value);
            sum[lane] += defined ? value : 0.0;
            count[lane] += defined ? 1.0 : 0.0;
        } else {
            sum[lane] += value;
        }
    };
    Index j = first;
    for (; j + lanes <= last; j += lanes)
        for (Index lane = 0; lane < lanes; ++lane) add(lane, term(j + lane));
    for (; j < last; ++j) add((j - first) % lanes, term(j));
    const auto total = [](const double* v) {
        return ((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7]));
    };
    return {total(sum), checked ? total(count) : static_cast<double>(std::max<Index>(0, last - first))};
}

double square(double x) { return x * x; }

/// Sums over one row, except `lines`.
template <bool checked>
Sums row_sums(const Neighbourhood& at) {
    Sums sums;
    const double* row = at.row;
    const auto n = at.n, begin = at.begin, end = at.end;
    const auto store = [](const Sum& s, double& sum, double& count) {
        sum += s.sum;
        count += s.count;
    };
    double ignored = 0.0;
    store(sum_of<checked>(begin, end, [&](Index j) { return row[j] - at.origin; }), sums.h, ignored);
    store(sum_of<checked>(begin, end, [&](Index j) { return square(row[j] - at.origin); }), sums.h2, sums.points);
    store(sum_of<checked>(begin, std::min(end, n - 1), [&](Index j) { return square(row[j + 1] - row[j]); }), sums.dy2,
          sums.dy_points);
    if (at.periodic)
        store(sum_of<checked>(0, 1, [&](Index) { return square(row[0] - row[n - 1]); }), sums.dy2, sums.dy_points);
    if (at.next)
        store(sum_of<checked>(begin, end, [&](Index j) { return square(at.next[j] - row[j]); }), sums.dx2,
              sums.dx_points);
    if (!at.previous || !at.next) return sums;
    const auto laplacian2 = [&](Index left, Index j, Index right) {
        return square((at.previous[j] - 2.0 * row[j] + at.next[j]) * at.inverse_dx2 +
                      (row[left] - 2.0 * row[j] + row[right]) * at.inverse_dy2);
    };
    store(sum_of<checked>(std::max<Index>(begin, 1), std::min(end, n - 1),
                          [&](Index j) { return laplacian2(j - 1, j, j + 1); }),
          sums.laplacian2, sums.laplacian_points);
    if (at.periodic && n > 2) {
        store(sum_of<checked>(0, 1, [&](Index) { return laplacian2(n - 1, 0, 1); }), sums.laplacian2,
              sums.laplacian_points);
        store(sum_of<checked>(0, 1, [&](Index) { return laplacian2(n - 2, n - 1, 0); }), sums.laplacian2,
              sums.laplacian_points);
    }
    return sums;
}

void add_to_lines(const Neighbourhood& at, bool has_undefined, const LineSums& lines) {
    const double* row = at.row + at.begin;
    const Index count = at.end - at.begin;
    for (Index j = 0; j < count; ++j) {
        const double h = row[j] - at.origin;
        const double defined = has_undefined && std::isnan(h) ? 0.0 : h;
        lines.h[j] += defined;
        lines.h2[j] += defined * defined;
    }
    if (has_undefined)
        for (Index j = 0; j < count; ++j) lines.points[j] += std::isnan(row[j]) ? 0.0 : 1.0;
    else
        for (Index j = 0; j < count; ++j) lines.points[j] += 1.0;
}

/// A row, with a faster method if it and its neighbours are all defined.
Sums add_row(const Neighbourhood& at, const LineSums& lines) {
    const auto quick = row_sums<false>(at);
    const bool undefined_near = !quick.defined();
    add_to_lines(at, undefined_near, lines);
    return undefined_near ? row_sums<true>(at) : quick;
}

double ratio(double sum, double count) { return count > 0.0 ? sum / count : undefined; }

double variance(double sum, double sum2, double count) {
    if (!(count > 0.0)) return 0.0;
    return std::max(0.0, sum2 / count - (sum / count) * (sum / count));
}

[[noreturn]] void nothing_defined() {
    throw UndefinedDataError("no height is defined, so that there is no rms height");
}

/// Scan lines of a map that are processed together with adjacent ones.
struct ScanLines {
    const ArrayView2D& heights;  ///< (nx, lines)
    Index begin, end;            ///< the lines summed over
    bool periodic;               ///< along both directions: the band is the whole map
};

/// Sums over a map, accumulated band by band.
struct MapSums {
    std::array<double, 2> pixel{};
    Sums sums = {};
    double variance_of_lines = 0.0;  ///< Σ over lines of points times variance
    std::optional<double> origin = {};

    void add(const ScanLines& band, parallel::Threads threads) {
        constexpr Index block_rows = 64;
        if (!origin) origin = topography::first_defined(band.heights);
        if (!origin) return;
        const auto nx = band.heights.rows(), lines_count = band.end - band.begin;
        const auto blocks = static_cast<std::size_t>((nx + block_rows - 1) / block_rows);
        std::vector<Sums> partial(blocks);
        Array2D lines = Array2D::Zero(static_cast<Index>(blocks) * 3, lines_count);
        const auto row = [&](Index i) -> const double* {
            if (band.periodic) i = (i + nx) % nx;
            return i < 0 || i >= nx ? nullptr : band.heights.row(i).data();
        };
        parallel::for_each_index(blocks, threads, [&](std::size_t b) {
            const auto first = static_cast<Index>(b) * block_rows, line = first / block_rows * 3;
            for (Index i = first; i < std::min(nx, first + block_rows); ++i)
                partial[b] +=
                    add_row({row(i - 1), row(i), row(i + 1), band.heights.cols(), band.begin, band.end,
                             1.0 / (pixel[0] * pixel[0]), 1.0 / (pixel[1] * pixel[1]), *origin, band.periodic},
                            {lines.row(line).data(), lines.row(line + 1).data(), lines.row(line + 2).data()});
        });
        for (const auto& block : partial) sums += block;
        Array1D sum = Array1D::Zero(lines_count), squares = sum, count = sum;
        for (Index b = 0; b < static_cast<Index>(blocks); ++b) {
            sum += lines.row(3 * b).transpose();
            squares += lines.row(3 * b + 1).transpose();
            count += lines.row(3 * b + 2).transpose();
        }
        for (Index j = 0; j < lines_count; ++j) variance_of_lines += variance(sum[j], squares[j], count[j]) * count[j];
    }

    [[nodiscard]] RealSpaceParameters result() const {
        if (!origin) nothing_defined();
        RealSpaceParameters result;
        result.defined = static_cast<Index>(sums.points);
        result.mean_height = *origin + sums.h / sums.points;
        result.rms_height = std::sqrt(variance(sums.h, sums.h2, sums.points));
        result.rms_height_of_lines = std::sqrt(variance_of_lines / sums.points);
        result.rms_slope_x = std::sqrt(ratio(sums.dx2, sums.dx_points)) / pixel[0];
        result.rms_slope_y = std::sqrt(ratio(sums.dy2, sums.dy_points)) / pixel[1];
        result.rms_slope = std::hypot(result.rms_slope_x, result.rms_slope_y);
        result.rms_curvature = 0.5 * std::sqrt(ratio(sums.laplacian2, sums.laplacian_points));
        return result;
    }
};

/// Root of the mean of squares of defined terms.
template <class Term>
double rms_of(Index first, Index last, Term term) {
    const auto squares = sum_of<true>(first, last, [&](Index j) { return square(term(j)); });
    return std::sqrt(ratio(squares.sum, squares.count));
}

}  // namespace

RealSpaceParameters real_space_parameters(const topography::HeightMap& map, parallel::Threads threads) {
    MapSums sums{map.pixel_size()};
    sums.add({map.heights, 0, map.heights.cols(), map.periodic}, threads);
    return sums.result();
}

RealSpaceParameters real_space_parameters(const topography::TiledMap& map, Index lines_together,
                                          parallel::Threads threads) {
    MapSums sums{map.pixel_size()};
    if (map.periodic) {
        const Array2D whole = map.lines(0, map.ny);  // differences wrap
        sums.add({whole, 0, map.ny, true}, threads);
        return sums.result();
    }
    for (Index first = 0; first < map.ny; first += lines_together) {
        const auto last = std::min(map.ny, first + lines_together), before = first > 0 ? Index{1} : Index{0};
        const Array2D band = map.lines(first - before, std::min(map.ny, last + 1) - first + before);
        sums.add({band, before, last - first + before, false}, threads);
    }
    return sums.result();
}

RealSpaceParameters real_space_parameters(const topography::LineScan& scan) {
    const auto n = scan.heights.size();
    const double* h = scan.heights.data();
    const double step = scan.pixel_size();
    const auto at = [&](Index i) { return h[scan.periodic ? (i + n) % n : i]; };
    const auto last_difference = scan.periodic ? n : n - 1;
    const auto defined = (!scan.heights.isNaN()).count();
    if (defined == 0) nothing_defined();
    RealSpaceParameters result;
    result.defined = defined;
    result.mean_height = (!scan.heights.isNaN()).select(scan.heights, 0.0).sum() / static_cast<double>(defined);
    result.rms_height = result.rms_height_of_lines = rms_of(0, n, [&](Index i) { return h[i] - result.mean_height; });
    result.rms_slope = result.rms_slope_x =
        rms_of(0, last_difference, [&](Index i) { return at(i + 1) - at(i); }) / step;
    result.rms_slope_y = undefined;
    result.rms_curvature =
        rms_of(scan.periodic ? 0 : 1, last_difference, [&](Index i) { return at(i - 1) - 2.0 * at(i) + at(i + 1); }) /
        (step * step);
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
    result.rms_slope_y = undefined;
    result.rms_curvature = undefined;
    if (n >= 4) {
        const Array1D curvature = 2.0 * (slope.tail(n - 2) - slope.head(n - 2)) / (step.tail(n - 2) + step.head(n - 2));
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
        RealSpaceParameters operator()(const topography::HeightMap& map) const {
            return real_space_parameters(map, threads);
        }
        RealSpaceParameters operator()(const topography::LineScan& scan) const { return real_space_parameters(scan); }
        RealSpaceParameters operator()(const topography::Profile& profile) const {
            return real_space_parameters(profile);
        }
    };
    return std::visit(Visitor{threads}, measurement);
}

double arithmetic_height(const topography::Measurement& measurement, double mean_height, parallel::Threads threads) {
    if (std::holds_alternative<topography::Profile>(measurement)) return undefined;
    constexpr Index block = 1 << 16;
    return std::visit(
        [=](const auto& m) {
            const Index n = m.heights.size();
            const double* heights = m.heights.data();
            std::vector<Sum> partial(static_cast<std::size_t>((n + block - 1) / block));
            parallel::for_each_index(partial.size(), threads, [&](std::size_t b) {
                const Index first = static_cast<Index>(b) * block;
                partial[b] = sum_of<true>(first, std::min(n, first + block),
                                          [&](Index j) { return std::abs(heights[j] - mean_height); });
            });
            Sum deviations;
            for (const auto& [sum, count] : partial) {
                deviations.sum += sum;
                deviations.count += count;
            }
            return ratio(deviations.sum, deviations.count);
        },
        measurement);
}

}  // namespace setae::roughness
