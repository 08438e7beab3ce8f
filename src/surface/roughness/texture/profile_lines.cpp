// SPDX-License-Identifier: GPL-3.0-or-later
#include "profile_lines.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "profile_parts.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/texture/profile_parameters.hpp"

namespace setae::texture {

using topography::LineScan;
using topography::Profile;

void require_line(const MeasurementView& line) {
    if (line.as<topography::HeightMap>())
        throw InvalidArgument(topography::label(line.metadata()) +
                              ": profile parameters need a line, and this is a map; use its scan lines one by one");
}

Points points_of(const MeasurementView& line) {
    require_line(line);
    Points points;
    if (const auto* scan = line.as<LineScan>()) {
        const auto n = scan->heights.size();
        points = {Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)) * scan->pixel_size(), scan->heights};
    } else {
        const auto& profile = *line.as<Profile>();
        topography::validate(profile);
        points = {profile.positions, profile.heights};
    }
    if (points.heights.isNaN().any())
        throw UndefinedDataError(topography::label(line.metadata()) +
                                 ": elements of a profile need all heights; fill undefined heights first");
    return points;
}

namespace {

/// The part of a polyline between two positions, divided between points.
Profile cut(const Profile& profile, double begin, double end) {
    const auto& x = profile.positions;
    const auto height_at = [&](double position) {
        const auto i = std::clamp<Index>(std::upper_bound(x.begin(), x.end(), position) - x.begin(), 1, x.size() - 1);
        return profile.heights[i - 1] +
               (profile.heights[i] - profile.heights[i - 1]) * (position - x[i - 1]) / (x[i] - x[i - 1]);
    };
    std::vector<double> positions{begin}, heights{height_at(begin)};
    for (Index i = 0; i < x.size(); ++i)
        if (x[i] > begin && x[i] < end) {
            positions.push_back(x[i]);
            heights.push_back(profile.heights[i]);
        }
    positions.push_back(end);
    heights.push_back(height_at(end));
    const auto n = static_cast<Index>(positions.size());
    return {Eigen::Map<const Array1D>(positions.data(), n), Eigen::Map<const Array1D>(heights.data(), n),
            profile.metadata};
}

}  // namespace

std::vector<topography::Measurement> sections(const MeasurementView& line, double section_length) {
    require_line(line);
    const auto* scan = line.as<LineScan>();
    const auto* profile = line.as<Profile>();
    const double size = scan ? scan->size : profile->size();
    const auto count = section_length > 0.0 ? static_cast<Index>(std::floor(size / section_length + 0.01)) : 0;
    if (count < 1)
        throw InvalidArgument(fmt::format(
            "{}: a section of {} is longer than {}; choose shorter sections or a smaller L-filter",
            topography::label(line.metadata()), format_value(section_length, "m"), format_value(size, "m")));
    std::vector<topography::Measurement> parts;
    if (scan) {
        const auto fitting = static_cast<Index>(std::floor(section_length / scan->pixel_size() * (1.0 + 1e-9)));
        const auto points = std::max<Index>(1, std::min(fitting, scan->heights.size() / count));
        for (Index k = 0; k < count; ++k)
            parts.emplace_back(LineScan{scan->heights.segment(k * points, points),
                                        static_cast<double>(points) * scan->pixel_size(), false, scan->metadata});
        return parts;
    }
    topography::validate(*profile);
    const double length = std::min(section_length, size / static_cast<double>(count)), start = profile->positions[0];
    for (Index k = 0; k < count; ++k) {
        const double begin = start + static_cast<double>(k) * length;
        parts.emplace_back(
            cut(*profile, begin, std::min(begin + length, profile->positions[profile->positions.size() - 1])));
    }
    return parts;
}

namespace {

/// Means of slopes, undefined ones left out.
struct SlopeMeans {
    double squares = 0.0, absolute = 0.0, largest = 0.0, developed = 0.0, weight = 0.0;

    void add(double slope, double length) {
        if (std::isnan(slope)) return;
        squares += slope * slope * length;
        absolute += std::abs(slope) * length;
        largest = std::max(largest, std::abs(slope));
        developed += slope * slope / (1.0 + std::sqrt(1.0 + slope * slope)) * length;  // sqrt(1 + s²) − 1
        weight += length;
    }
    [[nodiscard]] double rms() const { return weight > 0.0 ? std::sqrt(squares / weight) : undefined; }
    [[nodiscard]] double mean() const { return weight > 0.0 ? absolute / weight : undefined; }
    [[nodiscard]] double maximum() const { return weight > 0.0 ? largest : undefined; }
    [[nodiscard]] double excess() const { return weight > 0.0 ? developed / weight : undefined; }
};

}  // namespace

ProfileSlopes profile_slopes(const MeasurementView& line) {
    require_line(line);
    SlopeMeans wide, narrow;
    if (const auto* profile = line.as<Profile>()) {
        topography::validate(*profile);
        for (Index i = 1; i < profile->heights.size(); ++i) {
            const double length = profile->positions[i] - profile->positions[i - 1];
            narrow.add((profile->heights[i] - profile->heights[i - 1]) / length, length);
        }
        return {narrow.rms(), narrow.mean(), narrow.maximum(), narrow.excess(), narrow.rms()};
    }
    const auto& scan = *line.as<LineScan>();
    const auto n = scan.heights.size();
    const double step = scan.pixel_size();
    const auto z = [&](Index i) { return scan.heights[(i + n) % n]; };
    for (Index i = scan.periodic ? 0 : 1; i < n; ++i) narrow.add((z(i) - z(i - 1)) / step, 1.0);
    const Index margin = scan.periodic ? 0 : 3;
    for (Index i = margin; i < n - margin && n >= 7; ++i)
        wide.add((45.0 * (z(i + 1) - z(i - 1)) - 9.0 * (z(i + 2) - z(i - 2)) + (z(i + 3) - z(i - 3))) / (60.0 * step),
                 1.0);
    return {wide.rms(), wide.mean(), wide.maximum(), narrow.excess(), narrow.rms()};
}

}  // namespace setae::texture
