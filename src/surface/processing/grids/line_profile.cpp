// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/line_profile.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/processing/interpolation.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;

/// A position in pixels, exactly on a grid point if it differs only by rounding.
double in_pixels(double position, double pixel) {
    const double place = position / pixel, nearest = std::round(place);
    return std::abs(place - nearest) < 1e-9 * std::max(1.0, std::abs(nearest)) ? nearest : place;
}

/// Index of a point of the grid, wrapped for a periodic map; −1 if it is outside.
Index grid_index(double place, Index n, bool periodic) {
    if (place != std::round(place)) return -1;
    const auto index = static_cast<Index>(place);
    if (periodic) return (index % n + n) % n;
    return index >= 0 && index < n ? index : -1;
}

class Heights {
public:
    explicit Heights(const HeightMap& map) : map_(map), between_(map) {}
    [[nodiscard]] double operator()(double x, double y) const {
        const auto pixel = map_.pixel_size();
        const Index i = grid_index(in_pixels(x, pixel[0]), map_.heights.rows(), map_.periodic),
                    j = grid_index(in_pixels(y, pixel[1]), map_.heights.cols(), map_.periodic);
        return i >= 0 && j >= 0 ? map_.heights(i, j) : between_(x, y);
    }

private:
    const HeightMap& map_;
    LinearInterpolator between_;
};

/// Distance of points along a direction that steps from grid line to grid line.
double pixel_along(const HeightMap& map, double cosine, double sine) {
    const auto pixel = map.pixel_size();
    return 1.0 / std::hypot(cosine / pixel[0], sine / pixel[1]);
}

std::string lengths(const std::array<double, 2>& point) {
    return fmt::format("({}, {})", format_value(point[0], "m", 6), format_value(point[1], "m", 6));
}

/// An end of a line on the points of a map. The last pixel extends from the last point to the edge of the map; an end
/// within it is moved to the last point.
std::array<double, 2> end_on(const HeightMap& map, std::array<double, 2> end) {
    const auto pixel = map.pixel_size();
    for (std::size_t d = 0; d < 2; ++d) {
        const double rounding = 1e-9 * pixel[d];
        const bool inside = end[d] >= -rounding && end[d] <= map.size[d] + rounding;
        if (!std::isfinite(end[d]) || (!map.periodic && !inside))
            throw InvalidArgument(fmt::format("{}: an end of the line at {}; expected between (0, 0) and {}",
                                              topography::label(map.metadata), lengths(end), lengths(map.size)));
        if (!map.periodic) end[d] = std::min(end[d], map.size[d] - pixel[d]);
    }
    return end;
}

/// The line with both ends on the points of the map. @throws as line_profile.
ProfileLine line_on(const HeightMap& map, const ProfileLine& line) {
    ProfileLine placed{end_on(map, line.from), end_on(map, line.to), line.width, line.points};
    if (placed.from == placed.to)
        throw InvalidArgument(
            fmt::format("a profile from {} to the same point; expected two different points", lengths(placed.from)));
    if (!(line.width >= 0.0 && std::isfinite(line.width)))
        throw InvalidArgument(
            fmt::format("a profile with a width of {}; expected 0 or more", format_value(line.width, "m", 6)));
    if (line.points && *line.points < 2)
        throw InvalidArgument(fmt::format("a profile of {} points; expected at least two", *line.points));
    return placed;
}

}  // namespace

LineProfile line_profile(const HeightMap& map, const ProfileLine& wanted) {
    const auto line = line_on(map, wanted);
    const double along_x = line.to[0] - line.from[0], along_y = line.to[1] - line.from[1],
                 length = std::hypot(along_x, along_y);
    const double cosine = along_x / length, sine = along_y / length;
    const Index points = line.points.value_or(
        std::max<Index>(2, static_cast<Index>(std::lround(length / pixel_along(map, cosine, sine))) + 1));
    const double across = pixel_along(map, -sine, cosine);
    LineProfile result;
    result.tracks = std::max<Index>(1, static_cast<Index>(std::lround(line.width / across)));
    const double step = length / static_cast<double>(points - 1);
    result.scan = {Array1D(points), step * static_cast<double>(points), false, map.metadata};
    result.x.resize(points);
    result.y.resize(points);
    const Heights height(map);
    for (Index p = 0; p < points; ++p) {
        const double t = static_cast<double>(p) / static_cast<double>(points - 1);
        result.x[p] = line.from[0] + t * along_x;
        result.y[p] = line.from[1] + t * along_y;
        double sum = 0.0;
        Index defined = 0;
        for (Index track = 0; track < result.tracks; ++track) {
            const double offset = (static_cast<double>(track) - 0.5 * static_cast<double>(result.tracks - 1)) * across;
            const double h = height(result.x[p] - sine * offset, result.y[p] + cosine * offset);
            if (std::isnan(h)) continue;
            sum += h;
            ++defined;
        }
        result.scan.heights[p] = defined > 0 ? sum / static_cast<double>(defined) : undefined;
    }
    return result;
}

}  // namespace setae::processing
