// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/combine_maps.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "grids/registration.hpp"
#include "setae/core/errors.hpp"
#include "setae/processing/interpolation.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;
using topography::LineScan;

constexpr double same_size = 1e-10;

bool alike(double a, double b) { return std::abs(a - b) <= same_size * std::max(std::abs(a), std::abs(b)); }

[[noreturn]] void refuse(std::string_view step, const topography::Metadata& first, const topography::Metadata& second,
                         std::string_view why) {
    throw InvalidArgument(
        fmt::format("{} and {}: {} {}", topography::label(first), topography::label(second), step, why));
}

HeightMap combined(HeightMap map, const HeightMap& other, double factor, const Shift& shift,
                   parallel::Threads threads) {
    const bool same_grid = map.shape() == other.shape() && alike(map.size[0], other.size[0]) &&
                           alike(map.size[1], other.size[1]) && shift.x == 0.0 && shift.y == 0.0;
    map.periodic =
        map.periodic && other.periodic && alike(map.size[0], other.size[0]) && alike(map.size[1], other.size[1]);
    const auto pixel = map.pixel_size();
    const LinearInterpolator height(other);
    parallel::for_each_index(static_cast<std::size_t>(map.heights.rows()), threads, [&](std::size_t row) {
        const auto i = static_cast<Index>(row);
        if (same_grid) {
            map.heights.row(i) += factor * other.heights.row(i);
            return;
        }
        for (Index j = 0; j < map.heights.cols(); ++j)
            map.heights(i, j) += factor * height(static_cast<double>(i) * pixel[0] + shift.x,
                                                 static_cast<double>(j) * pixel[1] + shift.y);
    });
    return map;
}

LineScan combined(LineScan scan, const LineScan& other, double factor) {
    const bool same_grid = scan.heights.size() == other.heights.size() && alike(scan.size, other.size);
    scan.periodic = scan.periodic && other.periodic && alike(scan.size, other.size);
    const LinearLineInterpolator height(other);
    const double pixel = scan.pixel_size();
    for (Index i = 0; i < scan.heights.size(); ++i)
        scan.heights[i] += factor * (same_grid ? other.heights[i] : height(static_cast<double>(i) * pixel));
    return scan;
}

Processed combined(std::string_view step, topography::Measurement measurement, const topography::Measurement& other,
                   double factor, bool align, parallel::Threads threads) {
    const topography::Metadata first = topography::metadata(measurement), &second = topography::metadata(other);
    if (std::holds_alternative<topography::Profile>(measurement) || std::holds_alternative<topography::Profile>(other))
        refuse(step, first, second,
               "needs equally spaced points, and one measurement is a polyline; resample it first (step "
               "resample)");
    if (measurement.index() != other.index())
        refuse(step, first, second, "needs two maps or two lines, and one measurement is a line, the other a map");
    StepRecord record{.step = std::string(step)};
    topography::Measurement result;
    if (auto* map = std::get_if<HeightMap>(&measurement)) {
        const auto& other_map = std::get<HeightMap>(other);
        const Shift shift = align ? shift_between(*map, other_map, threads) : Shift{};
        if (align) {
            record.numbers.push_back(
                {.quantity = "shift_x", .symbol = "d_x", .estimate = {.value = shift.x}, .unit = "m"});
            record.numbers.push_back(
                {.quantity = "shift_y", .symbol = "d_y", .estimate = {.value = shift.y}, .unit = "m"});
            record.numbers.push_back(
                {.quantity = "agreement", .symbol = "r", .estimate = {.value = shift.agreement}, .unit = "1"});
        }
        result = combined(std::move(*map), other_map, factor, shift, threads);
    } else {
        if (align) refuse(step, first, second, "cannot align lines; expected align = false");
        result = combined(std::get<LineScan>(std::move(measurement)), std::get<LineScan>(other), factor);
    }
    const bool empty = std::holds_alternative<HeightMap>(result) ? std::get<HeightMap>(result).heights.isNaN().all()
                                                                 : std::get<LineScan>(result).heights.isNaN().all();
    if (empty)
        refuse(step, first, second,
               "finds no point where both measurements are defined; check their sizes and undefined heights");
    return {std::move(result), std::move(record)};
}

}  // namespace

Processed apply(const AddMap& step, topography::Measurement measurement, const topography::Measurement& other,
                parallel::Threads threads) {
    return combined(step_name(step), std::move(measurement), other, 1.0, step.align, threads);
}

Processed apply(const SubtractMap& step, topography::Measurement measurement, const topography::Measurement& other,
                parallel::Threads threads) {
    return combined(step_name(step), std::move(measurement), other, -1.0, step.align, threads);
}

}  // namespace setae::processing
