// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/LU>

#include "angular_spectrum.hpp"
#include "autocorrelation_of_products.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"
#include "setae/texture/height_parameters.hpp"

namespace setae::texture {
namespace {

/// A point of the rim around lag 0.
struct RimPoint {
    double angle;
    double distance;  ///< [m]
};

struct Rim {
    std::vector<RimPoint> points;  ///< by increasing angle
    bool closed = true;            ///< no part of it is beyond the largest lags
};

/// Position where the cubic through four equally spaced values crosses `level` between the second (above it) and the
/// third (not above): 0 … 1.
double passage(double before, double at_0, double at_1, double after, double level) {
    const bool cubic = !std::isnan(before) && !std::isnan(after);
    const auto value = [&](double t) {
        if (!cubic) return at_0 + t * (at_1 - at_0);
        return (t - 1.0) * (t - 2.0) * (-t * before + 3.0 * (t + 1.0) * at_0) / 6.0 +
               (t + 1.0) * t * (-3.0 * (t - 2.0) * at_1 + (t - 1.0) * after) / 6.0;
    };
    return numerics::bisected([&](double t) { return value(t) > level; }, 0.0, 1.0, 50).first;
}

/// The rim of the part around lag 0 where f > level, found by filling that part from the middle.
Rim rim_of(AutocorrelationOfProducts& f, double level, std::array<double, 2> pixel) {
    const auto reach_x = f.reach_x(), reach_y = f.reach_y();
    const auto width = 2 * reach_y + 1;
    std::vector<bool> filled(static_cast<std::size_t>((2 * reach_x + 1) * width), false);
    const auto place = [&](Index i, Index j) { return static_cast<std::size_t>((i + reach_x) * width + j + reach_y); };
    const auto inside_map = [&](Index i, Index j) { return std::abs(i) <= reach_x && std::abs(j) <= reach_y; };
    const auto at = [&](Index i, Index j) { return inside_map(i, j) ? f(i, j) : undefined; };
    Rim rim;
    std::vector<std::pair<Index, Index>> waiting{{0, 0}};
    filled[place(0, 0)] = true;
    while (!waiting.empty()) {
        const auto [i, j] = waiting.back();
        waiting.pop_back();
        for (const auto& [di, dj] : {std::pair<Index, Index>{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const double next = at(i + di, j + dj);
            if (std::isnan(next)) {
                rim.closed = false;
            } else if (next > level) {
                if (!filled[place(i + di, j + dj)]) {
                    filled[place(i + di, j + dj)] = true;
                    waiting.emplace_back(i + di, j + dj);
                }
            } else {
                const double t = passage(at(i - di, j - dj), f(i, j), next, at(i + 2 * di, j + 2 * dj), level);
                const double x = pixel[0] * (static_cast<double>(i) + t * static_cast<double>(di));
                const double y = pixel[1] * (static_cast<double>(j) + t * static_cast<double>(dj));
                rim.points.push_back({std::atan2(y, x), std::hypot(x, y)});
            }
        }
    }
    std::sort(rim.points.begin(), rim.points.end(), [](const RimPoint& a, const RimPoint& b) {
        return std::pair(a.angle, a.distance) < std::pair(b.angle, b.distance);
    });
    return rim;
}

/// The distance at an extreme point of the rim, improved by a parabola over the adjacent angles if it fits to 5 % of a
/// pixel.
double refined(const Rim& rim, const RimPoint& extreme, double pixel) {
    const double reach = std::min(0.5, 1.75 * pixel / extreme.distance);
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    std::vector<std::pair<double, double>> near;
    for (const auto& point : rim.points) {
        const double t = std::remainder(point.angle - extreme.angle, 2.0 * pi) / reach;
        if (std::abs(t) > 1.0) continue;
        const Eigen::Vector3d row(1.0, t, t * t);
        normal += row * row.transpose();
        right += row * point.distance;
        near.emplace_back(t, point.distance);
    }
    if (near.size() < 5) return extreme.distance;
    const Eigen::Vector3d fit = normal.inverse() * right;
    double worst = 0.0;
    for (const auto& [t, distance] : near)
        worst = std::max(worst, std::abs(fit[0] + fit[1] * t + fit[2] * t * t - distance));
    const double top = fit[2] != 0.0 ? -0.5 * fit[1] / fit[2] : 0.0;
    if (!(worst < 0.05 * pixel) || !(std::abs(top) <= 1.0)) return extreme.distance;
    return fit[0] + 0.5 * fit[1] * top;
}

/// ∫ f^k over a disc of lags, k = 2, 3, 4.
std::array<double, 3> correlation_areas(AutocorrelationOfProducts& f, double radius, std::array<double, 2> pixel) {
    std::array<double, 3> sums{};
    const auto reach_x = std::min(f.reach_x(), static_cast<Index>(radius / pixel[0])),
               reach_y = std::min(f.reach_y(), static_cast<Index>(radius / pixel[1]));
    for (Index i = -reach_x; i <= reach_x; ++i)
        for (Index j = -reach_y; j <= reach_y; ++j) {
            const double value = f(i, j);
            if (std::hypot(static_cast<double>(i) * pixel[0], static_cast<double>(j) * pixel[1]) > radius ||
                std::isnan(value))
                continue;
            double power = value * value;
            for (auto& sum : sums) {
                sum += power;
                power *= value;
            }
        }
    for (auto& sum : sums) sum *= pixel[0] * pixel[1];
    return sums;
}

void require_threshold(double threshold) {
    if (!(threshold > 0.0 && threshold < 1.0))
        throw InvalidArgument(fmt::format("threshold of the autocorrelation is {}; expected 0 < s < 1", threshold));
}

Alert alert(const topography::HeightMap& map, const char* code, std::string message, const char* action) {
    return {code, topography::label(map.metadata), std::move(message), action};
}

}  // namespace

double autocorrelation_length(const topography::LineScan& scan, const SpatialOptions& options) {
    require_threshold(options.threshold);
    const topography::HeightMap column{scan.heights, {scan.size, 1.0}, scan.periodic, scan.metadata};
    AutocorrelationOfProducts f(column, height_parameters(scan).mean, {1});
    for (Index k = 1; k <= f.reach_x(); ++k) {
        if (!(f(k, 0) <= options.threshold)) continue;
        const double after = k < f.reach_x() ? f(k + 1, 0) : undefined;
        const double before = k > 1 || f.reach_x() > 1 ? f(k - 2, 0) : undefined;
        return scan.pixel_size() *
               (static_cast<double>(k - 1) + passage(before, f(k - 1, 0), f(k, 0), after, options.threshold));
    }
    return undefined;
}

SpatialParameters spatial_parameters(const topography::HeightMap& map, const SpatialOptions& options,
                                     parallel::Threads threads) {
    require_threshold(options.threshold);
    const double mean = height_parameters(map, threads).mean;
    AutocorrelationOfProducts products(map, mean, threads);
    const auto rim = rim_of(products, options.threshold, map.pixel_size());
    const auto direction = strongest_direction(map, mean, threads);
    SpatialParameters result;
    result.Sal = result.Str = result.longest = undefined;
    result.correlation_areas.fill(undefined);
    if (!rim.points.empty()) {
        const auto by_distance = [](const RimPoint& a, const RimPoint& b) { return a.distance < b.distance; };
        const auto [nearest, farthest] = std::minmax_element(rim.points.begin(), rim.points.end(), by_distance);
        const double pixel = std::max(map.pixel_size()[0], map.pixel_size()[1]);
        result.Sal = refined(rim, *nearest, pixel);
        result.longest = refined(rim, *farthest, pixel);
        if (rim.closed) {
            result.Str = std::min(1.0, result.Sal / result.longest);
            result.correlation_areas = correlation_areas(products, 2.0 * result.longest, map.pixel_size());
        }
    } else {
        result.alerts.push_back(
            alert(map, "SAL_UNDEFINED",
                  fmt::format("the autocorrelation stays above {} at every lag of the map", options.threshold),
                  "measure a larger map, or remove long waves with an L-filter"));
    }
    if (!rim.closed)
        result.alerts.push_back(alert(
            map, "STR_UNDEFINED",
            fmt::format("the autocorrelation stays above {} along one direction up to the largest lags, so that Str is "
                        "at most {:.3g}",
                        options.threshold, result.Sal / result.longest),
            "measure a larger map; straight lines without end have Str near 0"));
    result.directionality = direction.directionality;
    result.Std = direction.angle < 0.5 * pi ? direction.angle + 0.5 * pi : direction.angle - 0.5 * pi;
    if (result.Str > 0.5)
        result.alerts.push_back(
            alert(map, "STD_WITHOUT_DIRECTION",
                  fmt::format("Str is {:.2f}: no direction of the texture is distinct, and Std has little meaning",
                              result.Str),
                  "use Std only where Str is below 0.5"));
    return result;
}

}  // namespace setae::texture
