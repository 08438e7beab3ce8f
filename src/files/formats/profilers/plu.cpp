// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "storage/raster.hpp"

// Sensofar PLu: a head of 500 bytes (date as text of 128 bytes and as seconds since 1970, comment of 256 bytes,
// calibration of the axes, configuration of the measurement), then layer after layer: rows, columns, float32 in µm row
// after row, least and greatest, and pictures of 3 bytes per pixel. All little-endian.
namespace setae::formats {
namespace {

constexpr std::uint64_t date_bytes = 128, comment_bytes = 256, head_bytes = 500;
constexpr std::uint64_t calibration_at = 388, measurement_at = 428, layers_at = 489;
constexpr double not_measured = 1000001.0;

enum class Kind : std::uint32_t { image, profile, several_profiles, topography, coordinates, thickness, custom };

constexpr std::array<const char*, 7> kind_names{"picture",   "profile", "several profiles", "topography", "coordinates",
                                                "thickness", "custom"};

struct PluHead {
    std::string date, comment;
    double dx = 0.0, dy = 0.0;  ///< [µm]
    Kind kind = Kind::topography;
    unsigned layers = 1, version = 0, hardware = 0, pictures = 0;
};

/// Names by configuration number, available from version 2012 on.
std::string instrument_name(const PluHead& head) {
    static constexpr std::array names{"PLu",    "PLu 2300 XGA", "PLu 2300 XGA T5", "PLu 2300 SXGA",        "PLu 3300",
                                      "DCM 3D", "PLu neox",     "DCM 3D rev. 2",   "PLu Apex (prototype)", "S neox",
                                      "DCM8",   "PLu Apex"};
    const bool states_it = head.version != 0 && head.version <= 0xfb;
    return states_it && head.hardware < names.size() ? names[head.hardware] : "Sensofar";
}

PluHead read_head(bytes::Cursor& cursor) {
    PluHead head;
    head.date = cursor.text(date_bytes);
    cursor.seek(date_bytes + 4);
    head.comment = cursor.text(comment_bytes);
    head.dx = std::abs(cursor.number_at<float>(calibration_at + 16));
    head.dy = std::abs(cursor.number_at<float>(calibration_at + 20));
    head.kind = static_cast<Kind>(cursor.number_at<std::uint32_t>(measurement_at));
    head.layers = cursor.number_at<std::uint8_t>(layers_at);
    head.version = cursor.number_at<std::uint8_t>(layers_at + 1);
    head.hardware = cursor.number_at<std::uint8_t>(layers_at + 2);
    head.pictures = cursor.number_at<std::uint8_t>(layers_at + 3);
    cursor.seek(head_bytes);
    return head;
}

/// "Fri Mar 10 16:35:59 2023", NULs after it.
bool is_date(std::string_view text) {
    static constexpr std::array days{"Mon", "Tue", "Wed", "Thu", "Fri", "Sat", "Sun"};
    static constexpr std::array months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                       "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    const auto any_of = [&](const auto& names, std::size_t at) {
        for (const auto* name : names)
            if (text.substr(at, 3) == name) return true;
        return false;
    };
    return text.size() >= 24 && any_of(days, 0) && any_of(months, 4) && text[3] == ' ' && text[7] == ' ' &&
           text[10] == ' ' && text[13] == ':' && text[16] == ':' && text[19] == ' ';
}

Match detect_plu(std::string_view head, const bytes::Source& source) {
    if (head.size() < date_bytes || !is_date(head) || head.substr(0, date_bytes).find('\0') == std::string_view::npos)
        return Match::no;
    if (head.size() < head_bytes) return Match::maybe;
    bytes::Cursor cursor(source, "PLu");
    const auto kind = cursor.number_at<std::uint32_t>(measurement_at);
    return kind < kind_names.size() ? Match::maybe : Match::no;
}

std::vector<Channel> open_plu(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, "PLu");
    const auto head = read_head(cursor);
    const bool topography = head.kind == Kind::topography, profile = head.kind == Kind::profile,
               other = head.kind == Kind::image || head.kind == Kind::thickness;
    const auto number = static_cast<std::size_t>(head.kind);
    const auto* kind = number < kind_names.size() ? kind_names[number] : "an unknown kind";
    if (!topography && !profile && !other)
        cursor.fail(fmt::format("a measurement of {}, expected a topography or a profile; export it as one", kind));
    std::vector<Channel> channels;
    for (unsigned layer = 0; layer < std::max(head.layers, 1u); ++layer) {  // version 2000 does not count layers
        ChannelInfo info{.name = fmt::format("{} {}", topography || profile ? "layer" : kind, layer), .format = "plu"};
        info.metadata.acquisition_time = head.date;
        info.metadata.instrument.name = instrument_name(head);
        info.metadata.instrument.type = "optical";
        if (!head.comment.empty() && head.comment != "(None)") info.metadata.attributes["comment"] = head.comment;
        const auto rows = cursor.number<std::uint32_t>(), columns = cursor.number<std::uint32_t>();
        if (profile && rows != 1) cursor.fail(fmt::format("a profile of {} rows, expected 1", rows));
        const Raster raster{.offset = cursor.position(), .nx = columns, .ny = rows, .sample = Sample::float32};
        require_raster(raster, source, "PLu");
        cursor.skip(raster.row_distance() * rows);
        if (head.dx > 0.0 && head.dy > 0.0) info.size = {head.dx * columns * units::um, head.dy * rows * units::um};
        info.unit = head.kind == Kind::image ? "" : "µm";
        if (other) {
            info.shape = {raster.nx, raster.ny};
            info.metadata.file = source.name;
            channels.push_back(non_height_channel(std::move(info)));
        } else {
            if (topography)
                info.orientation = "rows from the top, as stored; not stated in the file, taken as Gwyddion shows it";
            channels.push_back(raster_channel(std::move(info), source, raster,
                                              {.factor = units::um, .undefined = {not_measured}}, options));
        }
        if (layer + 1 < head.layers || head.pictures > 0)
            cursor.skip(2 * sizeof(float) + std::uint64_t{3} * head.pictures * rows * columns);
    }
    return channels;
}

}  // namespace

Format plu_format() {
    return {
        .identifier = "plu",
        .name = "Sensofar PLu",
        .extensions = ".plu .apx",
        .description =
            "topographies and profiles of Sensofar's confocal and interferometric profilers, a channel a layer",
        .heights = "float32 in µm; 1000001 is undefined",
        .orientation = "rows stored from the top; the file does not state it",
        .not_read =
            "pictures and thicknesses are listed; several profiles, coordinates and custom measurements are refused",
        .reference = "sensofar module of Gwyddion, PLU reader of SurfaceTopography 1.27",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = detect_plu,
        .open = open_plu};
}

}  // namespace setae::formats
