// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/tip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::topography {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

bool is_positive_length(double value) { return value > 0.0 && std::isfinite(value); }

void require_radius(double radius) {
    if (!is_positive_length(radius))
        throw InvalidArgument(fmt::format("tip radius {} m; expected a positive length", radius));
}

void require_domain(const SphereTip& tip) { require_radius(tip.radius); }

void require_domain(const ConeTip& tip) {
    if (!(tip.half_angle > 0.0 && tip.half_angle < 0.5 * pi))
        throw InvalidArgument(fmt::format("half angle of the tip {} rad; expected 0 < angle < π/2", tip.half_angle));
    if (tip.radius != 0.0) require_radius(tip.radius);
}

void require_domain(const ParabolicTip& tip) { require_radius(tip.radius); }

void require_domain(const ArrayTip& tip) {
    if (!is_positive_length(tip.pixel_size[0]) || !is_positive_length(tip.pixel_size[1]))
        throw InvalidArgument(fmt::format("pixels of the tip are {} m by {} m; expected positive lengths",
                                          tip.pixel_size[0], tip.pixel_size[1]));
    const bool inside = tip.centre_x >= 0 && tip.centre_y >= 0 && tip.centre_x < tip.heights.rows() &&
                        tip.centre_y < tip.heights.cols();
    if (!inside)
        throw InvalidArgument(
            fmt::format("apex of the tip at ({}, {}) of {} by {} points; expected a point of this grid", tip.centre_x,
                        tip.centre_y, tip.heights.rows(), tip.heights.cols()));
    if (!(tip.heights >= 0.0).all())
        throw InvalidArgument(
            "a height of the tip is negative or undefined; expected heights above the apex, infinite "
            "outside the tip");
    if (tip.heights(tip.centre_x, tip.centre_y) != 0.0)
        throw InvalidArgument(
            fmt::format("the height of the tip at its apex is {} m; expected 0: subtract the lowest height",
                        tip.heights(tip.centre_x, tip.centre_y)));
}

/// R − √(R² − r²) without cancellation.
double ball_height(double radius, double distance) {
    return distance * distance / (radius + std::sqrt((radius - distance) * (radius + distance)));
}

/// End of the sphere of a cone.
struct Tangent {
    double distance, height;
};

Tangent tangent(const ConeTip& tip) {
    return {tip.radius * std::cos(tip.half_angle), tip.radius * (1.0 - std::sin(tip.half_angle))};
}

double height_of(const SphereTip& tip, double distance) {
    // a grid point on the equator of the sphere belongs to it in spite of rounding
    return distance <= tip.radius * (1.0 + 1e-12) ? ball_height(tip.radius, std::min(distance, tip.radius)) : infinite;
}

double height_of(const ConeTip& tip, double distance) {
    const auto end = tangent(tip);
    if (distance <= end.distance && tip.radius > 0.0) return ball_height(tip.radius, distance);
    return end.height + (distance - end.distance) / std::tan(tip.half_angle);
}

double height_of(const ParabolicTip& tip, double distance) { return distance * distance / (2.0 * tip.radius); }

double height_of(const ArrayTip&, double) {
    throw InvalidArgument("a tip given as an array has no profile t(r); use tip_image for its heights");
}

/// √(R² − (R − t)²), the radius of a spherical cap of height t.
double cap_radius(double radius, double height) { return std::sqrt(height * (2.0 * radius - height)); }

double reach_of(const SphereTip& tip, double height) {
    return height < tip.radius ? cap_radius(tip.radius, height) : tip.radius;
}

double reach_of(const ConeTip& tip, double height) {
    const auto end = tangent(tip);
    return height <= end.height ? cap_radius(tip.radius, height)
                                : end.distance + (height - end.height) * std::tan(tip.half_angle);
}

double reach_of(const ParabolicTip& tip, double height) { return std::sqrt(2.0 * tip.radius * height); }

double reach_of(const ArrayTip& tip, double height) {
    double reach = 0.0;
    for (Index i = 0; i < tip.heights.rows(); ++i)
        for (Index j = 0; j < tip.heights.cols(); ++j)
            if (tip.heights(i, j) <= height && std::isfinite(tip.heights(i, j)))
                reach = std::max(reach, std::hypot(static_cast<double>(i - tip.centre_x) * tip.pixel_size[0],
                                                   static_cast<double>(j - tip.centre_y) * tip.pixel_size[1]));
    return reach;
}

/// Height between four grid points of a tip; x and y in its pixels from its first point.
double interpolated(const ArrayTip& tip, double x, double y) {
    // rounding of offset/pixel can shift a grid point
    const auto snapped = [](double value) {
        const double nearest = std::round(value);
        return std::abs(value - nearest) < 1e-9 ? nearest : value;
    };
    x = snapped(x);
    y = snapped(y);
    const auto i = static_cast<Index>(std::floor(x)), j = static_cast<Index>(std::floor(y));
    const double fx = x - static_cast<double>(i), fy = y - static_cast<double>(j);
    const auto height = [&](Index a, Index b) {
        return a < 0 || b < 0 || a >= tip.heights.rows() || b >= tip.heights.cols() ? infinite : tip.heights(a, b);
    };
    double sum = 0.0;
    for (const auto& [a, b, weight] : {std::tuple{i, j, (1 - fx) * (1 - fy)}, std::tuple{i + 1, j, fx * (1 - fy)},
                                       std::tuple{i, j + 1, (1 - fx) * fy}, std::tuple{i + 1, j + 1, fx * fy}})
        if (weight > 0.0) sum += weight * height(a, b);
    return sum;
}

double height_at(const Tip& tip, double x, double y) {
    if (const auto* array = std::get_if<ArrayTip>(&tip))
        return interpolated(*array, x / array->pixel_size[0] + static_cast<double>(array->centre_x),
                            y / array->pixel_size[1] + static_cast<double>(array->centre_y));
    const double distance = std::hypot(x, y);
    return std::visit([distance](const auto& shape) { return height_of(shape, distance); }, tip);
}

/// Pixels within a reach; a grid point on its end counts in spite of rounding.
Index pixels_within(double reach, double pixel) {
    return static_cast<Index>(std::floor(reach / pixel * (1.0 + 1e-12)));
}

}  // namespace

void validate(const Tip& tip) {
    std::visit([](const auto& shape) { require_domain(shape); }, tip);
}

double tip_height(const Tip& tip, double distance) {
    validate(tip);
    if (!(distance >= 0.0))
        throw InvalidArgument(fmt::format("distance {} m from the axis of the tip; expected >= 0", distance));
    return std::visit([distance](const auto& shape) { return height_of(shape, distance); }, tip);
}

double tip_reach(const Tip& tip, double height) {
    validate(tip);
    if (!(height >= 0.0)) throw InvalidArgument(fmt::format("height {} m above the apex; expected >= 0", height));
    return std::visit([height](const auto& shape) { return reach_of(shape, height); }, tip);
}

double apex_radius(const ArrayTip& tip, Index reach) {
    double fourth = 0.0, product = 0.0;
    for (Index i = -reach; i <= reach; ++i)
        for (Index j = -reach; j <= reach; ++j) {
            const Index at_x = tip.centre_x + i, at_y = tip.centre_y + j;
            if (at_x < 0 || at_x >= tip.heights.rows() || at_y < 0 || at_y >= tip.heights.cols()) continue;
            if (!std::isfinite(tip.heights(at_x, at_y))) continue;
            const double r2 = std::pow(static_cast<double>(i) * tip.pixel_size[0], 2) +
                              std::pow(static_cast<double>(j) * tip.pixel_size[1], 2);
            fourth += r2 * r2;
            product += r2 * tip.heights(at_x, at_y);
        }
    return product > 0.0 ? 0.5 * fourth / product : undefined;
}

ArrayTip tip_from_picture(const HeightMap& picture) {
    constexpr double none = std::numeric_limits<double>::infinity();
    const Array2D defined = picture.heights.isNaN().select(-none, picture.heights);
    ArrayTip tip;
    const double highest = defined.maxCoeff(&tip.centre_x, &tip.centre_y);
    if (!std::isfinite(highest)) throw UndefinedDataError(picture.metadata.file + ": no height of the tip is defined");
    tip.heights = highest - defined;
    tip.pixel_size = picture.pixel_size();
    return tip;
}

TipImage tip_image(const Tip& tip, double pixel_x, double pixel_y, double reach) {
    validate(tip);
    if (!is_positive_length(pixel_x) || !is_positive_length(pixel_y) || !(reach >= 0.0) || !std::isfinite(reach))
        throw InvalidArgument(
            fmt::format("tip on pixels of {} m by {} m up to {} m; expected positive pixels and a finite extent >= 0",
                        pixel_x, pixel_y, reach));
    TipImage image;
    image.centre_x = pixels_within(reach, pixel_x);
    image.centre_y = pixels_within(reach, pixel_y);
    image.heights.resize(2 * image.centre_x + 1, 2 * image.centre_y + 1);
    for (Index i = 0; i < image.heights.rows(); ++i)
        for (Index j = 0; j < image.heights.cols(); ++j)
            image.heights(i, j) = height_at(tip, static_cast<double>(i - image.centre_x) * pixel_x,
                                            static_cast<double>(j - image.centre_y) * pixel_y);
    return image;
}

}  // namespace setae::topography
