// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "storage/raster.hpp"

// HGT tiles of the Shuttle Radar Topography Mission: only big-endian integers, heights above the geoid in m, rows from
// the north. A tile spans one degree from the first point to the last; its south-west corner is in its name, such as
// N46E007.hgt.
namespace setae::formats {
namespace {

constexpr std::int16_t void_height = -32768;

struct Tile {
    Index nx, ny;
    [[nodiscard]] std::uint64_t bytes() const {
        return sizeof(std::int16_t) * static_cast<std::uint64_t>(nx) * static_cast<std::uint64_t>(ny);
    }
};
/// 3", 1", and 1" by 2" beyond 50° of latitude.
constexpr std::array tiles{Tile{1201, 1201}, Tile{3601, 3601}, Tile{1801, 3601}};

const Tile* tile_of(std::uint64_t bytes) {
    const auto at = std::find_if(tiles.begin(), tiles.end(), [&](const Tile& tile) { return tile.bytes() == bytes; });
    return at == tiles.end() ? nullptr : &*at;
}

/// Heights in the range of the Earth's land and sea floors, in rows from the whole tile: other content uses the whole
/// range of integers.
bool holds_plausible_heights(const Tile& tile, const bytes::Source& source) {
    constexpr int lowest = -500, highest = 9000;
    constexpr Index rows = 32;
    const auto row_bytes = sizeof(std::int16_t) * static_cast<std::uint64_t>(tile.nx);
    int least = highest, greatest = lowest;
    for (Index k = 0; k < rows; ++k) {
        const auto row =
            source.bytes(static_cast<std::uint64_t>(k * (tile.ny - 1) / (rows - 1)) * row_bytes, row_bytes);
        for (std::uint64_t at = 0; at < row_bytes; at += sizeof(std::int16_t)) {
            const auto height = bytes::load<std::int16_t>(row.data() + at, std::endian::big);
            if (height == void_height) continue;
            if (height < lowest || height > highest) return false;
            least = std::min<int>(least, height);
            greatest = std::max<int>(greatest, height);
        }
    }
    return least < greatest;
}

/// Latitude [°] of the southern edge, from a name "N46E007.hgt".
std::optional<double> southern_latitude(const std::string& name) {
    const auto digits = [&](std::size_t from, std::size_t count) {
        return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(from),
                           name.begin() + static_cast<std::ptrdiff_t>(from + count),
                           [](char c) { return c >= '0' && c <= '9'; });
    };
    const auto file = name.substr(name.find_last_of("/\\ ") + 1);
    if (file.size() < 7) return std::nullopt;
    const auto start = name.size() - file.size();
    const auto letters = bytes::lowered(file.substr(0, 4));
    if ((letters[0] != 'n' && letters[0] != 's') || (letters[3] != 'e' && letters[3] != 'w') || !digits(start + 1, 2) ||
        !digits(start + 4, 3))
        return std::nullopt;
    const double latitude = (file[1] - '0') * 10.0 + (file[2] - '0');
    if (latitude > 90.0) return std::nullopt;
    return letters[0] == 's' ? -latitude : latitude;
}

/// Length of a degree [m] along the parallel and the meridian at a latitude [°] of the ellipsoid WGS 84:
///
///   π/180 · N cos φ,  N = a / sqrt(1 − e² sin² φ);   π/180 · M,  M = a (1 − e²) / (1 − e² sin² φ)^(3/2)
struct DegreeLengths {
    double east = 0.0, north = 0.0;
};

DegreeLengths degree_lengths(double latitude) {
    constexpr double semi_major_axis = 6378137.0, flattening = 1.0 / 298.257223563,
                     eccentricity2 = flattening * (2.0 - flattening);
    const double angle = latitude * pi / 180.0,
                 root = std::sqrt(1.0 - eccentricity2 * std::sin(angle) * std::sin(angle));
    return {pi / 180.0 * semi_major_axis / root * std::cos(angle),
            pi / 180.0 * semi_major_axis * (1.0 - eccentricity2) / (root * root * root)};
}

Match detect_hgt(std::string_view, const bytes::Source& source) {
    const auto* tile = tile_of(source.size);
    return tile && holds_plausible_heights(*tile, source) ? Match::maybe : Match::no;
}

std::vector<Channel> open_hgt(const bytes::Source& source, const ReadOptions& options) {
    const auto* tile = tile_of(source.size);
    if (!tile)
        throw FormatError(
            source.name, {.offset = source.size},
            "HGT: the file ends here, expected a tile of 1201 × 1201, 1801 × 3601 or 3601 × 3601 values of 2 bytes");
    ChannelInfo info;
    info.format = "hgt";
    info.name = "elevation";
    info.unit = "m";
    info.orientation = "rows from the north, as stored";
    if (const auto south = southern_latitude(source.name)) {
        const double middle = *south + 0.5;
        const auto degree = degree_lengths(middle);
        const auto points_per_step = [](Index points) {
            return static_cast<double>(points) / static_cast<double>(points - 1);
        };
        info.size = {degree.east * points_per_step(tile->nx), degree.north * points_per_step(tile->ny)};
        const double narrowing = degree_lengths(*south + 1.0).east / degree_lengths(*south).east - 1.0;
        info.metadata.attributes["latitude"] = fmt::format("{} to {} degrees", *south, *south + 1.0);
        info.alerts.push_back(
            {"SIZE_FROM_NAME", source.name,
             fmt::format(
                 "the file states no size; from the latitude {}° in its name a degree is {:.1f} m by {:.1f} m in "
                 "the middle of the tile (WGS 84), and {:+.2f} % along x from the southern edge to the northern",
                 middle, degree.east, degree.north, 100.0 * narrowing),
             "give `size` if the map has another projection"});
    }
    const Raster raster{.nx = tile->nx, .ny = tile->ny, .sample = Sample::int16, .order = std::endian::big};
    return {
        raster_channel(std::move(info), source, raster, {.undefined = {static_cast<double>(void_height)}}, options)};
}

}  // namespace

Format hgt_format() {
    return {.identifier = "hgt",
            .name = "HGT",
            .extensions = ".hgt",
            .description =
                "tiles of the Shuttle Radar Topography Mission, of 1201 × 1201, 3601 × 3601 or 1801 × 3601 points",
            .heights = "big-endian integers of 2 bytes, in m above the geoid; -32768 is undefined",
            .orientation = "rows from the north, as stored",
            .not_read = "water masks and other single-byte or floating-point companions of a tile",
            .reference = "SRTM_Topo, NASA; sizes as in GDAL's driver SRTMHGT; WGS 84 of NIMA TR8350.2",
            .detect = detect_hgt,
            .open = open_hgt};
}

}  // namespace setae::formats
