// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/calendar_time.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/expand.hpp"
#include "setae/bytes/expanded_source.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/header.hpp"
#include "storage/raster.hpp"

// Digital Surf SUR and PRO: objects one after another, each with a header of 512 bytes, a comment, a private zone and
// its points as integers of 16 or 32 bits, or as zlib streams after a list of their lengths. Height = raw · z spacing +
// z offset.
namespace setae::formats {
namespace {

constexpr std::string_view plain_signature = "DIGITAL SURF", compressed_signature = "DSCOMPRESSED", name = "SUR";
constexpr std::uint16_t macintosh = 0x0101;
constexpr std::uint64_t sur_header_bytes = 512;

enum ObjectType : std::uint16_t {
    profile = 1,
    surface = 2,
    binary_image = 3,
    profile_series = 4,
    surface_series = 5,
    meridian_disc = 6,
    multilayer_profile = 7,
    multilayer_surface = 8,
    parallel_disc = 9,
    intensity_image = 10,
    intensity_surface = 11,
    rgb_image = 12,
    rgb_surface = 13,
    force_curve = 14,
    force_curve_series = 15,
    rgb_intensity_surface = 16,
    contour = 17,
    rgb_image_series = 18
};

/// Inversion of the heights before storage.
enum Inversion : std::uint16_t { upright = 0, negated = 1, negated_and_mirrored = 2, negated_and_upside_down = 3 };

struct SurAxis {
    double spacing = 0.0, offset = 0.0;
    std::string label, unit;
};

struct SurHeader {
    bool compressed = false;
    std::endian order = std::endian::little;
    std::uint16_t objects = 1, type = surface, channels = 1, acquisition = 0, special_points = 0, inversion = upright;
    std::string object, operator_name, time;
    std::uint16_t bits = 16;
    std::int32_t least = 0, points = 0, lines = 0;
    SurAxis x, y, z;
    std::uint64_t data = 0;  ///< start of the points

    [[nodiscard]] std::uint64_t value_bytes() const { return bits / 8u; }
};

/// "µm" in the DOS character set is "æm" in Latin-1.
std::string unit_text(bytes::Cursor& cursor) {
    auto text = cursor.text(16);
    return text == "æm" ? "µm" : text;
}

std::string time_text(bytes::Cursor& cursor) {
    std::array<int, 6> fields{};  // seconds first
    for (auto& field : fields) field = cursor.number<std::int16_t>();
    return bytes::iso_text({.year = fields[5],
                            .month = fields[4],
                            .day = fields[3],
                            .hour = fields[2],
                            .minute = fields[1],
                            .second = fields[0]});
}

void read_axes(SurHeader& header, bytes::Cursor& cursor) {
    SurAxis* const axes[] = {&header.x, &header.y, &header.z};
    for (auto* axis : axes) axis->spacing = cursor.number<float>();
    for (auto* axis : axes) axis->label = cursor.text(16);
    for (auto* axis : axes) axis->unit = unit_text(cursor);
    cursor.skip(3 * 16 + 3 * 4);  // display units, and their ratios to those of the spacings
}

SurHeader read_header(bytes::Cursor& cursor) {
    SurHeader header;
    const auto begin = cursor.position();
    const auto signature = cursor.bytes(plain_signature.size());
    if (signature != plain_signature && signature != compressed_signature)
        cursor.fail(fmt::format("no object begins here, expected '{}' or '{}'; the file is damaged", plain_signature,
                                compressed_signature));
    header.compressed = signature == compressed_signature;
    if (cursor.number<std::uint16_t>() == macintosh) header.order = std::endian::big;
    cursor.set_order(header.order);
    header.objects = cursor.number<std::uint16_t>();
    cursor.skip(2);  // version
    header.type = cursor.number<std::uint16_t>();
    header.object = cursor.text(30);
    header.operator_name = cursor.text(30);
    header.channels = cursor.number<std::uint16_t>();
    header.acquisition = cursor.number<std::uint16_t>();
    cursor.skip(2);  // range
    header.special_points = cursor.number<std::uint16_t>();
    cursor.skip(2 + 4 + 4);  // absolute, gauge resolution, length of spectra
    header.bits = cursor.number<std::uint16_t>();
    if (header.bits != 16 && header.bits != 32)
        cursor.fail(fmt::format("{} bits per point, expected 16 or 32", header.bits));
    header.least = cursor.number<std::int32_t>();
    cursor.skip(4);  // greatest
    header.points = cursor.number<std::int32_t>();
    header.lines = std::max(cursor.number<std::int32_t>(), header.type == surface ? 0 : 1);
    const auto total = cursor.number<std::int32_t>();
    if (header.points < 1 || header.lines < 1 || std::int64_t{header.points} * header.lines != total)
        cursor.fail(fmt::format("{} points for {} × {}, expected their product", total, header.points, header.lines));
    read_axes(header, cursor);
    cursor.skip(2);  // imprint
    header.inversion = cursor.number<std::uint16_t>();
    cursor.skip(2 + 12);  // levelling, obsolete
    header.time = time_text(cursor);
    cursor.skip(2 + 4 + 4 + 6);  // day of the week, duration, compressed bytes, obsolete
    const auto comment = cursor.number<std::uint16_t>(), private_zone = cursor.number<std::uint16_t>();
    cursor.skip(128);
    for (auto* axis : {&header.x, &header.y, &header.z}) axis->offset = cursor.number<float>();
    for (const double number : {header.x.spacing, header.y.spacing, header.z.spacing, header.z.offset})
        if (!std::isfinite(number)) cursor.fail("a spacing or offset is not a number; the header is damaged");
    cursor.seek(begin + sur_header_bytes);
    cursor.skip(comment);
    cursor.skip(private_zone);
    header.data = cursor.position();
    return header;
}

/// A zlib stream in the file and its expanded size.
struct Stream {
    std::uint64_t offset = 0, size = 0, expanded = 0;
};

/// The points after a list of streams, expanded on reading; the cursor is then after them.
bytes::Source compressed_points(const SurHeader& header, bytes::Cursor& cursor) {
    const auto count = cursor.number<std::uint32_t>();
    if (count > cursor.remaining() / 8)
        cursor.fail(fmt::format(
            "{} compressed streams are announced, more than fit into the file; it is truncated or damaged", count));
    std::vector<Stream> streams(count);
    for (auto& stream : streams) {
        stream.expanded = cursor.number<std::uint32_t>();
        stream.size = cursor.number<std::uint32_t>();
    }
    std::uint64_t expanded = 0;
    for (auto& stream : streams) {
        stream.offset = cursor.position();
        cursor.skip(stream.size);
        expanded += stream.expanded;
        if (stream.expanded > bytes::max_expanded(stream.size))
            cursor.fail(
                fmt::format("{} compressed bytes announce {}; the file is damaged", stream.size, stream.expanded));
    }
    const auto needed =
        static_cast<std::uint64_t>(header.points) * static_cast<std::uint64_t>(header.lines) * header.value_bytes();
    if (expanded != needed)
        cursor.fail(fmt::format("{} × {} points of {} bits in {} expanded bytes, expected {}", header.points,
                                header.lines, header.bits, expanded, needed));
    const auto& file = cursor.source();
    return bytes::expanded_source(file.name, needed, [file, streams] {
        std::string points;
        for (const auto& stream : streams)
            points += bytes::inflated(file.bytes(stream.offset, stream.size), file, stream.offset, std::string(name));
        return points;
    });
}

std::string instrument_type(std::uint16_t acquisition) {
    switch (acquisition) {
        case 1:
        case 5: return "stylus";
        case 6: return "afm";
        case 7: return "stm";
        case 2:
        case 8:
        case 10: return "optical";
        case 9: return "interferometer";
        default: return "";
    }
}

topography::Metadata metadata_of(const SurHeader& header) {
    topography::Metadata metadata;
    metadata.acquisition_time = header.time;
    metadata.instrument.type = instrument_type(header.acquisition);
    if (!header.object.empty()) metadata.attributes["object"] = header.object;
    if (!header.operator_name.empty()) metadata.attributes["operator"] = header.operator_name;
    if (header.inversion != upright) metadata.attributes["inversion"] = fmt::format("{}", header.inversion);
    return metadata;
}

std::string orientation_text(const SurHeader& header) {
    if (header.inversion == negated_and_mirrored) return "rows from the top, each from the right, turned";
    if (header.inversion == negated_and_upside_down) return "rows from the bottom, turned";
    return "rows from the top, as stored";
}

/// Extent along each direction [m]; empty if a unit is missing or no length.
std::vector<double> extent_of(const SurHeader& header) {
    const auto x = tables::try_parse_unit(header.x.unit),
               y = tables::try_parse_unit(header.lines > 1 ? header.y.unit : header.x.unit);
    if (header.x.unit.empty() || !x || !y || x->dimension != dimension::length || y->dimension != dimension::length)
        return {};
    std::vector<double> size{header.points * std::abs(header.x.spacing) * x->factor};
    if (header.lines > 1) size.push_back(header.lines * std::abs(header.y.spacing) * y->factor);
    return size;
}

/// The points of one object; the cursor is then after it.
Channel object_channel(const SurHeader& header, const std::string& title, bool is_height,
                       const topography::Metadata& metadata, bytes::Cursor& cursor, const ReadOptions& options) {
    const bool turned = header.inversion >= negated && header.inversion <= negated_and_upside_down;
    Raster raster{.offset = header.compressed ? 0 : header.data,
                  .nx = header.points,
                  .ny = header.lines,
                  .sample = header.bits == 16 ? Sample::int16 : Sample::int32,
                  .order = header.order,
                  .bottom_up = header.inversion == negated_and_upside_down,
                  .right_to_left = header.inversion == negated_and_mirrored};
    const auto source = header.compressed ? compressed_points(header, cursor) : cursor.source();
    require_raster(raster, source, std::string(name));
    if (!header.compressed)
        cursor.skip(static_cast<std::uint64_t>(raster.nx) * static_cast<std::uint64_t>(raster.ny) *
                    header.value_bytes());
    ChannelInfo info{
        .name = title, .format = "sur", .size = extent_of(header), .unit = header.z.unit, .metadata = metadata};
    const auto unit = tables::try_parse_unit(header.z.unit);
    if (!is_height || (!header.z.unit.empty() && (!unit || unit->dimension != dimension::length))) {
        info.shape = raster.ny > 1 ? std::vector<Index>{raster.nx, raster.ny} : std::vector<Index>{raster.nx};
        info.metadata.file = source.name;
        return non_height_channel(std::move(info));
    }
    if (raster.ny > 1) info.orientation = orientation_text(header);
    const double metres = header.z.unit.empty() ? 1.0 : unit->factor;
    RawScale scale{.factor = (turned ? -1.0 : 1.0) * header.z.spacing * metres, .offset = header.z.offset * metres};
    if (header.special_points == 1) scale.undefined = {header.least - 2.0};
    return raster_channel(std::move(info), source, raster, scale, options);
}

[[noreturn]] void refuse(const bytes::Source& source, std::uint16_t type) {
    const bool force = type == force_curve || type == force_curve_series;
    throw FormatError(
        source.name, {.offset = 18},
        force ? "SUR: the file contains force curves, not a topography; export them as text, which `setae jkr "
                "fit` reads"
              : fmt::format(
                    "SUR: objects of type {} are neither map nor profile; expected type 1 to 5, 7, 8, 10 to 13, 16 "
                    "or 18",
                    type));
}

/// Numbers of objects in sequence, and of objects per heights.
struct Group {
    std::size_t objects = 1, channels = 1;
    bool others_are_heights = true, first_is_height = true;
};

Group group_of(const SurHeader& first, const bytes::Source& source) {
    const std::size_t objects = std::max<std::size_t>(first.objects, 1),
                      channels = std::max<std::size_t>(first.channels, 1);
    switch (first.type) {
        case profile:
        case surface: return {};
        case profile_series:
        case surface_series: return {.objects = objects};
        case multilayer_profile:
        case multilayer_surface: return {.objects = objects * channels};
        case intensity_surface:
        case rgb_surface:
        case rgb_intensity_surface:
            return {.objects = objects * channels, .channels = channels, .others_are_heights = false};
        case binary_image:
        case intensity_image:
        case rgb_image:
        case rgb_image_series:
            return {.objects = objects * channels, .others_are_heights = false, .first_is_height = false};
        default: refuse(source, first.type);
    }
}

Match detect_sur(std::string_view head, const bytes::Source&) {
    return head.starts_with(plain_signature) || head.starts_with(compressed_signature) ? Match::yes : Match::no;
}

std::vector<Channel> open_sur(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, std::string(name));
    auto header = read_header(cursor);
    const auto group = group_of(header, source);
    const auto metadata = metadata_of(header);
    std::vector<Channel> channels;
    for (std::size_t i = 0;; ++i) {
        const bool first = i % group.channels == 0;
        const auto label = header.z.label.empty() ? "Z" : header.z.label;
        channels.push_back(object_channel(header, group.objects > 1 ? fmt::format("{} {}", label, i + 1) : label,
                                          first ? group.first_is_height : group.others_are_heights, metadata, cursor,
                                          options));
        if (i + 1 == group.objects) return channels;
        header = read_header(cursor);
    }
}

}  // namespace

Format sur_format() {
    return {
        .identifier = "sur",
        .name = "Digital Surf SUR",
        .extensions = ".sur .pro",
        .description =
            "surfaces and profiles of MountainsMap and of instruments that write for it, single, in series or in layers, plain or compressed",
        .heights =
            "raw times z spacing plus z offset, negated if the header states inverted; with special points "
            "the value two below the least is undefined",
        .orientation = "rows stored from the top; turned if the header states mirrored or upside down",
        .not_read =
            "discs, contours, spectra and force curves are refused; images and colours are listed; saturated points (one beyond least and greatest) stay heights; axes' origins",
        .reference =
            "Digital Surf's header of 512 bytes as Gwyddion's surffile.c, RosettaSciIO and surfalize describe it",
        .tested_on_real_files = true,
        .detect = detect_sur,
        .open = open_sur};
}

}  // namespace setae::formats
