// SPDX-License-Identifier: GPL-3.0-or-later
#include "sdf_writer.hpp"

#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "writing.hpp"

namespace setae::formats {
namespace {

constexpr Index max_points_of_sdf = 65535;
constexpr double sdf_not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Day, month, year, hour, minute; zeros if unknown.
std::string digits_of(const std::string& text) {
    const auto time = written_time(text);
    return time.known() ? time.day + time.month + time.year + time.hour + time.minute : std::string(12, '0');
}

/// In ASCII, truncated to the width and padded with blanks.
std::string fixed(const std::string& text, std::size_t width) {
    std::string ascii;
    for (const char c : text)
        if (c >= ' ' && c <= '~' && ascii.size() < width) ascii += c;
    return ascii.append(width - ascii.size(), ' ');
}

struct WrittenGrid {
    Index nx = 0, ny = 1;
    double x_scale = 0.0, y_scale = 0.0;  ///< [m]
};

void write_grid(const std::string& path, const WrittenGrid& grid, const Array2D& heights,
                const topography::Metadata& metadata) {
    std::string header = "bISO-1.0" + fixed(metadata.instrument.name, 10) + digits_of(metadata.acquisition_time) +
                         digits_of(metadata.acquisition_time);
    const auto add = [&](auto number) { header.append(reinterpret_cast<const char*>(&number), sizeof(number)); };
    add(static_cast<std::uint16_t>(grid.nx));
    add(static_cast<std::uint16_t>(grid.ny));
    add(grid.x_scale);
    add(grid.y_scale);
    add(1.0);                      // Zscale
    add(-1.0);                     // Zresolution, unknown
    header += {'\0', '\7', '\0'};  // no compression, float64, no check sum
    bytes::write_whole_file(path, {header, row_bytes(heights, sdf_not_a_number)});
}

}  // namespace

void write_sdf(const std::string& path, const topography::Measurement& measurement) {
    refuse_trace(measurement, path);
    const auto [nx, ny] = topography::shape(measurement);
    if (std::holds_alternative<topography::Profile>(measurement))
        throw InvalidArgument(fmt::format(
            "{}: SDF needs equally spaced points, and this is a profile; write it as .x3p, .nc or .csv", path));
    if (nx > max_points_of_sdf || ny > max_points_of_sdf)
        throw InvalidArgument(
            fmt::format("{}: SDF can hold at most {} points along each direction, but there are {} × {}; write it as "
                        ".x3p",
                        path, max_points_of_sdf, nx, ny));
    const auto& metadata = topography::metadata(measurement);
    if (const auto* map = std::get_if<topography::HeightMap>(&measurement)) {
        write_grid(path, {nx, ny, map->pixel_size()[0], map->pixel_size()[1]}, map->heights, metadata);
        return;
    }
    const auto& scan = std::get<topography::LineScan>(measurement);
    write_grid(path, {nx, 1, scan.pixel_size(), scan.pixel_size()},
               Eigen::Map<const Array2D>(scan.heights.data(), nx, 1), metadata);
}

}  // namespace setae::formats
