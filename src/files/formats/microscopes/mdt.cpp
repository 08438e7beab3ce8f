// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/header.hpp"
#include "storage/raster.hpp"

// NT-MDT: a head of 33 bytes (magic, bytes of all frames, number of the last frame at 12), then frames: bytes of the
// frame, type, version, date, bytes of variables. Frames of type 0 have calibrations of x, y, z (offset, step as
// float32, unit as int16), then columns, rows and a map of int16; frames of type 106 ("MDA") describe dimensions and
// measurands in full. Little-endian.
namespace setae::formats {
namespace {

constexpr std::string_view mdt_magic = "\x01\xb0\x93\xff";
constexpr std::uint64_t head_bytes = 33, frame_head_bytes = 22, min_variables = 36;
constexpr std::uint16_t scanned = 0, spectroscopy = 1, text_frame = 3, old_mda = 105, mda = 106, palette = 107,
                        curves = 201;

struct FrameHead {
    std::uint64_t begin = 0, bytes = 0;
    std::uint16_t type = 0, variables = 0;
    std::string date;

    [[nodiscard]] std::uint64_t body() const { return begin + frame_head_bytes; }
    [[nodiscard]] std::uint64_t end() const { return begin + bytes; }
};

/// Windows' Cyrillic code page, in which titles and units are written.
std::string from_cyrillic(std::string_view bytes) {
    std::string text;
    const auto append = [&](unsigned code) {
        text += static_cast<char>(0xc0u | (code >> 6));
        text += static_cast<char>(0x80u | (code & 0x3fu));
    };
    for (const char c : bytes.substr(0, bytes.find('\0'))) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) text += c;
        else if (byte >= 0xc0) append(0x410u + byte - 0xc0u);
        else if (byte == 0xa8 || byte == 0xb8) append(byte == 0xa8 ? 0x401u : 0x451u);
        else if (byte == 0xb0 || byte == 0xb5)  // ° and µ
            append(byte);
        else text += '?';
    }
    return text;
}

/// Unit by its number; empty for counts, pixels and dimensionless quantities.
std::string unit_of(std::int16_t code) {
    static constexpr std::array lengths{"m", "cm", "mm", "µm", "nm", "Å"};  // from −5
    static constexpr std::array others{"nA", "V", "", "kHz", "deg", "%", "°C", "V", "s", "ms", "µs", "ns"};  // from 1
    static constexpr std::array electric{"A",  "mA", "µA", "nA", "pA", "V",  "mV", "µV",
                                         "nV", "pV", "N",  "mN", "µN", "nN", "pN"};  // from 20
    if (code >= -5 && code <= 0) return lengths[static_cast<std::size_t>(code + 5)];
    if (code >= 1 && code <= 12) return others[static_cast<std::size_t>(code - 1)];
    if (code >= 20 && code <= 34) return electric[static_cast<std::size_t>(code - 20)];
    return {};
}

bool is_length(const std::string& text) {
    const auto unit = tables::try_parse_unit(text);
    return unit && unit->dimension == dimension::length;
}

const char* signal_name(std::uint8_t number) {
    static constexpr std::array names{"Height",  "DFL",     "Lateral F", "Bias V",  "Current",  "FB-Out", "MAG",
                                      "MAG*Sin", "MAG*Cos", "RMS",       "CalcMag", "Phase1",   "Phase2", "CalcPhase",
                                      "Ex1",     "Ex2",     "HvX",       "HvY",     "Snap Back"};
    return number < names.size() ? names[number] : "signal";
}

/// Calibration of an axis: value = offset + step · index, in its unit.
struct MdtAxis {
    double offset = 0.0, step = 0.0;
    std::string unit;

    [[nodiscard]] bool is_length() const { return formats::is_length(unit) && std::isfinite(step) && step != 0.0; }
};

/// A map in a frame.
struct MdtImage {
    std::string name;
    MdtAxis x, y, z;
    Raster raster;
};

FrameHead read_head(bytes::Cursor& cursor, std::uint64_t begin, unsigned number) {
    cursor.seek(begin);
    FrameHead frame{.begin = begin};
    frame.bytes = cursor.number<std::uint32_t>();
    if (frame.bytes < frame_head_bytes)
        cursor.fail(fmt::format("frame {} of {} bytes, expected at least {}", number, frame.bytes, frame_head_bytes));
    frame.type = cursor.number<std::uint16_t>();
    cursor.skip(2);
    std::array<unsigned, 6> date{};
    for (auto& part : date) part = cursor.number<std::uint16_t>();
    frame.date =
        fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}", date[0], date[1], date[2], date[3], date[4], date[5]);
    frame.variables = cursor.number<std::uint16_t>();
    if (frame.bytes > cursor.source().size - begin)
        throw FormatError(
            cursor.source().name, {.offset = cursor.source().size},
            fmt::format("NT-MDT: the file ends here, expected the end of frame {} at byte {}; it is truncated", number,
                        frame.end()));
    return frame;
}

MdtAxis read_axis(bytes::Cursor& cursor) {
    MdtAxis axis;
    axis.offset = cursor.number<float>();
    axis.step = cursor.number<float>();
    axis.unit = unit_of(cursor.number<std::int16_t>());
    return axis;
}

/// Text of stated length at the cursor; empty if it would leave its frame.
std::string title_at(bytes::Cursor& cursor, std::uint64_t end) {
    if (cursor.position() + 4 > end) return {};
    const auto length = cursor.number<std::uint32_t>();
    return cursor.position() + length <= end ? from_cyrillic(cursor.bytes(length)) : std::string();
}

/// Conditions on every map of a frame in addition to its position in the file.
void require_in_frame(const MdtImage& image, const FrameHead& frame, const bytes::Cursor& cursor) {
    require_raster(image.raster, cursor.source(), "NT-MDT");
    const auto end = image.raster.offset + image.raster.row_distance() * static_cast<std::uint64_t>(image.raster.ny);
    if (end > frame.end())
        cursor.fail(
            fmt::format("'{}': {} × {} values would end at byte {}, but their frame ends at {}; the file is damaged",
                        image.name, image.raster.nx, image.raster.ny, end, frame.end()));
}

std::optional<MdtImage> scanned_image(bytes::Cursor& cursor, const FrameHead& frame) {
    if (frame.variables < min_variables)
        cursor.fail(
            fmt::format("a scan with {} bytes of variables, expected at least {}", frame.variables, min_variables));
    cursor.seek(frame.body());
    MdtImage image;
    image.x = read_axis(cursor);
    image.y = read_axis(cursor);
    image.z = read_axis(cursor);
    image.name = signal_name(cursor.number<std::uint8_t>());
    cursor.seek(frame.body() + frame.variables + 2);
    image.raster = {.nx = cursor.number<std::uint16_t>(),
                    .ny = cursor.number<std::uint16_t>(),
                    .sample = Sample::int16,
                    .bottom_up = true};
    const auto dots = cursor.number<std::uint16_t>();
    if (dots > 0) cursor.skip(14 + std::uint64_t{16} * dots);
    image.raster.offset = cursor.position();
    if (image.raster.nx == 0 || image.raster.ny == 0) return std::nullopt;  // spectra at points, no map
    require_in_frame(image, frame, cursor);
    cursor.skip(image.raster.row_distance() * static_cast<std::uint64_t>(image.raster.ny));
    if (const auto title = title_at(cursor, frame.end()); !title.empty()) image.name = title;
    return image;
}

/// Calibration of a dimension or measurand of an MDA frame.
struct Calibration {
    MdtAxis axis;
    std::string name;
    std::uint64_t points = 0;
    std::int32_t type = 0;
};

std::string si_unit(std::uint64_t code) {
    return code == 0x101 ? "m" : code == 0x100001 ? "A" : code == 0xfffd010200 ? "V" : code == 0x1000001 ? "s" : "";
}

Calibration read_calibration(bytes::Cursor& cursor) {
    const auto begin = cursor.position();
    const auto total = cursor.number<std::uint32_t>(), fixed = cursor.number<std::uint32_t>();
    const auto texts = cursor.position() + fixed;
    const auto name = cursor.number<std::uint32_t>(), comment = cursor.number<std::uint32_t>(),
               unit = cursor.number<std::uint32_t>();
    Calibration calibration;
    calibration.axis.unit = si_unit(cursor.number<std::uint64_t>());
    cursor.skip(16);  // accuracy, function
    calibration.axis.offset = cursor.number<double>();
    calibration.axis.step = cursor.number<double>();
    const auto first = cursor.number<std::uint64_t>(), last = cursor.number<std::uint64_t>();
    calibration.points = last - first + 1;  // overflow is refused with the raster
    calibration.type = cursor.number<std::int32_t>();
    cursor.seek(texts);
    calibration.name = from_cyrillic(cursor.bytes(name));
    cursor.skip(comment);
    if (unit > 0) calibration.axis.unit = from_cyrillic(cursor.bytes(unit));
    if (total < 8) cursor.fail(fmt::format("a calibration of {} bytes; the file is damaged", total));
    cursor.seek(begin + total);
    return calibration;
}

std::optional<Sample> sample_of(std::int32_t type) {
    switch (type) {
        case -1: return Sample::int8;
        case 1: return Sample::uint8;
        case -2: return Sample::int16;
        case 2: return Sample::uint16;
        case -4: return Sample::int32;
        case 4: return Sample::uint32;
        case -8: return Sample::int64;
        case 8: return Sample::uint64;
        case -(4 + 23 * 256): return Sample::float32;
        case -(8 + 52 * 256): return Sample::float64;
        default: return std::nullopt;
    }
}

/// Maps of a self-describing frame: two dimensions and measurands that alternate point by point. Empty for other
/// shapes.
std::vector<MdtImage> mda_images(bytes::Cursor& cursor, const FrameHead& frame) {
    cursor.seek(frame.body());
    const auto head = cursor.number<std::uint32_t>();
    cursor.skip(4 + 2 * 16 + 4);
    const auto title_bytes = cursor.number<std::uint32_t>();
    std::uint64_t trailing = cursor.number<std::uint32_t>();                          // comment
    for (int part = 0; part < 3; ++part) trailing += cursor.number<std::uint32_t>();  // view, specification, source
    cursor.seek(frame.body() + head);
    const auto title = from_cyrillic(cursor.bytes(title_bytes));
    cursor.skip(trailing + 4);
    const auto structure = cursor.number<std::uint32_t>();
    const auto calibrations = cursor.position() + structure;
    cursor.skip(12);
    const auto dimensions = cursor.number<std::uint32_t>(), measurands = cursor.number<std::uint32_t>();
    constexpr std::uint32_t max_measurands = 64;
    if (dimensions != 2 || measurands == 0 || measurands > max_measurands) return {};
    cursor.seek(calibrations);
    const auto x = read_calibration(cursor), y = read_calibration(cursor);
    std::vector<Calibration> values;
    std::uint64_t cell = 0;
    for (std::uint32_t i = 0; i < measurands; ++i) {
        values.push_back(read_calibration(cursor));
        const auto sample = sample_of(values.back().type);
        if (!sample)
            cursor.fail(fmt::format("values of type {} in '{}', expected integers or floats", values.back().type,
                                    values.back().name));
        cell += bytes_of(*sample);
    }
    constexpr std::uint64_t max_points = std::uint64_t{1} << 31;
    if (x.points < 1 || y.points < 1 || x.points > max_points || y.points > max_points)
        cursor.fail(fmt::format("{} × {} points in '{}'; the file is damaged", x.points, y.points, title));
    std::vector<MdtImage> images;
    std::uint64_t within = 0;
    for (const auto& value : values) {
        MdtImage image{.name = title.empty() ? value.name : title, .x = x.axis, .y = y.axis, .z = value.axis};
        if (values.size() > 1 && !title.empty()) image.name += ": " + value.name;
        image.raster = {.offset = cursor.position() + within,
                        .nx = static_cast<Index>(x.points),
                        .ny = static_cast<Index>(y.points),
                        .sample = *sample_of(value.type),
                        .bottom_up = true,
                        .line_distance = cell * x.points,
                        .step = cell};
        within += bytes_of(image.raster.sample);
        images.push_back(std::move(image));
        require_raster(images.back().raster, cursor.source(), "NT-MDT");
    }
    return images;
}

Channel image_channel(const MdtImage& image, const FrameHead& frame, const bytes::Source& source,
                      const ReadOptions& options) {
    ChannelInfo info{.name = image.name, .format = "mdt"};
    info.metadata.acquisition_time = frame.date;
    info.metadata.instrument.name = "NT-MDT";
    info.metadata.instrument.type = "afm";
    info.unit = image.z.unit;
    if (image.x.is_length() && image.y.is_length())
        info.size = {
            std::abs(image.x.step) * static_cast<double>(image.raster.nx) * length_unit(image.x.unit, source).factor,
            std::abs(image.y.step) * static_cast<double>(image.raster.ny) * length_unit(image.y.unit, source).factor};
    const bool no_scale = is_length(info.unit) && !image.z.is_length();
    if (no_scale)
        info.alerts.push_back(
            {"NO_HEIGHT_SCALE", source.name,
             fmt::format("'{}' has a step of {} {}, so that its numbers cannot be converted to heights", info.name,
                         image.z.step, info.unit),
             "export the map again with its calibration"});
    if (!image.z.is_length()) {
        info.shape = {image.raster.nx, image.raster.ny};
        info.metadata.file = source.name;
        return non_height_channel(std::move(info));
    }
    if (image.raster.ny > 1) info.orientation = "rows from the bottom, turned";
    const double metres = length_unit(info.unit, source).factor;
    const double offset = std::isfinite(image.z.offset) ? image.z.offset : 0.0;
    return raster_channel(std::move(info), source, image.raster,
                          {.factor = metres * image.z.step, .offset = metres * offset}, options);
}

const char* kind_of(std::uint16_t type) {
    switch (type) {
        case scanned: return "spectra at points";
        case spectroscopy: return "spectroscopy";
        case text_frame: return "text";
        case old_mda: return "array of an old kind";
        case mda: return "array of another shape";
        case palette: return "palette";
        case curves: return "curves";
        default: return "unknown content";
    }
}

std::vector<Channel> open_mdt(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, "NT-MDT", mdt_magic.size());
    const auto announced = cursor.number<std::uint32_t>();
    cursor.skip(4);
    const unsigned frames = cursor.number<std::uint16_t>() + 1u;
    std::vector<Channel> channels;
    bool any_map = false;
    std::uint64_t begin = head_bytes;
    for (unsigned number = 0; number < frames; ++number) {
        const auto frame = read_head(cursor, begin, number);
        begin = frame.end();
        std::vector<MdtImage> images;
        if (frame.type == mda) images = mda_images(cursor, frame);
        if (frame.type == scanned)
            if (auto image = scanned_image(cursor, frame)) images.push_back(*std::move(image));
        for (const auto& image : images) channels.push_back(image_channel(image, frame, source, options));
        any_map = any_map || !images.empty();
        if (!images.empty() || frame.type == text_frame || frame.type == palette) continue;
        ChannelInfo info{.name = fmt::format("frame {}: {}", number, kind_of(frame.type)), .format = "mdt"};
        info.metadata.acquisition_time = frame.date;
        info.metadata.file = source.name;
        channels.push_back(non_height_channel(std::move(info)));
    }
    if (begin - head_bytes < announced)
        throw FormatError(
            source.name, {.offset = begin},
            fmt::format("NT-MDT: the last frame ends here, but {} bytes of frames were announced; the file is damaged",
                        announced));
    if (!any_map)
        throw FormatError(
            source.name, {.offset = head_bytes},
            fmt::format(
                "NT-MDT: {} frames without a map, expected scans; force curves exported as text are read by `setae jkr fit`",
                frames));
    return channels;
}

}  // namespace

Format mdt_format() {
    return {
        .identifier = "mdt",
        .name = "NT-MDT",
        .extensions = ".mdt",
        .description =
            "Nova software of NT-MDT: frames of scans, a channel each; integers of 16 bits, and arrays that describe themselves",
        .heights = "offset plus step times integer in the unit of the frame; no point is undefined",
        .orientation = "rows stored from the bottom, turned",
        .not_read =
            "spectra, curves and Raman arrays are listed; text and palettes are passed over; files with "
            "nothing else are refused",
        .reference =
            "nt-mdt module of Gwyddion, MDT reader of SurfaceTopography 1.27; not tested on an instrument "
            "file",
        .carries_scale = true,
        .detect = [](std::string_view head,
                     const bytes::Source&) { return head.starts_with(mdt_magic) ? Match::yes : Match::no; },
        .open = open_mdt};
}

}  // namespace setae::formats
