// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/slope_distribution.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::roughness {
namespace {

constexpr int block_count = 16;

/// Raw power sums of slopes; polylines weight each by its step, so collinear points change nothing.
struct PowerSums {
    std::array<double, 5> s{};

    void add(double slope, double weight) {
        if (std::isnan(slope)) return;
        double power = weight;
        for (double& sum : s) {
            sum += power;
            power *= slope;
        }
    }
    PowerSums& operator+=(const PowerSums& other) {
        for (std::size_t k = 0; k < s.size(); ++k) s[k] += other.s[k];
        return *this;
    }
    friend PowerSums operator-(PowerSums a, const PowerSums& b) {
        for (std::size_t k = 0; k < a.s.size(); ++k) a.s[k] -= b.s[k];
        return a;
    }
};

using Blocks = std::array<PowerSums, block_count>;

struct Shape {
    double rms = 0.0, skewness = 0.0, excess_kurtosis = 0.0;
};

Shape shape_of(const PowerSums& sums) {
    const auto& s = sums.s;
    const double m = s[1] / s[0], m2 = s[2] / s[0] - m * m;
    const double m3 = s[3] / s[0] - 3.0 * m * s[2] / s[0] + 2.0 * m * m * m;
    const double m4 = s[4] / s[0] - 4.0 * m * s[3] / s[0] + 6.0 * m * m * s[2] / s[0] - 3.0 * m * m * m * m;
    if (!(m2 > 0.0)) return {};
    return {std::sqrt(m2), m3 / std::pow(m2, 1.5), m4 / (m2 * m2) - 3.0};
}

/// Delete-one-block jackknife of a statistic of Shape.
template <class Statistic>
double jackknife_error(const std::vector<Shape>& without_one, Statistic statistic) {
    const auto n = static_cast<double>(without_one.size());
    if (n < 2.0) return undefined;
    double mean = 0.0, sum2 = 0.0;
    for (const auto& shape : without_one) mean += statistic(shape) / n;
    for (const auto& shape : without_one) sum2 += std::pow(statistic(shape) - mean, 2);
    return std::sqrt((n - 1.0) / n * sum2);
}

DirectionalSlope directional(double angle, const Blocks& blocks) {
    PowerSums all;
    for (const auto& block : blocks) all += block;
    std::vector<Shape> without_one;
    for (const auto& block : blocks)
        if (block.s[0] > 0.0) without_one.push_back(shape_of(all - block));
    const auto shape = shape_of(all);
    return {angle,
            shape.rms,
            jackknife_error(without_one, [](const Shape& s) { return s.rms; }),
            shape.skewness,
            jackknife_error(without_one, [](const Shape& s) { return s.skewness; }),
            shape.excess_kurtosis,
            jackknife_error(without_one, [](const Shape& s) { return s.excess_kurtosis; }),
            static_cast<int>(without_one.size())};
}

std::size_t block_of(Index i, Index n) { return static_cast<std::size_t>(i * block_count / n); }

constexpr int histogram_bins = 40;
constexpr double histogram_range = 5.0;  // in rms
constexpr double bin_width = 2.0 * histogram_range / histogram_bins;

/// Number of slopes per bin about their mean, in units of their rms.
struct Histogram {
    double mean, rms;
    std::array<Index, histogram_bins> counts{};

    void add(double slope) {
        const double bin = (slope - mean) * (1.0 / (rms * bin_width)) + histogram_range / bin_width;
        if (bin >= 0.0 && bin < histogram_bins) ++counts[static_cast<std::size_t>(bin)];
    }
};

struct Slopes {
    std::vector<DirectionalSlope> directions;
    Index defined = 0;  ///< along x
    std::array<Index, histogram_bins> counts{};
};

/// Power sums of the slopes of a map over the cells [i, end_i) × [j, end_j), along x, y and both diagonals
/// simultaneously.
std::array<PowerSums, 4> tile_sums(const topography::HeightMap& map, Index begin_i, Index end_i, Index begin_j,
                                   Index end_j) {
    const auto [dx, dy] = map.pixel_size();
    const double diagonal = std::hypot(dx, dy);
    const Index ny = map.heights.cols();
    double sums[5][4] = {};
    for (Index i = begin_i; i < end_i; ++i) {
        const double *lower = map.heights.data() + i * ny, *upper = lower + ny;
        for (Index j = begin_j; j < end_j; ++j) {
            const double slopes[4] = {(upper[j] - lower[j]) / dx, (lower[j + 1] - lower[j]) / dy,
                                      (upper[j + 1] - lower[j]) / diagonal, (upper[j] - lower[j + 1]) / diagonal};
            for (int direction = 0; direction < 4; ++direction) {
                const bool defined = !std::isnan(slopes[direction]);
                const double slope = defined ? slopes[direction] : 0.0;
                double power = defined ? 1.0 : 0.0;
                for (auto& sum : sums) {
                    sum[direction] += power;
                    power *= slope;
                }
            }
        }
    }
    std::array<PowerSums, 4> result;
    for (std::size_t direction = 0; direction < 4; ++direction)
        for (std::size_t k = 0; k < 5; ++k) result[direction].s[k] = sums[k][direction];
    return result;
}

/// Along x, y and both diagonals, in blocks that are tiles of a 4 × 4 partition: neighbours in both directions remain
/// together.
std::array<Blocks, 4> blocks_of(const topography::HeightMap& map, parallel::Threads threads) {
    constexpr Index tiles = 4;
    const auto nx = map.heights.rows(), ny = map.heights.cols();
    const auto edge = [](Index tile, Index n) { return std::min((tile * n + tiles - 1) / tiles, n - 1); };
    std::array<Blocks, 4> blocks{};
    parallel::for_each_index(block_count, threads, [&](std::size_t block) {
        const Index row = static_cast<Index>(block) / tiles, column = static_cast<Index>(block) % tiles;
        const auto sums = tile_sums(map, edge(row, nx), edge(row + 1, nx), edge(column, ny), edge(column + 1, ny));
        for (std::size_t direction = 0; direction < 4; ++direction) blocks[direction][block] = sums[direction];
    });
    return blocks;
}

std::vector<DirectionalSlope> directions_of(const topography::HeightMap& map, const std::array<Blocks, 4>& blocks) {
    const auto [dx, dy] = map.pixel_size();
    const double tilt = std::atan2(dy, dx);
    return {directional(0.0, blocks[0]), directional(0.5 * pi, blocks[1]), directional(tilt, blocks[2]),
            directional(-tilt, blocks[3])};
}

Slopes slopes_of(const topography::HeightMap& map, parallel::Threads threads) {
    const auto blocks = blocks_of(map, threads);
    const auto nx = map.heights.rows(), ny = map.heights.cols();
    const double dx = map.pixel_size()[0];
    Slopes slopes;
    slopes.directions = directions_of(map, blocks);
    PowerSums along_x;
    for (const auto& block : blocks[0]) along_x += block;
    slopes.defined = static_cast<Index>(along_x.s[0]);
    std::array<Histogram, block_count> histograms;
    histograms.fill({along_x.s[1] / along_x.s[0], slopes.directions.front().rms});
    parallel::for_each_index(block_count, threads, [&](std::size_t block) {
        const Index part = static_cast<Index>(block);
        for (Index i = part * (nx - 1) / block_count; i < (part + 1) * (nx - 1) / block_count; ++i)
            for (Index j = 0; j + 1 < ny; ++j) histograms[block].add((map.heights(i + 1, j) - map.heights(i, j)) / dx);
    });
    for (const auto& histogram : histograms)
        for (std::size_t bin = 0; bin < slopes.counts.size(); ++bin) slopes.counts[bin] += histogram.counts[bin];
    return slopes;
}

/// For n segments along a line: step(i) and rise(i), each slope weighted by its step.
template <class Step, class Rise>
Slopes slopes_along_line(Index n, Step step, Rise rise) {
    Blocks blocks{};
    std::vector<double> defined;
    for (Index i = 0; i < n; ++i) {
        const double slope = rise(i) / step(i);
        blocks[block_of(i, n)].add(slope, step(i));
        if (!std::isnan(slope)) defined.push_back(slope);
    }
    Slopes slopes{{directional(0.0, blocks)}, std::ssize(defined)};
    Histogram histogram{0.0, slopes.directions.front().rms};
    for (const double slope : defined) histogram.mean += slope / static_cast<double>(defined.size());
    for (const double slope : defined) histogram.add(slope);
    slopes.counts = histogram.counts;
    return slopes;
}

Slopes slopes_of(const topography::LineScan& scan, parallel::Threads) {
    const auto& h = scan.heights;
    return slopes_along_line(
        h.size() - 1, [step = scan.pixel_size()](Index) { return step; }, [&](Index i) { return h[i + 1] - h[i]; });
}

Slopes slopes_of(const topography::Profile& profile, parallel::Threads) {
    const auto &x = profile.positions, &h = profile.heights;
    return slopes_along_line(
        x.size() - 1, [&](Index i) { return x[i + 1] - x[i]; }, [&](Index i) { return h[i + 1] - h[i]; });
}

void fill_histogram(SlopeDistribution& distribution, const Slopes& slopes) {
    distribution.slope =
        Array1D::LinSpaced(histogram_bins, -histogram_range + 0.5 * bin_width, histogram_range - 0.5 * bin_width);
    distribution.density.resize(histogram_bins);
    for (Index bin = 0; bin < histogram_bins; ++bin)
        distribution.density[bin] = static_cast<double>(slopes.counts[static_cast<std::size_t>(bin)]) /
                                    (static_cast<double>(slopes.defined) * bin_width);
}

double chi_squared_p_value(double chi2, int degrees_of_freedom) {
    if (!std::isfinite(chi2)) return undefined;
    return chi_squared_exceedance(chi2, degrees_of_freedom);
}

/// The direction with the strongest evidence, corrected for multiple tests (Bonferroni).
double gaussian_p_value(const std::vector<DirectionalSlope>& directions) {
    double smallest = 1.0;
    for (const auto& d : directions) {
        const double chi2 = std::pow(d.skewness / d.skewness_standard_error, 2) +
                            std::pow(d.excess_kurtosis / d.excess_kurtosis_standard_error, 2);
        smallest = std::min(smallest, chi_squared_p_value(chi2, 2));
    }
    return std::min(1.0, smallest * static_cast<double>(directions.size()));
}

/// Perpendicular directions with equal steps, so resolution does not mimic anisotropy: the diagonals always, x and y if
/// pixels are square.
std::vector<std::pair<DirectionalSlope, DirectionalSlope>> comparable(const std::vector<DirectionalSlope>& d) {
    std::vector<std::pair<DirectionalSlope, DirectionalSlope>> pairs{{d[2], d[3]}};
    if (std::abs(d[2].angle - 0.25 * pi) < 0.01) pairs.emplace_back(d[0], d[1]);
    return pairs;
}

double isotropy_p_value(const std::vector<DirectionalSlope>& d) {
    double smallest = 1.0;
    const auto pairs = comparable(d);
    for (const auto& [a, b] : pairs) {
        const double difference = std::log(a.rms / b.rms);
        const double error2 = std::pow(a.rms_standard_error / a.rms, 2) + std::pow(b.rms_standard_error / b.rms, 2);
        smallest = std::min(smallest, chi_squared_p_value(difference * difference / error2, 1));
    }
    return std::min(1.0, static_cast<double>(pairs.size()) * smallest);
}

double isotropy_ratio(const std::vector<DirectionalSlope>& d) {
    double largest = 0.0;
    for (const auto& [a, b] : comparable(d)) largest = std::max(largest, std::abs(std::log(a.rms / b.rms)));
    return std::exp(largest);
}

void add_alerts(SlopeDistribution& distribution, const std::string& subject) {
    constexpr double significance = 0.01, shape_size = 0.5, anisotropy_size = 1.1;
    double kurtosis = 0.0, skewness = 0.0;
    for (const auto& d : distribution.directions) {
        if (std::abs(d.excess_kurtosis) > std::abs(kurtosis)) kurtosis = d.excess_kurtosis;
        if (std::abs(d.skewness) > std::abs(skewness)) skewness = d.skewness;
    }
    if (distribution.gaussian_p_value < significance &&
        (std::abs(kurtosis) > shape_size || std::abs(skewness) > shape_size))
        distribution.alerts.push_back(
            {"NON_GAUSSIAN", subject,
             fmt::format("the slopes have an excess kurtosis of {:.2g} and a skewness of {:.2g} (p = {:.1e})", kurtosis,
                         skewness, distribution.gaussian_p_value),
             "use the triangulated area of maps: the true area by Eq. 9 assumes Gaussian slopes"});
    if (distribution.directions.size() == 1) {
        distribution.alerts.push_back(
            {"ONE_DIRECTION", subject, "a line contains slopes along one direction only",
             "measure lines along several directions, or a map, to test the isotropy that 2D parameters "
             "assume"});
        return;
    }
    if (distribution.isotropy_p_value < significance && distribution.isotropy_ratio > anisotropy_size)
        distribution.alerts.push_back(
            {"ANISOTROPIC", subject,
             fmt::format("the rms slopes of perpendicular directions differ by a factor {:.3g} (p = {:.1e})",
                         distribution.isotropy_ratio, distribution.isotropy_p_value),
             "measure along several directions: 2D parameters computed from line scans assume isotropy"});
}

}  // namespace

SlopeDistribution slope_distribution(const topography::Measurement& measurement, parallel::Threads threads) {
    const auto slopes = std::visit([threads](const auto& m) { return slopes_of(m, threads); }, measurement);
    const auto& subject = topography::metadata(measurement).file;
    if (slopes.defined < 32)
        throw UndefinedDataError(fmt::format("{}: {} defined slopes; expected at least 32", subject, slopes.defined));
    SlopeDistribution distribution;
    distribution.directions = slopes.directions;
    fill_histogram(distribution, slopes);
    distribution.gaussian_p_value = gaussian_p_value(slopes.directions);
    const bool map = slopes.directions.size() > 1;
    distribution.isotropy_ratio = map ? isotropy_ratio(slopes.directions) : undefined;
    distribution.isotropy_p_value = map ? isotropy_p_value(slopes.directions) : undefined;
    add_alerts(distribution, subject);
    return distribution;
}

std::vector<DirectionalSlope> directional_slopes(const topography::HeightMap& map, parallel::Threads threads) {
    return directions_of(map, blocks_of(map, threads));
}

}  // namespace setae::roughness
