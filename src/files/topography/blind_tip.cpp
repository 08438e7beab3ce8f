// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/blind_tip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/topography/dilation.hpp"
#include "tip_contact.hpp"

namespace setae::topography {
namespace {

struct Point {
    Index x, y;
};

void require(const HeightMap& image, const BlindTipOptions& options) {
    const auto [nx, ny] = image.shape();
    const Index px = options.points_x, py = options.points_y;
    if (px < 1 || py < 1 || px % 2 == 0 || py % 2 == 0)
        throw InvalidArgument(fmt::format("tip estimate of {} by {} points; expected odd positive numbers", px, py));
    if (!image.periodic && (nx < 2 * px - 1 || ny < 2 * py - 1))
        throw InvalidArgument(fmt::format(
            "{}: tip estimate of {} by {} points on a map of {} by {}; expected a map of at least {} by {}, or "
            "fewer points",
            label(image.metadata), px, py, nx, ny, 2 * px - 1, 2 * py - 1));
    if (!(options.noise_threshold >= 0.0) || !std::isfinite(options.noise_threshold))
        throw InvalidArgument(
            fmt::format("noise threshold {} m; expected a finite number >= 0", options.noise_threshold));
    if (options.rounds < 1) throw InvalidArgument(fmt::format("{} rounds; expected at least one", options.rounds));
}

/// The image, continued on all sides if it is periodic.
Array2D continued(const HeightMap& image, Index margin_x, Index margin_y) {
    if (!image.periodic) return image.heights;
    const auto [nx, ny] = image.shape();
    const auto wrapped = [](Index index, Index points) { return ((index % points) + points) % points; };
    return Array2D::NullaryExpr(nx + 2 * margin_x, ny + 2 * margin_y, [&, nx = nx, ny = ny](Index i, Index j) {
        return image.heights(wrapped(i - margin_x, nx), wrapped(j - margin_y, ny));
    });
}

/// Points with twice the extent around them, all of it defined.
std::vector<Point> usable_points(const Array2D& image, Index margin_x, Index margin_y) {
    using Counts = Eigen::Array<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Counts above =
        Counts::Zero(image.rows() + 1, image.cols() + 1);  // undefined heights among the first rows and columns
    for (Index i = 0; i < image.rows(); ++i)
        for (Index j = 0; j < image.cols(); ++j)
            above(i + 1, j + 1) = above(i, j + 1) + above(i + 1, j) - above(i, j) + (std::isnan(image(i, j)) ? 1 : 0);
    std::vector<Point> points;
    for (Index i = margin_x; i + margin_x < image.rows(); ++i)
        for (Index j = margin_y; j + margin_y < image.cols(); ++j) {
            const Index top = i - margin_x, bottom = i + margin_x + 1, left = j - margin_y, right = j + margin_y + 1;
            if (above(bottom, right) - above(top, right) - above(bottom, left) + above(top, left) == 0)
                points.push_back({i, j});
        }
    return points;
}

/// An estimate that starts from a flat plate.
class Estimate {
public:
    Estimate(const Array2D& image, double threshold, const BlindTipOptions& options)
        : image_(image),
          tip_(Array2D::Zero(options.points_x, options.points_y)),
          threshold_(threshold),
          threads_(options.threads) {}

    [[nodiscard]] const Array2D& tip() const { return tip_; }

    /// Applies the conditions of points; true if that sharpened the tip. Each batch uses the tip after the previous
    /// batch.
    bool sharpen(const std::vector<Point>& points) {
        constexpr std::size_t batch = 32;
        bool sharper = false;
        std::vector<std::optional<Array2D>> demands(batch);
        for (std::size_t first = 0; first < points.size(); first += batch) {
            const std::size_t count = std::min(batch, points.size() - first);
            parallel::for_each_index(count, threads_, [&](std::size_t k) { demands[k] = demand(points[first + k]); });
            for (std::size_t k = 0; k < count; ++k)
                if (demands[k] && (*demands[k] - threshold_ > tip_).any()) {
                    tip_ = tip_.max(*demands[k] - threshold_);
                    sharper = true;
                }
        }
        return sharper;
    }

private:
    /// Lowest heights of the tip allowed by the image around a point; empty if the tip satisfies them.
    std::optional<Array2D> demand(Point point) const {
        constexpr int between_checks = 8;
        const Index nx = tip_.rows(), ny = tip_.cols();
        const double here = image_(point.x, point.y);
        const Array2D turned = tip_.reverse();
        Array2D lowest = Array2D::Constant(nx, ny, std::numeric_limits<double>::infinity());  // of t(−v)
        int contacts = 0;
        for (Index i = 0; i < nx; ++i)
            for (Index j = 0; j < ny; ++j) {
                const Index at_x = point.x + i - nx / 2, at_y = point.y + j - ny / 2;
                const double surface = here + tip_(i, j);
                if (image_(at_x, at_y) < surface - threshold_) continue;
                lowest = lowest.min(surface - image_.block(at_x - nx / 2, at_y - ny / 2, nx, ny));
                if (++contacts % between_checks == 0 && !(lowest - threshold_ > turned).any()) return {};
            }
        return Array2D(lowest.reverse());
    }

    const Array2D& image_;
    Array2D tip_;
    double threshold_;
    parallel::Threads threads_;
};

/// Points without a higher point within the extent.
std::vector<Point> peaks(const Array2D& image, const std::vector<Point>& points, Index reach_x, Index reach_y) {
    std::vector<Point> result;
    for (const auto& [x, y] : points)
        if (image(x, y) >= image.block(x - reach_x, y - reach_y, 2 * reach_x + 1, 2 * reach_y + 1).maxCoeff())
            result.push_back({x, y});
    return result;
}

}  // namespace

BlindTip blind_tip(const HeightMap& image, const BlindTipOptions& options) {
    require(image, options);
    const Index reach_x = options.points_x / 2, reach_y = options.points_y / 2;
    const HeightMap whole{continued(image, 2 * reach_x, 2 * reach_y), {}, false, image.metadata};
    const auto points = usable_points(whole.heights, 2 * reach_x, 2 * reach_y);
    if (points.empty())
        throw UndefinedDataError(
            fmt::format("{}: every point has undefined heights within {} by {} points around it; expected larger "
                        "defined parts, or a tip estimate of fewer points",
                        label(image.metadata), 2 * reach_x, 2 * reach_y));
    const double threshold = options.noise_threshold + 1e-12 * height_range(whole, {.threads = options.threads});
    Estimate estimate(whole.heights, threshold, options);
    BlindTip result;
    result.tip.centre_x = reach_x;
    result.tip.centre_y = reach_y;
    result.tip.pixel_size = image.pixel_size();
    auto map = whole;
    map.size = {result.tip.pixel_size[0] * static_cast<double>(whole.heights.rows()),
                result.tip.pixel_size[1] * static_cast<double>(whole.heights.cols())};

    const auto summits = peaks(whole.heights, points, reach_x, reach_y);
    while (result.rounds < options.rounds && estimate.sharpen(summits)) ++result.rounds;
    while (result.rounds < options.rounds && !result.converged) {
        result.tip.heights = estimate.tip();
        const auto opened =
            dilated(eroded(map, result.tip, {.threads = options.threads}), result.tip, {.threads = options.threads});
        std::vector<Point> contradicting;
        for (const auto& point : points)
            if (map.heights(point.x, point.y) - opened.heights(point.x, point.y) > threshold)
                contradicting.push_back(point);
        result.converged = !estimate.sharpen(contradicting);
        ++result.rounds;
    }
    result.tip.heights = estimate.tip();
    return result;
}

}  // namespace setae::topography
