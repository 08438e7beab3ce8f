// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "evidence.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/row_blocks.hpp"
#include "setae/roughness/slope_distribution.hpp"

namespace setae::diagnostics {
namespace {

/// Variance of a series about its mean and its autocovariance at lag 1.
struct Series {
    double variance = 0.0, neighbour_covariance = 0.0;
    Index count = 0;
};

Series series(const Array1D& values) {
    const Array1D centred = values - values.mean();
    const Index n = centred.size();
    return {centred.square().sum() / static_cast<double>(n - 1),
            (centred.head(n - 1) * centred.tail(n - 1)).sum() / static_cast<double>(n - 1), n};
}

/// Means over x of the steps from line to line, and over y of those along lines.
struct MeanSteps {
    Series between_lines, along_lines;
};

/// Means over x of each scan line; a few lines are processed together, because they are not contiguous.
Array1D line_means(const Array2D& h, parallel::Threads threads) {
    constexpr Index together = 16;
    const Index ny = h.cols(), blocks = (ny + together - 1) / together;
    Array1D means(ny);
    parallel::for_each_index(static_cast<std::size_t>(blocks), threads, [&](std::size_t block) {
        const Index first = static_cast<Index>(block) * together, count = std::min(together, ny - first);
        const Array2D gathered = h.middleCols(first, count);
        means.segment(first, count) = gathered.colwise().mean().transpose();
    });
    return means;
}

/// Means over y of the points of each place along x.
Array1D column_means(const Array2D& h, parallel::Threads threads) {
    Array1D means(h.rows());
    numerics::for_each_row(h.rows(), h.cols(), threads, [&](Index i) { means[i] = h.row(i).mean(); });
    return means;
}

MeanSteps mean_steps(const Array2D& h, parallel::Threads threads) {
    const Index nx = h.rows(), ny = h.cols();
    const Array1D of_lines = line_means(h, threads), of_columns = column_means(h, threads);
    return {series(of_lines.tail(ny - 1) - of_lines.head(ny - 1)),
            series(of_columns.tail(nx - 1) - of_columns.head(nx - 1))};
}

/// Mean square of the differences of neighbouring scan lines [m²].
double mean_square_rise(const Array2D& heights, parallel::Threads threads) {
    const Index nx = heights.rows(), ny = heights.cols();
    double sum = 0.0;
    for (const double part : numerics::by_row_blocks(
             numerics::RowBlocks(nx, ny), threads, 0.0, [&](Index first, Index last, double& squares) {
                 for (Index i = first; i < last; ++i)
                     squares += (heights.row(i).tail(ny - 1) - heights.row(i).head(ny - 1)).square().sum();
             }))
        sum += part;
    return sum / static_cast<double>(nx * (ny - 1));
}

Found line_offsets(const Evidence& evidence, const DiagnosisOptions& options) {
    const auto& map = evidence.heights;
    const auto pixel = map.pixel_size();
    const auto [lines, along] = mean_steps(map.heights, options.threads);
    if (!(lines.variance > 0.0)) return {};
    // for an isotropic surface var · averaged length/step² is equal in both directions
    const double expected =
        along.variance * (map.size[1] / map.size[0]) * (pixel[1] * pixel[1]) / (pixel[0] * pixel[0]);
    const double excess = lines.variance - expected, offset2 = 0.5 * excess;
    const double correlation = lines.neighbour_covariance / lines.variance;
    // independent offsets of lines give steps with a correlation of −½ to the next one; waves along y do not
    constexpr double alike = -0.2, large = 2.0;
    const double freedom = 0.5;
    const double chance = expected > 0.0
                              ? f_exceedance(lines.variance / expected, freedom * static_cast<double>(lines.count),
                                             freedom * static_cast<double>(along.count))
                              : 0.0;
    if (!(lines.variance > large * expected) || !(correlation < alike) || chance > options.false_alarm) return {};
    const double offset = std::sqrt(offset2),
                 error = offset * 0.5 * std::sqrt(3.0 / static_cast<double>(lines.count)) * lines.variance / excess;
    const double rms = clean_rms_height(evidence), slope2 = 2.0 * offset2 / (pixel[1] * pixel[1]);
    const double share = std::min(1.0, slope2 * pixel[1] * pixel[1] / mean_square_rise(map.heights, options.threads));
    return Finding{
        {"SCAN_DIRECTION", evidence.subject,
         fmt::format("scan lines are offset from each other by {} rms (rms height of the map: {}): steps of the mean "
                     "from line to line are {:.2g} times larger than along the lines, and make up {:.2g} % of the "
                     "mean square slope along y",
                     length_text(offset), length_text(rms), std::sqrt(lines.variance / expected), 100.0 * share),
         "align the rows (step align_rows), or use C1D along the fast axis only"},
        {effect("line_offset_rms", "", offset, "m", error),
         effect("line_steps_over_steps_along_lines", "", std::sqrt(lines.variance / expected), "1"),
         effect("offset_share_of_mean_square_slope_y", "", share, "1"),
         effect("offset_share_of_mean_square_height", "", std::min(1.0, offset2 / (rms * rms)), "1")}};
}

/// Two perpendicular directions with steps of equal length.
struct Pair {
    const roughness::DirectionalSlope *first, *second;
};

Found anisotropy(const Evidence& evidence, const topography::HeightMap& map, const DiagnosisOptions& options) {
    const auto d = roughness::directional_slopes(map, options.threads);
    std::vector<Pair> pairs{{&d[2], &d[3]}};
    if (std::abs(d[2].angle - 0.25 * pi) < 0.01) pairs.push_back({&d[0], &d[1]});
    double strongest = 0.0, error = 0.0;
    const roughness::DirectionalSlope *steep = nullptr, *gentle = nullptr;
    bool significant = false;
    for (const auto& [a, b] : pairs) {
        const double difference = std::log(a->rms / b->rms);
        const double spread = std::hypot(a->rms_standard_error / a->rms, b->rms_standard_error / b->rms);
        const double freedom = static_cast<double>(std::min(a->blocks, b->blocks) - 1);
        if (!(spread > 0.0) || freedom < 1.0) continue;
        if (std::abs(difference) >
            student_t_quantile(1.0 - 0.5 * options.false_alarm / static_cast<double>(pairs.size()), freedom) * spread)
            significant = true;
        if (std::abs(difference) <= strongest) continue;
        strongest = std::abs(difference);
        error = spread;
        steep = difference > 0.0 ? a : b;
        gentle = difference > 0.0 ? b : a;
    }
    constexpr double small = 1.15;
    const double ratio = std::exp(strongest);
    if (!significant || !(ratio > small)) return {};
    const double angle = steep->angle * 180.0 / pi;
    return Finding{
        {"ANISOTROPIC", evidence.subject,
         fmt::format("the rms slope is {:.3g} along {:.0f} degrees from the fast axis and {:.3g} across it, a ratio "
                     "of {:.3g} (standard error {:.2g})",
                     steep->rms, angle, gentle->rms, ratio, ratio * error),
         "use the 2D parameters of the map and measure lines along several directions: 2D parameters "
         "computed from line scans assume isotropy"},
        {effect("slope_ratio", "", ratio, "1", ratio * error), effect("steepest_direction", "", steep->angle, "rad")}};
}

}  // namespace

std::vector<Finding> directions(Evidence& evidence, const DiagnosisOptions& options) {
    std::vector<Finding> found;
    constexpr Index fewest = 16;
    auto& heights = evidence.heights.heights;
    if (evidence.is_line || heights.rows() < fewest || heights.cols() < fewest) return found;
    if (auto offsets = line_offsets(evidence, options)) {
        found.push_back(std::move(*offsets));
        heights.rowwise() -= line_means(heights, options.threads).transpose();
    }
    if (auto finding = anisotropy(evidence, evidence.heights, options)) found.push_back(std::move(*finding));
    return found;
}

}  // namespace setae::diagnostics
