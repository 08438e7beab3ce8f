// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/header_number.hpp"
#include "setae/topography/line_scans.hpp"

// Mahr MarWin QEP: a ZIP archive of profiles. A profile begins with "[p3dlin]", has its number of points at byte 20, at
// byte 196 a table of texts (number, then length and characters of each; ">Key=Value"), the sections "[sellsg]" and
// "[Trajec]", and 49 bytes after the beginning of the latter x, y, z [mm] as float64 and a float32 a point that is not
// 0 if the point is invalid.
namespace setae::formats {
namespace {

constexpr std::string_view qep_magic = "[p3dlin]", first_marker = "[sellsg]", second_marker = "[Trajec]";
constexpr std::uint64_t points_at = 0x14, texts_at = 0xc4, data_behind_marker = 49, bytes_per_point = 28;

/// Members that hold profiles, the measured one first.
constexpr std::array<std::pair<const char*, const char*>, 2> members{
    {{"Kontur1.prf", "measured"}, {"qe_contour_reference_profil_001.tmp", "reference"}}};

struct Blob {
    std::map<std::string, std::string> texts;
    Array1D positions, heights;  ///< [m]
};

std::map<std::string, std::string> read_texts(bytes::Cursor& cursor) {
    std::map<std::string, std::string> texts;
    const auto count = cursor.number<std::int32_t>();
    for (std::int32_t i = 0; i < count; ++i) {
        const auto length = cursor.number<std::int32_t>();
        if (length < 0) cursor.fail(fmt::format("a text of {} characters; the profile is damaged", length));
        const auto entry = bytes::decoded(cursor.bytes(static_cast<std::uint64_t>(length)), bytes::Encoding::latin1);
        const auto equals = entry.find('=');
        if (entry.starts_with('>') && equals != std::string::npos)
            texts[entry.substr(1, equals - 1)] = entry.substr(equals + 1);
    }
    return texts;
}

std::uint64_t position_of(std::string_view content, std::string_view marker, std::uint64_t from,
                          const bytes::Source& source) {
    const auto at = content.find(marker, from);
    if (at == std::string_view::npos)
        throw FormatError(
            source.name, {.offset = content.size()},
            fmt::format("MarWin: the profile ends without the section '{}'; it is truncated or damaged", marker));
    return at;
}

Blob read_blob(const bytes::Source& source) {
    const auto content = source.all();
    if (!content.starts_with(qep_magic))
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("MarWin: expected a profile that begins with '{}'", qep_magic));
    bytes::Cursor cursor(source, "MarWin", points_at);
    const auto points = cursor.number<std::int32_t>();
    if (points < 2) cursor.fail(fmt::format("a profile of {} points, expected at least 2", points));
    cursor.seek(texts_at);
    Blob blob;
    blob.texts = read_texts(cursor);
    const auto data =
        position_of(content, second_marker, position_of(content, first_marker, cursor.position(), source), source) +
        data_behind_marker;
    const auto count = static_cast<std::uint64_t>(points);
    if (data > content.size() || content.size() - data != count * bytes_per_point)
        throw FormatError(
            source.name, {.offset = content.size()},
            fmt::format("MarWin: expected the end of {} points at byte {}, but the profile ends here; it is damaged",
                        points, data + count * bytes_per_point));
    blob.positions.resize(points);
    blob.heights.resize(points);
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto* from = content.data() + data;
        const auto k = static_cast<Index>(i);
        const bool invalid = bytes::load<float>(from + 24 * count + 4 * i, std::endian::little) != 0.0f;
        blob.positions[k] = bytes::load<double>(from + 8 * i, std::endian::little) * units::mm;
        blob.heights[k] =
            invalid ? undefined : bytes::load<double>(from + 16 * count + 8 * i, std::endian::little) * units::mm;
        if (!std::isfinite(blob.positions[k]))
            throw FormatError(source.name, {.offset = data + 8 * i},
                              fmt::format("MarWin: x of point {} is undefined", i + 1));
    }
    return blob;
}

/// Radius of the probe [mm], with the decimal sign of the locale of the instrument.
std::optional<double> probe_radius(const std::map<std::string, std::string>& texts) {
    const auto at = texts.find("ProbeRadius");
    double value = 0.0;
    if (at == texts.end() ||
        !(bytes::parse_cell(at->second, '.', value) || bytes::parse_cell(at->second, ',', value)) || !(value > 0.0))
        return std::nullopt;
    return value * units::mm;
}

topography::Metadata metadata_of(const std::map<std::string, std::string>& texts, const char* name,
                                 const bytes::Source& source) {
    const auto text = [&](const char* key) { return texts.contains(key) ? texts.at(key) : std::string(); };
    topography::Metadata metadata;
    metadata.name = name;
    metadata.file = source.name;
    metadata.format = "qep";
    metadata.unit = "mm";
    metadata.acquisition_time = text("DateTime");
    metadata.instrument.name = text("MachineName").empty() ? "Mahr" : text("MachineName");
    metadata.instrument.type = "stylus";
    metadata.instrument.tip_radius = probe_radius(texts);
    if (const auto product = text("ProductName"); !product.empty())
        metadata.attributes["software_version"] =
            product + (text("ProductVersion").empty() ? "" : " " + text("ProductVersion"));
    return metadata;
}

/// A scan if steps are equal, otherwise the curve of its valid points.
topography::Measurement measurement_of(Blob blob, const topography::Metadata& metadata, const bytes::Source& source) {
    if (blob.positions[blob.positions.size() - 1] < blob.positions[0]) {
        blob.positions.reverseInPlace();
        blob.heights.reverseInPlace();
    }
    for (Index i = 1; i < blob.positions.size(); ++i)
        if (!(blob.positions[i] > blob.positions[i - 1]))
            throw FormatError(source.name, {},
                              fmt::format("MarWin: x of point {} is not larger than that of the point before", i + 1));
    topography::Profile profile{blob.positions, blob.heights, metadata};
    if (auto scan = topography::to_line_scan(profile)) return *std::move(scan);
    Index defined = 0;
    for (Index i = 0; i < profile.heights.size(); ++i) {
        if (!std::isfinite(profile.heights[i])) continue;
        profile.positions[defined] = profile.positions[i];
        profile.heights[defined++] = profile.heights[i];
    }
    profile.positions.conservativeResize(defined);
    profile.heights.conservativeResize(defined);
    if (defined < 2)
        throw UndefinedDataError(fmt::format("{}: {} defined points, expected at least 2", source.name, defined));
    return profile;
}

Match detect_qep(std::string_view head, const bytes::Source& source) {
    if (!bytes::is_zip(head)) return Match::no;
    const bytes::Archive archive(source);
    for (const auto& [member, name] : members)
        if (archive.has(member) && archive.head(member, qep_magic.size()) == qep_magic) return Match::yes;
    return Match::no;
}

std::vector<Channel> open_qep(const bytes::Source& source, const ReadOptions&) {
    const bytes::Archive archive(source);
    std::vector<Channel> channels;
    for (const auto& [member, name] : members) {
        if (!archive.has(member)) continue;
        const auto profile = archive.member(member);
        auto blob = read_blob(profile);
        ChannelInfo info{.name = name, .format = "qep"};
        info.unit = "mm";
        const auto metadata = metadata_of(blob.texts, name, source);
        channels.push_back(
            loaded_channel(std::move(info), checked(measurement_of(std::move(blob), metadata, profile), profile)));
    }
    return channels;
}

}  // namespace

Format qep_format() {
    return {
        .identifier = "qep",
        .name = "Mahr MarWin",
        .extensions = ".qep",
        .description =
            "ZIP archives of MarWin (Mahr contour and surface instruments): the measured profile and, where there is one, the reference",
        .heights = "float64 in mm; points with a flag are undefined, and left out where steps differ",
        .orientation = "a line; turned where x falls",
        .not_read = "evaluations and drawings are passed over",
        .reference = "QEP reader of SurfaceTopography 1.27; not tested on an instrument file",
        .carries_scale = true,
        .read_elsewhere = false,
        .detect = detect_qep,
        .open = open_qep};
}

}  // namespace setae::formats
