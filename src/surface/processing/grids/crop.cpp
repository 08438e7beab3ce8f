// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/crop.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pipeline/step_record.hpp"
#include "setae/core/errors.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

/// Points first … first + count − 1 of a direction.
struct Window {
    Index first = 0, count = 0;
};

/// Request of a step for one direction.
struct Request {
    const char* direction;
    std::optional<double> from, to;
    Index cut_first, cut_last;

    [[nodiscard]] bool given() const { return from || to || cut_first != 0 || cut_last != 0; }
};

Request request_x(const Crop& step) { return {"x", step.x_from, step.x_to, step.cut_left, step.cut_right}; }
Request request_y(const Crop& step) { return {"y", step.y_from, step.y_to, step.cut_first, step.cut_last}; }

void require_consistent(const Request& request) {
    if (request.cut_first < 0 || request.cut_last < 0)
        throw InvalidArgument(fmt::format("crop along {} by {} and {} points; expected numbers >= 0", request.direction,
                                          request.cut_first, request.cut_last));
    if ((request.from || request.to) && (request.cut_first != 0 || request.cut_last != 0))
        throw InvalidArgument(fmt::format(
            "crop along {} has both a window in metres and points to cut off; give one of them", request.direction));
}

Window window_of(const Request& request, Index points, double pixel_size, const topography::Metadata& metadata) {
    require_consistent(request);
    constexpr double rounding = 1e-9;  // of a pixel
    Index first = request.cut_first, last = points - 1 - request.cut_last;
    if (request.from)
        first = std::max<Index>(first, static_cast<Index>(std::ceil(std::clamp(*request.from / pixel_size - rounding,
                                                                               -1.0, static_cast<double>(points)))));
    if (request.to)
        last = std::min<Index>(last, static_cast<Index>(std::floor(std::clamp(*request.to / pixel_size + rounding, -1.0,
                                                                              static_cast<double>(points)))));
    if (last - first < 1)
        throw InvalidArgument(
            fmt::format("{}: crop along {} leaves {} of {} points; expected at least 2: the measurement is {} m long",
                        topography::label(metadata), request.direction, std::max<Index>(0, last - first + 1), points,
                        static_cast<double>(points) * pixel_size));
    return {first, last - first + 1};
}

void refuse_y(const Crop& step, const topography::Metadata& metadata) {
    if (request_y(step).given())
        throw InvalidArgument(
            fmt::format("{}: crop along y of a line; a line has only x", topography::label(metadata)));
}

struct Cropper {
    const Crop& step;
    StepRecord& record;

    void operator()(HeightMap& map) const {
        const auto [nx, ny] = map.shape();
        const auto pixel = map.pixel_size();
        const auto x = window_of(request_x(step), nx, pixel[0], map.metadata),
                   y = window_of(request_y(step), ny, pixel[1], map.metadata);
        record.numbers = {recorded("x_offset", "", static_cast<double>(x.first) * pixel[0], "m"),
                          recorded("y_offset", "", static_cast<double>(y.first) * pixel[1], "m"),
                          recorded_count("points_along_x", x.count), recorded_count("points_along_y", y.count)};
        if (x.count == nx && y.count == ny) return;
        map.heights = Array2D(map.heights.block(x.first, y.first, x.count, y.count));
        map.size = {static_cast<double>(x.count) * pixel[0], static_cast<double>(y.count) * pixel[1]};
        map.periodic = false;
    }

    void operator()(LineScan& scan) const {
        refuse_y(step, scan.metadata);
        const double pixel = scan.pixel_size();
        const auto x = window_of(request_x(step), scan.heights.size(), pixel, scan.metadata);
        record.numbers = {recorded("x_offset", "", static_cast<double>(x.first) * pixel, "m"),
                          recorded_count("points_along_x", x.count)};
        if (x.count == scan.heights.size()) return;
        scan.heights = Array1D(scan.heights.segment(x.first, x.count));
        scan.size = static_cast<double>(x.count) * pixel;
        scan.periodic = false;
    }

    void operator()(Profile& profile) const {
        refuse_y(step, profile.metadata);
        const auto request = request_x(step);
        require_consistent(request);
        const Index n = profile.positions.size();
        Index first = std::min(request.cut_first, n), last = n - 1 - request.cut_last;
        while (request.from && first < n && profile.positions[first] < *request.from) ++first;
        while (request.to && last >= 0 && profile.positions[last] > *request.to) --last;
        if (last - first < 1)
            throw InvalidArgument(
                fmt::format("{}: crop leaves {} of {} points; expected at least 2: x runs from {} to {} m",
                            topography::label(profile.metadata), std::max<Index>(0, last - first + 1), n,
                            profile.positions[0], profile.positions[n - 1]));
        const Index count = last - first + 1;
        record.numbers = {recorded("x_offset", "", profile.positions[first] - profile.positions[0], "m"),
                          recorded_count("points_along_x", count)};
        profile.positions = Array1D(profile.positions.segment(first, count));
        profile.heights = Array1D(profile.heights.segment(first, count));
        if (profile.standard_error.size() > 0)
            profile.standard_error = Array1D(profile.standard_error.segment(first, count));
    }
};

}  // namespace

Processed apply(const Crop& step, topography::Measurement measurement, parallel::Threads) {
    StepRecord record{std::string(step_name(step)), {}, {}};
    std::visit(Cropper{step, record}, measurement);
    return {std::move(measurement), std::move(record)};
}

}  // namespace setae::processing
