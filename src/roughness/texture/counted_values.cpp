// SPDX-License-Identifier: GPL-3.0-or-later
#include "counted_values.hpp"

#include "setae/core/errors.hpp"

namespace setae::texture {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

void keep(CountedValues& all, double value) {
    if (value == value) all.values.push_back(value);
}

CountedValues values_of(const HeightMap& map, Counted counted) {
    CountedValues all;
    const auto nx = map.heights.rows(), ny = map.heights.cols();
    const auto [dx, dy] = map.pixel_size();
    all.values.reserve(static_cast<std::size_t>(nx * ny));
    const double* h = map.heights.data();
    const auto at = [&](Index i, Index j) { return h[(i + nx) % nx * ny + (j + ny) % ny]; };
    const Index edge = map.periodic ? 0 : 1;
    const Index after_x = counted == Counted::slope_x ? edge : 0, after_y = counted == Counted::slope_y ? edge : 0;
    if (counted == Counted::curvature) {
        for (Index i = edge; i < nx - edge; ++i)
            for (Index j = edge; j < ny - edge; ++j)
                keep(all, 0.5 * ((at(i - 1, j) - 2.0 * at(i, j) + at(i + 1, j)) / (dx * dx) +
                                 (at(i, j - 1) - 2.0 * at(i, j) + at(i, j + 1)) / (dy * dy)));
        return all;
    }
    for (Index i = 0; i < nx - after_x; ++i)
        for (Index j = 0; j < ny - after_y; ++j)
            keep(all, counted == Counted::height    ? h[i * ny + j]
                      : counted == Counted::slope_x ? (at(i + 1, j) - at(i, j)) / dx
                                                    : (at(i, j + 1) - at(i, j)) / dy);
    return all;
}

CountedValues values_of(const LineScan& scan, Counted counted) {
    CountedValues all;
    const auto n = scan.heights.size();
    const double step = scan.pixel_size();
    const auto at = [&](Index i) { return scan.heights[(i + n) % n]; };
    const Index edge = scan.periodic ? 0 : 1;
    if (counted == Counted::height)
        for (Index i = 0; i < n; ++i) keep(all, at(i));
    else if (counted == Counted::slope_x)
        for (Index i = 0; i < n - edge; ++i) keep(all, (at(i + 1) - at(i)) / step);
    else
        for (Index i = edge; i < n - edge; ++i) keep(all, (at(i - 1) - 2.0 * at(i) + at(i + 1)) / (step * step));
    return all;
}

CountedValues values_of(const Profile& profile, Counted counted) {
    topography::validate(profile);
    CountedValues all;
    const auto& x = profile.positions;
    const auto slope = [&](Index i) { return (profile.heights[i + 1] - profile.heights[i]) / (x[i + 1] - x[i]); };
    const bool curvature = counted == Counted::curvature;
    for (Index i = curvature ? 1 : 0; i + 1 < x.size(); ++i) {
        const double length = curvature ? 0.5 * (x[i + 1] - x[i - 1]) : x[i + 1] - x[i];
        all.values.push_back(curvature ? (slope(i) - slope(i - 1)) / length : slope(i));
        all.weights.push_back(length);
    }
    return all;
}

}  // namespace

CountedValues counted_values(const MeasurementView& measurement, Counted counted) {
    if (counted == Counted::slope_y && !measurement.as<HeightMap>())
        throw InvalidArgument(topography::label(measurement.metadata()) +
                              ": slopes along y are of maps, this is a line; take slope_x");
    return measurement.visit([counted](const auto& m) { return values_of(m, counted); });
}

}  // namespace setae::texture
