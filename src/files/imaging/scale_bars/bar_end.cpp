// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "drawn_bars.hpp"

namespace setae::imaging {
namespace {

constexpr double step = 0.05;                                    // px
constexpr double farthest = 1.5;                                 // px
constexpr std::array<double, 5> blurs{0.0, 0.4, 0.7, 1.0, 1.4};  // px
const double whole_pixel_prior = std::log(50.0);

/// Share of a pixel, centred at x, to the left of a blurred edge.
double coverage(double x, double edge, double blur) {
    if (blur <= 0) return std::clamp(edge - x + 0.5, 0.0, 1.0);
    // the integral of the normal distribution over the pixel, by the primitive of its distribution function
    const auto primitive = [blur](double t) {
        const double z = t / blur;
        return blur * (z * 0.5 * std::erfc(-z / std::sqrt(2.0)) + std::exp(-0.5 * z * z) / std::sqrt(2.0 * CV_PI));
    };
    return primitive(edge - x + 0.5) - primitive(edge - x - 0.5);
}

struct ColumnMoments {
    double mean = 0, variance = 0;
};

}  // namespace

BarEnd bar_end(const cv::Mat1f& rows, int inside, double level, double deviation,
               const std::optional<double>& outline) {
    const int columns = rows.cols;
    std::vector<ColumnMoments> moments(static_cast<std::size_t>(columns));
    for (int x = 0; x < columns; ++x) {
        auto& column = moments[static_cast<std::size_t>(x)];
        for (int y = 0; y < rows.rows; ++y) column.mean += static_cast<double>(rows(y, x)) / rows.rows;
        for (int y = 0; y < rows.rows; ++y)
            column.variance += std::pow(static_cast<double>(rows(y, x)) - column.mean, 2) / rows.rows;
    }
    // surroundings of the bar: pixels beyond the blur of this edge, if there are any
    const int first_outside = std::min(inside + 2, columns - 1);
    double outside = 0, outside_square = 0;
    for (int x = first_outside; x < columns; ++x) {
        const auto& column = moments[static_cast<std::size_t>(x)];
        outside += column.mean / (columns - first_outside);
        outside_square += (column.variance + column.mean * column.mean) / (columns - first_outside);
    }
    if (outline) {
        outside = *outline;
        outside_square = outside * outside;
    }
    const double contrast = std::abs(outside - level);
    const double floor = std::max(deviation, 0.01 * contrast);
    const double texture = std::max(outside_square - outside * outside, 0.0);
    const double independent = std::max(1.0, rows.rows / 2.0);  // rows of a texture are correlated with their
                                                                // neighbours

    struct Trial {
        double place = 0, logarithm = 0;
        bool whole = false;
    };
    std::vector<Trial> trials;
    double best = -1e300;
    for (const double blur : blurs)
        for (int k = 0; k <= static_cast<int>(std::lround(2 * farthest / step)); ++k) {
            const double place = -farthest + k * step;
            double sum = 0;
            for (int x = 0; x < columns; ++x) {
                const double share = coverage(x - inside + 0.5, place, blur);  // the last whole pixel ends at 0
                const double expected = share * level + (1 - share) * outside;
                const double variance = floor * floor + (1 - share) * (1 - share) * texture;
                const auto& column = moments[static_cast<std::size_t>(x)];
                sum -= 0.5 * independent *
                       ((std::pow(column.mean - expected, 2) + column.variance) / variance + std::log(variance));
            }
            const bool whole = blur <= 0 && std::abs(place - std::round(place)) < 0.1 * step;
            if (whole) sum += whole_pixel_prior;
            trials.push_back({whole ? std::round(place) : place, sum, whole});
            best = std::max(best, sum);
        }
    double weight = 0, mean = 0, square = 0, whole_weight = 0, best_whole = -1e300, whole_place = 0;
    for (const auto& trial : trials) {
        const double share = std::exp(trial.logarithm - best);
        weight += share;
        mean += share * trial.place;
        square += share * trial.place * trial.place;
        if (!trial.whole) continue;
        whole_weight += share;
        if (trial.logarithm > best_whole) {
            best_whole = trial.logarithm;
            whole_place = trial.place;
        }
    }
    if (whole_weight > 0.5 * weight) return {whole_place, 0};
    mean /= weight;
    return {mean, std::sqrt(std::max(square / weight - mean * mean, step * step / 12))};
}

}  // namespace setae::imaging
