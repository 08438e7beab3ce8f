// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/rotate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/processing/interpolation.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;

/// Angles closer than this to a multiple of 90° are treated as exact [rad].
constexpr double forgiven_angle = 1e-12;

HeightMap quarter_turned(HeightMap map, long quarters) {
    quarters = ((quarters % 4) + 4) % 4;
    if (quarters == 0) return map;
    HeightMap result{{},
                     quarters == 2 ? map.size : std::array<double, 2>{map.size[1], map.size[0]},
                     map.periodic,
                     std::move(map.metadata)};
    if (quarters == 1) result.heights = map.heights.transpose().colwise().reverse();
    else if (quarters == 2) result.heights = map.heights.reverse();
    else result.heights = map.heights.transpose().rowwise().reverse();
    return result;
}

struct Sides {
    double x, y;
};

/// The largest rectangle along the axes, with the same centre, within a rotated rectangle.
Sides inscribed(const Sides& sides, double angle) {
    const double sine = std::abs(std::sin(angle)), cosine = std::abs(std::cos(angle));
    const double longer = std::max(sides.x, sides.y), shorter = std::min(sides.x, sides.y);
    if (shorter <= 2.0 * sine * cosine * longer || std::abs(sine - cosine) < 1e-10) {
        // two corners touch the longer sides, the others are on the line between them
        const double half = 0.5 * shorter;
        return sides.x > sides.y ? Sides{half / sine, half / cosine} : Sides{half / cosine, half / sine};
    }
    const double double_cosine = cosine * cosine - sine * sine;
    return {(sides.x * cosine - sides.y * sine) / double_cosine, (sides.y * cosine - sides.x * sine) / double_cosine};
}

/// First and number of n points a step apart within `side` about their middle.
struct PointRange {
    Index first, count;
};

PointRange kept(Index n, double step, double side) {
    const double middle = 0.5 * static_cast<double>(n - 1), reach = 0.5 * side / step * (1.0 + 1e-12);
    const auto first = std::max<Index>(0, static_cast<Index>(std::ceil(middle - reach))),
               last = std::min<Index>(n - 1, static_cast<Index>(std::floor(middle + reach)));
    return {first, last - first + 1};
}

template <class Interpolator>
void turn(const Interpolator& height, const HeightMap& map, double angle, const PointRange& rows,
          const PointRange& columns, Array2D& heights, parallel::Threads threads) {
    const auto pixel = map.pixel_size();
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const double middle_x = 0.5 * pixel[0] * static_cast<double>(map.heights.rows() - 1),
                 middle_y = 0.5 * pixel[1] * static_cast<double>(map.heights.cols() - 1);
    parallel::for_each_index(static_cast<std::size_t>(rows.count), threads, [&](std::size_t row) {
        const auto i = static_cast<Index>(row);
        const double x = static_cast<double>(rows.first + i) * pixel[0] - middle_x;
        for (Index j = 0; j < columns.count; ++j) {
            const double y = static_cast<double>(columns.first + j) * pixel[1] - middle_y;
            heights(i, j) = height(cosine * x + sine * y + middle_x, -sine * x + cosine * y + middle_y);
        }
    });
}

}  // namespace

HeightMap rotated(HeightMap map, const Rotate& rotation, parallel::Threads threads) {
    if (!std::isfinite(rotation.angle))
        throw InvalidArgument(fmt::format("{}: rotation by {} rad; expected a finite angle",
                                          topography::label(map.metadata), rotation.angle));
    const double quarters = rotation.angle / (0.5 * std::numbers::pi);
    if (std::abs(quarters - std::round(quarters)) < forgiven_angle)
        return quarter_turned(std::move(map), std::lround(std::fmod(std::round(quarters), 4.0)));
    map.periodic = false;  // beyond a side the map is not its rotated continuation
    const auto pixel = map.pixel_size();
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    PointRange rows{0, nx}, columns{0, ny};
    if (rotation.crop) {
        const Sides sides =
            inscribed({pixel[0] * static_cast<double>(nx - 1), pixel[1] * static_cast<double>(ny - 1)}, rotation.angle);
        rows = kept(nx, pixel[0], sides.x);
        columns = kept(ny, pixel[1], sides.y);
        if (rows.count < 2 || columns.count < 2)
            throw InvalidArgument(
                fmt::format("{}: rotating {} x {} points and cropping leaves {} x {}; expected at least 2 x 2; rotate "
                            "without crop",
                            topography::label(map.metadata), nx, ny, std::max<Index>(0, rows.count),
                            std::max<Index>(0, columns.count)));
    }
    HeightMap result{Array2D(rows.count, columns.count),
                     {pixel[0] * static_cast<double>(rows.count), pixel[1] * static_cast<double>(columns.count)},
                     false,
                     map.metadata};
    if (rotation.method == Rotation::linear)
        turn(LinearInterpolator(map), map, rotation.angle, rows, columns, result.heights, threads);
    else turn(BicubicInterpolator(map, threads), map, rotation.angle, rows, columns, result.heights, threads);
    return result;
}

Processed apply(const Rotate& step, topography::Measurement measurement, parallel::Threads threads) {
    auto* map = std::get_if<HeightMap>(&measurement);
    if (map == nullptr)
        throw InvalidArgument(fmt::format("{}: a line cannot be rotated in its plane; expected a map",
                                          topography::label(topography::metadata(measurement))));
    HeightMap result = rotated(std::move(*map), step, threads);
    StepRecord record{.step = std::string(step_name(step))};
    const double missing =
        static_cast<double>(result.heights.isNaN().count()) / static_cast<double>(result.heights.size());
    record.numbers.push_back({.quantity = "undefined_share",
                              .symbol = "n/N",
                              .estimate = {.value = missing, .standard_error = 0.0},
                              .unit = "1"});
    return {std::move(result), std::move(record)};
}

}  // namespace setae::processing
