// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace setae::imaging {
namespace {

constexpr double narrowest_edge = 0.29, widest_edge = 4.0;  // px; the area of a pixel causes 0.29
constexpr double narrowest_fringe = 0.8, widest_fringe = 10.0;
constexpr double min_fringe_gain = 30.0;  // of χ² for a significant fringe
constexpr double farthest = 3.0;          // px between the start of a fit and the edge
constexpr double min_scatter = 1e-3;      // of the range of a profile: pixels are squares
constexpr double min_fringe = 0.05;       // of the step
constexpr double min_spread = 1.7;        // of the fringe over the width of the step
constexpr double bin = 0.25;              // px
constexpr int max_steps = 60;

using Parameters = Eigen::Matrix<double, 6, 1>;  // level, step, place, ln width, fringe, ln fringe width

EdgeShape shape_of(const Parameters& p) {
    EdgeShape shape;
    shape.level = p[0];
    shape.step = p[1];
    shape.place = p[2];
    shape.fringe = p[4];
    shape.width = std::exp(p[3]);
    shape.fringe_width = std::exp(p[5]);
    return shape;
}

Parameters parameters_of(const EdgeShape& s) {
    Parameters p;
    p << s.level, s.step, s.place, std::log(s.width), s.fringe, std::log(s.fringe_width);
    return p;
}

struct Fit {
    Parameters parameters;
    double squares = 0;
};

/// Squares weighted by count over the noise of a pixel.
double squares_of(const EdgeProfile& profile, const std::vector<double>& weights, const Parameters& p) {
    const auto shape = shape_of(p);
    double sum = 0;
    for (std::size_t i = 0; i < profile.mean.size(); ++i) {
        const double residual = profile.mean[i] - shape.level - shape.value(profile.distance[i] - shape.place);
        sum += weights[i] * residual * residual;
    }
    return sum;
}

/// Levenberg's steps over the first `free` parameters.
Fit least_squares(const EdgeProfile& profile, const std::vector<double>& weights, Parameters p, int free) {
    Fit fit{p, squares_of(profile, weights, p)};
    double damping = 1e-3;
    using Normal = Eigen::Matrix<double, 6, 6>;
    Normal normal = Normal::Identity();
    for (int step = 0; step < max_steps; ++step) {
        normal = Normal::Zero();
        Parameters right = Parameters::Zero();
        const auto shape = shape_of(fit.parameters);
        for (std::size_t i = 0; i < profile.mean.size(); ++i) {
            if (weights[i] == 0) continue;
            const double t = profile.distance[i] - shape.place, u = t / shape.width, v = t / shape.fringe_width;
            const double bell = std::exp(-0.5 * u * u) * std::numbers::inv_sqrtpi / std::numbers::sqrt2,
                         wave = std::exp(0.5 - 0.5 * v * v);
            Parameters derivative;
            derivative << 1, 0.5 * std::erf(u / std::numbers::sqrt2), -shape.slope(t), -shape.step * bell * u, v * wave,
                shape.fringe * wave * v * (v * v - 1);
            const double residual = profile.mean[i] - shape.level - shape.value(t);
            normal.noalias() += weights[i] * derivative * derivative.transpose();
            right += weights[i] * residual * derivative;
        }
        for (int i = free; i < 6; ++i) normal.row(i).setZero(), normal.col(i).setZero(), normal(i, i) = 1, right[i] = 0;
        bool better = false;
        for (int attempt = 0; attempt < 8 && !better; ++attempt) {
            Normal damped = normal;
            damped.diagonal() *= 1 + damping;
            damped.diagonal().array() += 1e-12 * normal.trace();
            Parameters next = fit.parameters + damped.ldlt().solve(right);
            next[3] = std::clamp(next[3], std::log(narrowest_edge), std::log(widest_edge));
            next[2] = std::clamp(next[2], -profile.reach, profile.reach);
            next[5] = std::clamp(next[5], std::log(narrowest_fringe), std::log(widest_fringe));
            const double squares = squares_of(profile, weights, next);
            if (squares < fit.squares) {
                const bool rests = fit.squares - squares < 1e-9 * fit.squares;
                fit.parameters = next;
                fit.squares = squares;
                damping = std::max(1e-9, 0.2 * damping);
                if (rests) step = max_steps;
                better = true;
            } else {
                damping *= 5;
            }
        }
        if (!better) break;
    }
    return fit;
}

std::vector<double> weights_of(const EdgeProfile& profile) {
    double variance = 0, count = 0;
    for (std::size_t i = 0; i < profile.mean.size(); ++i) {
        variance += profile.count[i] * profile.variance[i];
        count += profile.count[i];
    }
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < profile.mean.size(); ++i)
        if (profile.count[i] > 0) {
            low = std::min(low, profile.mean[i]);
            high = std::max(high, profile.mean[i]);
        }
    const double typical =
        std::max(variance / std::max(1.0, count), min_scatter * min_scatter * (high - low) * (high - low));
    std::vector<double> weights;
    for (std::size_t i = 0; i < profile.mean.size(); ++i)
        weights.push_back(profile.count[i] / std::max(0.25 * typical, profile.variance[i]));
    return weights;
}

/// Whether a fit still describes the initial edge: near it, of the same sign, steepest at its place.
bool same_edge(const EdgeShape& shape, const EdgeShape& start) {
    if (std::abs(shape.place - start.place) > farthest || shape.slope(0) * start.slope(0) <= 0) return false;
    const double steepest = std::abs(shape.slope(0));
    for (double t = -2 * shape.fringe_width; t <= 2 * shape.fringe_width; t += 0.1 * shape.fringe_width)
        if (std::abs(shape.slope(t)) > 1.001 * steepest) return false;
    return true;
}

/// A narrow fringe is only a step of another width: the derivative of a step by its width has this shape.
bool is_fringe(const EdgeShape& shape) {
    return shape.fringe_rules() || (std::abs(shape.fringe) > min_fringe * std::abs(shape.step) &&
                                    shape.fringe_width > min_spread * shape.width);
}

EdgeShape best_shape(const EdgeProfile& profile, const EdgeShape& start) {
    const auto weights = weights_of(profile);
    EdgeShape bare = start;
    bare.step = start.slope(0) * start.width * std::sqrt(2 * std::numbers::pi);
    bare.fringe = 0;
    bare.fringe_width = std::max(2.0, 2 * start.width);
    auto step = least_squares(profile, weights, parameters_of(bare), 4);
    if (!same_edge(shape_of(step.parameters), start))
        step = {parameters_of(bare), squares_of(profile, weights, parameters_of(bare))};
    Fit best = step;
    for (const double width : {2.0, 4.0}) {
        Parameters from = step.parameters;
        from[5] = std::log(width);
        from[4] = 0.01 * std::abs(from[1]);
        auto with_fringe = least_squares(profile, weights, from, 6);
        if (with_fringe.squares < best.squares - min_fringe_gain && is_fringe(shape_of(with_fringe.parameters)) &&
            same_edge(shape_of(with_fringe.parameters), start))
            best = with_fringe;
    }
    auto shape = shape_of(best.parameters);
    if (shape.fringe_rules())
        shape.width = std::clamp(shape.fringe_width / std::numbers::sqrt3, narrowest_edge, widest_edge);
    return shape;
}

}  // namespace

double EdgeShape::value(double distance) const {
    const double v = distance / fringe_width;
    return 0.5 * step * std::erf(distance / (width * std::numbers::sqrt2)) +
           (fringe == 0 ? 0.0 : fringe * v * std::exp(0.5 - 0.5 * v * v));
}

double EdgeShape::slope(double distance) const {
    const double u = distance / width, v = distance / fringe_width;
    return step / width * std::exp(-0.5 * u * u) * (std::numbers::inv_sqrtpi / std::numbers::sqrt2) +
           (fringe == 0 ? 0.0 : fringe / fringe_width * (1 - v * v) * std::exp(0.5 - 0.5 * v * v));
}

bool EdgeShape::fringe_rules() const {
    const double of_step = std::abs(step) / width * (std::numbers::inv_sqrtpi / std::numbers::sqrt2),
                 of_fringe = std::abs(fringe) / fringe_width * std::exp(0.5);
    return of_step < 0.5 * of_fringe;
}

EdgeProfile edge_profile(const std::vector<BandPixel>& pixels, double reach) {
    EdgeProfile profile{reach};
    const auto bins = static_cast<std::size_t>(std::ceil(2 * reach / bin));
    for (auto* values : {&profile.count, &profile.distance, &profile.mean, &profile.variance})
        values->assign(bins, 0.0);
    const auto bin_of = [&](const BandPixel& p) {
        return std::min(bins - 1, static_cast<std::size_t>(std::max(0.0, (p.distance + reach) / bin)));
    };
    for (const auto& p : pixels) {
        const auto i = bin_of(p);
        profile.count[i] += 1;
        profile.distance[i] += p.distance;
        profile.mean[i] += p.value;
    }
    for (std::size_t i = 0; i < bins; ++i)
        if (profile.count[i] > 0) {
            profile.distance[i] /= profile.count[i];
            profile.mean[i] /= profile.count[i];
        }
    for (const auto& p : pixels) {
        const auto i = bin_of(p);
        profile.variance[i] += (p.value - profile.mean[i]) * (p.value - profile.mean[i]) / profile.count[i];
    }
    return profile;
}

EdgeShape fitted_shape(const EdgeProfile& profile) {
    const auto weights = weights_of(profile);
    const auto n = static_cast<long>(profile.mean.size());
    constexpr long reach = 12;  // bins on either side whose means give a slope: 3 px
    const auto mean_over = [&](long from, long to) {
        double sum = 0, weight = 0;
        for (long i = std::max(0L, from); i < std::min(n, to); ++i) {
            sum += weights[static_cast<std::size_t>(i)] * profile.mean[static_cast<std::size_t>(i)];
            weight += weights[static_cast<std::size_t>(i)];
        }
        return weight > 0 ? sum / weight : 0.0;
    };
    double steepest_up = 0, steepest_down = 0;
    long up = n / 2, down = n / 2;
    for (long i = reach / 2; i <= n - reach / 2; ++i) {
        const double rise = mean_over(i, i + reach) - mean_over(i - reach, i);
        if (rise > steepest_up) {
            steepest_up = rise;
            up = i;
        }
        if (-rise > steepest_down) {
            steepest_down = -rise;
            down = i;
        }
    }
    const double ends = mean_over(n - n / 4, n) - mean_over(0, n / 4);
    const bool differ = std::abs(ends) > 0.25 * (steepest_up + steepest_down);
    const bool upwards = differ ? ends > 0 : steepest_up > steepest_down;
    EdgeShape start;
    start.level = mean_over(0, n);
    start.step = upwards ? steepest_up : -steepest_down;
    start.place = -profile.reach + bin * static_cast<double>(upwards ? up : down);
    start.width = 1.2;
    return best_shape(profile, start);
}

EdgeShape fitted_shape(const EdgeProfile& profile, const EdgeShape& start) { return best_shape(profile, start); }

}  // namespace setae::imaging
