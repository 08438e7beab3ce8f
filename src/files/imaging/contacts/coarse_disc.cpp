// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarse_disc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Cholesky>

#include "setae/core/statistics.hpp"

namespace setae::imaging {
namespace {

using Grey = FramePixels;

constexpr long pixels_across = 200;
constexpr double false_alarms = 0.01;    // gradients of pure noise accepted per frame
constexpr double min_gradient = 1.2e-3;  // of the largest grey level: a third of a level of 8 bits per pixel
constexpr double padding = 0.25;         // centres may be outside the frame by this share of it
constexpr std::size_t max_candidates = 3;
constexpr int rays = 96;

Grey binned(const Grey& pixels, long k) {
    if (k == 1) return pixels;
    Grey result(pixels.rows() / k, pixels.cols() / k);
    Eigen::ArrayXf row_sum(pixels.cols());
    for (long i = 0; i < result.rows(); ++i) {
        row_sum = pixels.row(i * k).transpose();
        for (long r = 1; r < k; ++r) row_sum += pixels.row(i * k + r).transpose();
        for (long j = 0; j < result.cols(); ++j)
            result(i, j) = row_sum.segment(j * k, k).sum() / static_cast<float>(k * k);
    }
    return result;
}

/// Subtracts the parabola of least squares.
void take_illumination_off(Grey& grey) {
    using Matrix = Eigen::Matrix<double, 6, 6>;
    using Vector = Eigen::Matrix<double, 6, 1>;
    const double half_x = 0.5 * static_cast<double>(grey.cols()), half_y = 0.5 * static_cast<double>(grey.rows());
    const auto terms = [&](long row, long column) {
        const double x = (static_cast<double>(column) - half_x) / half_x,
                     y = (static_cast<double>(row) - half_y) / half_y;
        return Vector{1.0, x, y, x * x, x * y, y * y};
    };
    Matrix normal = Matrix::Zero();
    Vector right = Vector::Zero();
    for (long row = 0; row < grey.rows(); row += 2)
        for (long column = 0; column < grey.cols(); column += 2) {
            const auto t = terms(row, column);
            normal.selfadjointView<Eigen::Lower>().rankUpdate(t);
            right += static_cast<double>(grey(row, column)) * t;
        }
    const Vector coefficients = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
    for (long row = 0; row < grey.rows(); ++row)
        for (long column = 0; column < grey.cols(); ++column)
            grey(row, column) -= static_cast<float>(terms(row, column).dot(coefficients));
}

float lower_quartile(const std::vector<float>& values) { return upper_quantile(values, 0.25); }

/// Standard deviation of one pixel's noise from a mask that is insensitive to planes, with pixels far enough apart for
/// noise blurred by a camera; by the lower quartile of magnitudes, as structure may fill half of a frame. Source:
/// Immerkær, Computer Vision and Image Understanding 64 (1996) 300, who takes the mean and next neighbours.
double noise_of(const Grey& grey) {
    constexpr long apart = 3;
    constexpr double quartile = 0.3186;  // of the magnitude of a Gaussian
    std::vector<float> responses;
    responses.reserve(static_cast<std::size_t>(grey.size()));
    for (long i = apart; i + apart < grey.rows(); ++i)
        for (long j = apart; j + apart < grey.cols(); ++j)
            responses.push_back(std::abs(grey(i - apart, j - apart) - 2 * grey(i - apart, j) +
                                         grey(i - apart, j + apart) - 2 * grey(i, j - apart) + 4 * grey(i, j) -
                                         2 * grey(i, j + apart) + grey(i + apart, j - apart) - 2 * grey(i + apart, j) +
                                         grey(i + apart, j + apart)));
    return static_cast<double>(lower_quartile(responses)) / (6.0 * quartile);
}

/// Averages over 1 2 1 in both directions.
Grey smoothed(const Grey& grey) {
    Grey rows = grey, result = grey;
    const long n = grey.cols(), m = grey.rows();
    rows.middleCols(1, n - 2) =
        0.25f * (grey.leftCols(n - 2) + grey.rightCols(n - 2)) + 0.5f * grey.middleCols(1, n - 2);
    result = rows;
    result.middleRows(1, m - 2) =
        0.25f * (rows.topRows(m - 2) + rows.bottomRows(m - 2)) + 0.5f * rows.middleRows(1, m - 2);
    return result;
}

struct Votes {
    Grey count;
    long pad_x = 0, pad_y = 0;
    bool any = false;
};

Votes votes_for_centres(const Grey& grey, double brightest, double smallest_radius, double sign) {
    constexpr double quartile = 0.7585;  // of Rayleigh's distribution: the magnitude of two Gaussians
    Votes votes;
    votes.pad_x = static_cast<long>(padding * static_cast<double>(grey.cols())) + 1;
    votes.pad_y = static_cast<long>(padding * static_cast<double>(grey.rows())) + 1;
    votes.count = Grey::Zero(grey.rows() + 2 * votes.pad_y, grey.cols() + 2 * votes.pad_x);
    const Grey soft = smoothed(grey);
    std::vector<float> steepnesses;
    steepnesses.reserve(static_cast<std::size_t>(grey.size()));
    for (long i = 2; i + 2 < grey.rows(); ++i)
        for (long j = 2; j + 2 < grey.cols(); ++j) {
            const float gx = 0.5f * (soft(i, j + 1) - soft(i, j - 1)), gy = 0.5f * (soft(i + 1, j) - soft(i - 1, j));
            steepnesses.push_back(std::sqrt(gx * gx + gy * gy));
        }
    const float steepest = *std::max_element(steepnesses.begin(), steepnesses.end());
    const double noise_above =
        std::sqrt(2 * std::log(static_cast<double>(steepnesses.size()) / false_alarms));  // Rayleigh
    const double threshold =
        std::max(noise_above * static_cast<double>(lower_quartile(steepnesses)) / quartile, min_gradient * brightest);
    if (steepest < threshold) return votes;
    votes.any = true;
    const auto floor = static_cast<float>(std::max(threshold, 0.2 * static_cast<double>(steepest)));
    const double farthest = 0.75 * static_cast<double>(std::max(grey.rows(), grey.cols()));
    for (long i = 2; i + 2 < grey.rows(); ++i)
        for (long j = 2; j + 2 < grey.cols(); ++j) {
            const float gx = 0.5f * (soft(i, j + 1) - soft(i, j - 1)), gy = 0.5f * (soft(i + 1, j) - soft(i - 1, j));
            const float steepness = std::sqrt(gx * gx + gy * gy);
            if (steepness < floor) continue;
            for (const double side : {-1.0, 1.0}) {
                if (sign * side > 0) continue;  // brighter outside: the centre is against the gradient
                const double dx = side * gx / steepness, dy = side * gy / steepness;
                const float weight = std::min(1.0f, 2.0f * steepness / steepest);
                for (double r = smallest_radius; r < farthest; r += 1.0) {
                    const long x = std::lround(static_cast<double>(j) + r * dx) + votes.pad_x,
                               y = std::lround(static_cast<double>(i) + r * dy) + votes.pad_y;
                    if (x < 0 || y < 0 || x >= votes.count.cols() || y >= votes.count.rows()) break;
                    votes.count(y, x) += weight;
                }
            }
        }
    votes.count = smoothed(smoothed(votes.count));
    return votes;
}

/// Mean over circles about a centre, and the number of pixels of each in the frame.
struct RadialMean {
    std::vector<double> mean, count;
};

RadialMean radial_mean(const Grey& grey, double centre_x, double centre_y) {
    const double width = static_cast<double>(grey.cols()), height = static_cast<double>(grey.rows());
    const double reach = std::hypot(std::max(std::abs(centre_x), std::abs(centre_x - width)),
                                    std::max(std::abs(centre_y), std::abs(centre_y - height)));
    RadialMean radial;
    radial.mean.assign(static_cast<std::size_t>(reach) + 2, 0.0);
    radial.count = radial.mean;
    for (long i = 0; i < grey.rows(); ++i)
        for (long j = 0; j < grey.cols(); ++j) {
            const double dx = static_cast<double>(j) - centre_x, dy = static_cast<double>(i) - centre_y;
            const auto bin = static_cast<std::size_t>(std::sqrt(dx * dx + dy * dy));
            radial.mean[bin] += static_cast<double>(grey(i, j));
            radial.count[bin] += 1;
        }
    for (std::size_t k = 0; k < radial.mean.size(); ++k)
        if (radial.count[k] > 0) radial.mean[k] /= radial.count[k];
    return radial;
}

struct RadialStep {
    double radius = 0, step = 0,
           strength = 0;  ///< strength: step times the square root of the pixels, proportional to its signal over noise
};

/// End of the plateau of the centre in the radial mean: a third of its largest deviation from the plateau.
std::optional<RadialStep> end_of_plateau(const RadialMean& radial, double noise, double smallest_radius, double sign) {
    constexpr double share = 1.0 / 3, outstanding = 6.0;
    double sum = 0, count = 0, farthest = 0;
    std::size_t begin = 0;
    for (; begin < radial.mean.size() && (static_cast<double>(begin) < 0.7 * smallest_radius || count < 9); ++begin) {
        sum += radial.mean[begin] * radial.count[begin];
        count += radial.count[begin];
    }
    for (std::size_t k = begin; k < radial.mean.size(); ++k)
        if (radial.count[k] > 0.3 * 2 * std::numbers::pi * static_cast<double>(k) &&
            sign * (radial.mean[k] - sum / count) >= 0)
            farthest = std::max(farthest, std::abs(radial.mean[k] - sum / count));
    for (std::size_t k = begin; k < radial.mean.size(); ++k) {
        if (radial.count[k] == 0) continue;
        const double step = radial.mean[k] - sum / count;
        if (std::abs(step) > share * farthest && std::abs(step) > outstanding * noise / std::sqrt(radial.count[k]) &&
            sign * step >= 0)
            return RadialStep{static_cast<double>(k), step > 0 ? farthest : -farthest,
                              farthest * std::sqrt(radial.count[k])};
        sum += radial.mean[k] * radial.count[k];
        count += radial.count[k];
    }
    return std::nullopt;
}

/// The strongest step of the radial mean; with fringes the end of the plateau.
std::optional<RadialStep> edge_of(const RadialMean& radial, double noise, double smallest_radius, double sign,
                                  bool fringes) {
    if (fringes) return end_of_plateau(radial, noise, smallest_radius, sign);
    constexpr double outstanding = 6.0;
    constexpr std::size_t reach = 2;
    std::vector<RadialStep> steps;
    for (auto at = static_cast<std::size_t>(std::max(1.0, smallest_radius)); at + reach < radial.mean.size(); ++at) {
        double inner = 0, outer = 0, inner_count = 0, outer_count = 0;
        for (std::size_t k = 0; k < reach; ++k) {
            outer += radial.mean[at + k] * radial.count[at + k];
            outer_count += radial.count[at + k];
            if (at < k + 1) continue;
            inner += radial.mean[at - 1 - k] * radial.count[at - 1 - k];
            inner_count += radial.count[at - 1 - k];
        }
        if (inner_count < 1 || outer_count < 1) continue;
        const double whole = 2 * std::numbers::pi * static_cast<double>(at) * reach;
        if (inner_count + outer_count < 0.15 * 2 * whole) continue;  // too little of it is in the frame
        const double step = outer / outer_count - inner / inner_count;
        const bool is_significant =
            sign * step >= 0 && std::abs(step) > outstanding * noise * std::sqrt(1 / inner_count + 1 / outer_count);
        steps.push_back({static_cast<double>(at), is_significant ? step : 0.0,
                         is_significant ? std::abs(step) * std::sqrt(outer_count) : 0.0});
    }
    const auto strongest = std::max_element(steps.begin(), steps.end(),
                                            [](const auto& a, const auto& b) { return a.strength < b.strength; });
    if (strongest == steps.end() || strongest->strength <= 0) return std::nullopt;
    return *strongest;
}

double between_pixels(const Grey& grey, double x, double y) {
    const auto column = static_cast<long>(x), row = static_cast<long>(y);
    const double fx = x - static_cast<double>(column), fy = y - static_cast<double>(row);
    const auto at = [&](long i, long j) { return static_cast<double>(grey(i, j)); };
    return (1 - fy) * ((1 - fx) * at(row, column) + fx * at(row, column + 1)) +
           fy * ((1 - fx) * at(row + 1, column) + fx * at(row + 1, column + 1));
}

/// Points of the edge along rays within a third of the radius of the outline.
std::vector<EdgePoint> edge_points(const Grey& grey, const Outline& outline, double sign, bool fringes) {
    constexpr double pitch = 0.5, share = 0.5;
    constexpr long reach = 3;  // samples on either side
    std::vector<EdgePoint> points;
    std::vector<double> samples, steps;
    for (int ray = 0; ray < rays; ++ray) {
        const double angle = 2 * std::numbers::pi * ray / rays, c = std::cos(angle), s = std::sin(angle);
        const double radius = outline.radius_at(angle), range = std::max(3.0, (fringes ? 0.15 : 0.35) * radius);
        const double from = std::max(0.0, radius - range - reach * pitch), to = radius + range + reach * pitch;
        samples.clear();
        double begin = from;
        for (double r = from; r <= to; r += pitch) {
            const double x = outline.centre_x + r * c, y = outline.centre_y + r * s;
            if (x < 0 || y < 0 || x >= static_cast<double>(grey.cols() - 1) ||
                y >= static_cast<double>(grey.rows() - 1)) {
                if (samples.empty()) begin = r + pitch;
                else break;
                continue;
            }
            samples.push_back(between_pixels(grey, x, y));
        }
        const auto n = static_cast<long>(samples.size());
        steps.assign(samples.size(), 0.0);
        long best = -1;
        for (long i = reach; i + reach < n; ++i) {
            double step = 0;
            for (long k = 0; k < reach; ++k)
                step += samples[static_cast<std::size_t>(i + 1 + k)] - samples[static_cast<std::size_t>(i - 1 - k)];
            steps[static_cast<std::size_t>(i)] = sign * step;
            if (best < 0 || sign * step > steps[static_cast<std::size_t>(best)]) best = i;
        }
        if (best < 0 || steps[static_cast<std::size_t>(best)] <= 0) continue;
        if (fringes) {
            // the first sufficiently high peak of steps
            const double enough = share * steps[static_cast<std::size_t>(best)];
            for (long i = reach + 1; i < best; ++i) {
                const auto at = static_cast<std::size_t>(i);
                if (steps[at] > enough && steps[at] >= steps[at - 1] && steps[at] >= steps[at + 1]) best = i;
            }
        }
        const double r = begin + pitch * static_cast<double>(best);
        points.push_back({outline.centre_x + r * c, outline.centre_y + r * s});
    }
    return points;
}

/// The outline through points of the edge; empty if there is none.
std::optional<Outline> outline_through(const std::vector<EdgePoint>& points, const Outline& start) {
    if (points.size() < 12) return std::nullopt;
    Outline outline = consensus_circle(points, std::max(1.0, 0.06 * start.mean_radius), start);
    const auto shape = points.size() > rays * 4 / 5 ? OutlineShape::ellipse : OutlineShape::circle;
    for (int round = 0; round < 4; ++round) {
        const OutlineDistance distance(outline);
        std::vector<EdgeOffset> offsets;
        for (const auto& p : points)
            offsets.push_back({std::atan2(p.y - outline.centre_y, p.x - outline.centre_x), distance(p.x, p.y), 1.0});
        const auto correction = corrected_outline(outline, offsets, shape);
        if (!correction.solved || correction.outline.mean_radius <= 0) return outline;
        outline = correction.outline;
    }
    return outline;
}

struct Search {
    std::vector<CoarseDisc> discs;
    bool structure = false;
};

Search search(const FramePixels& pixels, long k, const ContactFrameOptions& options) {
    Grey grey = binned(pixels, k);
    const double brightest = static_cast<double>(grey.abs().maxCoeff());
    const Grey as_seen = options.fringes ? grey : Grey();  // the subtracted parabola bends the plateau of large
                                                           // contacts
    take_illumination_off(grey);
    const double noise = std::max(noise_of(grey), 1e-7 * brightest);
    const double smallest = 0.7 * options.smallest_radius / static_cast<double>(k);
    const double wanted = options.polarity == Polarity::automatic ? 0.0
                          : options.polarity == Polarity::dark    ? 1.0
                                                                  : -1.0;
    auto votes = votes_for_centres(grey, brightest, smallest, wanted);
    Search result{{}, votes.any};
    for (std::size_t candidate = 0; votes.any && candidate < max_candidates; ++candidate) {
        long row = 0, column = 0;
        if (votes.count.maxCoeff(&row, &column) <= 0) break;
        const double x = static_cast<double>(column - votes.pad_x), y = static_cast<double>(row - votes.pad_y);
        const auto edge =
            edge_of(radial_mean(options.fringes ? as_seen : grey, x, y), noise, smallest, wanted, options.fringes);
        const long around = edge ? std::max(4L, static_cast<long>(0.5 * edge->radius)) : 6L;
        const long top = std::max(0L, row - around), left = std::max(0L, column - around);
        votes.count
            .block(top, left, std::min(2 * around + 1, votes.count.rows() - top),
                   std::min(2 * around + 1, votes.count.cols() - left))
            .setZero();
        if (!edge) continue;
        const double sign = edge->step > 0 ? 1.0 : -1.0;
        Outline outline{x, y, edge->radius};
        for (int round = 0; round < 2; ++round)
            if (const auto better = outline_through(edge_points(grey, outline, sign, options.fringes), outline))
                outline = *better;
        // the centre of pixel (0, 0) of the binned frame is between the averaged pixels
        const double factor = static_cast<double>(k), shift = 0.5 * (factor - 1);
        result.discs.push_back(
            {{factor * outline.centre_x + shift, factor * outline.centre_y + shift, factor * outline.mean_radius,
              factor * outline.stretch_cosine, factor * outline.stretch_sine},
             sign,
             std::abs(edge->step) * edge->radius});
    }
    std::stable_sort(result.discs.begin(), result.discs.end(),
                     [](const auto& a, const auto& b) { return a.strength > b.strength; });
    return result;
}

}  // namespace

CoarseSearch find_discs(const FramePixels& pixels, const ContactFrameOptions& options, int level) {
    constexpr long min_pixels = 14;
    constexpr int last_level = 2;
    const long longer = std::max(pixels.rows(), pixels.cols()), shorter = std::min(pixels.rows(), pixels.cols());
    const long finest = (longer + pixels_across - 1) / pixels_across;
    const long k = std::clamp(finest << level, 1L, std::max(1L, shorter / min_pixels));
    CoarseSearch result;
    result.binning = k;
    result.last_level = level == last_level || k < finest << level;
    auto found = search(pixels, k, options);
    result.structure = found.structure;
    constexpr double enough = 8;  // binned pixels of radius
    for (auto& disc : found.discs) {
        const double radius = disc.outline.mean_radius;
        if (k == 1 || radius > enough * static_cast<double>(k)) continue;
        // small: repeated with more pixels, around the place
        const long half = static_cast<long>(4 * radius + 4 * static_cast<double>(k)) + 8;
        const long x = std::clamp(std::lround(disc.outline.centre_x) - half, 0L, std::max(0L, pixels.cols() - 16)),
                   y = std::clamp(std::lround(disc.outline.centre_y) - half, 0L, std::max(0L, pixels.rows() - 16));
        const long width = std::min(2 * half + 1, pixels.cols() - x),
                   height = std::min(2 * half + 1, pixels.rows() - y);
        const FramePixels part = pixels.block(y, x, height, width);
        const long finer = std::max(1L, std::min(k / 2, static_cast<long>(radius / 10)));
        const auto again = search(part, finer, options);
        if (again.discs.empty()) continue;
        disc = again.discs.front();
        disc.outline.centre_x += static_cast<double>(x);
        disc.outline.centre_y += static_cast<double>(y);
    }
    result.candidates = std::move(found.discs);
    return result;
}

}  // namespace setae::imaging
