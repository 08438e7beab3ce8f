// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/bytes/digest.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/bytes/xml_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/topography/line_scans.hpp"
#include "storage/raster.hpp"
#include "x3p_document.hpp"
#include "x3p_writer.hpp"

// X3P (ISO 25178-72, formerly ISO 5436-2): a ZIP with main.xml and, unless the XML lists the points, a binary file.
// coordinate [m] = value · Increment + Offset; x is the fastest index; int16, int32, float32 or float64, little-endian.
namespace setae::formats {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Measurement;
using topography::Profile;

constexpr Index max_layers = 256;

[[noreturn]] void broken_archive(const bytes::Source& source, const std::string& what) {
    throw FormatError(source.name, {}, "X3P: " + what);
}

/// An archive and the folder of its main.xml, the base of links.
struct Package {
    const bytes::Archive& archive;
    std::string folder;

    [[nodiscard]] std::string member(const std::string& link) const {
        return archive.has(folder + link) ? folder + link : link;
    }
};

void require_checksum(const bytes::Source& member, const std::string& expected) {
    if (expected.empty()) return;
    const auto found = bytes::md5(member);
    if (found != expected)
        throw FormatError(
            member.name, {.offset = 0},
            fmt::format("X3P: the MD5 checksum is {}, but main.xml states {}; it is damaged", found, expected));
}

/// A member that must contain `count` values of `bytes` each.
bytes::Source required_member(const Package& package, const std::string& link, std::uint64_t count, std::uint64_t bytes,
                              const X3pDocument& document) {
    const auto member = package.archive.member(package.member(link));
    const bool fits = count <= std::numeric_limits<std::uint64_t>::max() / bytes && member.size == count * bytes;
    if (!fits)
        throw FormatError(member.name, {.offset = member.size},
                          fmt::format("X3P: {} has {} bytes, expected {} × {} × {} points of {} bytes", link,
                                      member.size, document.nx, document.ny, document.layers, bytes));
    return member;
}

std::uint64_t count_of(const X3pDocument& document, const bytes::Source& source) {
    const auto layer =
        static_cast<std::uint64_t>(document.nx) * static_cast<std::uint64_t>(document.ny);  // each at most 2^31
    if (document.layers > max_layers)
        broken_archive(source, fmt::format("{} layers, expected at most {}", document.layers, max_layers));
    if (layer > (std::uint64_t{1} << 53))
        broken_archive(source, fmt::format("{} × {} points, more than a file can contain", document.nx, document.ny));
    return layer * static_cast<std::uint64_t>(document.layers);
}

// ---- which points are valid: one bit a point, least significant first -----------------------------------------------

struct ValidPoints {
    bytes::Source bits;
    std::string checksum;
};

std::optional<ValidPoints> valid_points(const Package& package, const X3pDocument& document, std::uint64_t count) {
    if (document.valid_member.empty()) return std::nullopt;
    const auto member = package.archive.member(package.member(document.valid_member));
    if (member.size < (count + 7) / 8)
        throw FormatError(
            member.name, {.offset = member.size},
            fmt::format("X3P: the list of valid points has {} bytes for {} points; it is damaged", member.size, count));
    return ValidPoints{member, document.valid_checksum};
}

/// Calls undo(k) for every invalid point k = 0 … count − 1 after `first`.
template <class Undo>
void for_each_invalid(const ValidPoints& valid, std::uint64_t first, std::uint64_t count, Undo undo) {
    require_checksum(valid.bits, valid.checksum);
    const auto bits = valid.bits.bytes(first / 8, (first + count + 7) / 8 - first / 8);
    for (std::uint64_t k = 0; k < count; ++k) {
        const auto bit = first % 8 + k;
        if (((static_cast<unsigned char>(bits[bit / 8]) >> (bit % 8)) & 1u) == 0) undo(static_cast<Index>(k));
    }
}

// ---- points on a regular grid: rasters, read on request
// --------------------------------------------------------------

std::vector<double> regular_size(const X3pDocument& document) {
    if (!document.x.increment || (!document.profile && !document.y.increment)) return {};
    std::vector<double> size{std::abs(*document.x.increment) * static_cast<double>(document.nx)};
    if (!document.profile) size.push_back(std::abs(*document.y.increment) * static_cast<double>(document.ny));
    return size;
}

ChannelInfo channel_info(const X3pDocument& document, const std::string& name) {
    ChannelInfo info;
    info.name = name;
    info.format = "x3p";
    info.unit = "m";
    info.metadata = document.metadata;
    if (!document.profile) info.orientation = "rows from the top, as stored";
    return info;
}

Channel layer_channel(const X3pDocument& document, const Package& package, Index layer, const ReadOptions& options,
                      const bytes::Source& source) {
    const auto bytes = bytes_of(document.z.sample), count = count_of(document, source),
               points = count / static_cast<std::uint64_t>(document.layers);
    auto member = required_member(package, document.point_member, count, bytes, document);
    auto info = channel_info(document, document.layers > 1 ? fmt::format("height, layer {}", layer + 1) : "height");
    info.size = regular_size(document);
    const Raster raster{.offset = static_cast<std::uint64_t>(layer) * points * bytes,
                        .nx = document.nx,
                        .ny = document.ny,
                        .sample = document.z.sample};
    bytes::Source named = member;
    named.name = source.name;  // the measurement is that of the archive; the problem of the member was reported before
    auto channel = raster_channel(std::move(info), named, raster,
                                  {.factor = document.z.step(), .offset = document.z.offset}, options);
    if (channel.info.size.empty()) return channel;
    const auto valid = valid_points(package, document, count);
    read_as_a_whole(channel, [read = channel.read, member, valid, checksum = document.point_checksum,
                              first = static_cast<std::uint64_t>(layer) * points, points, named] {
        require_checksum(member, checksum);
        auto measurement = read();
        if (!valid) return measurement;
        std::visit(
            [&](auto& m) {
                const auto nx = m.heights.rows();
                for_each_invalid(*valid, first, points, [&](Index k) { m.heights(k % nx, k / nx) = undefined; });
            },
            measurement);
        return checked(std::move(measurement), named);
    });
    return channel;
}

// ---- points with their own x and y, or listed in the XML ------------------------------------------------------------

/// Coordinates of the points in file order, x fastest; empty for incremental axes.
struct Points {
    std::vector<double> x, y, z;
};

std::vector<std::pair<const X3pAxis*, std::vector<double>*>> stored_axes(const X3pDocument& document, Points& points) {
    std::vector<std::pair<const X3pAxis*, std::vector<double>*>> stored;
    if (document.x.absolute) stored.emplace_back(&document.x, &points.x);
    if (!document.profile && document.y.absolute) stored.emplace_back(&document.y, &points.y);
    stored.emplace_back(&document.z, &points.z);
    return stored;
}

Points binary_points(const X3pDocument& document, const Package& package, const bytes::Source& source) {
    Points points;
    const auto stored = stored_axes(document, points);
    std::uint64_t stride = 0;
    for (const auto& [axis, values] : stored) stride += bytes_of(axis->sample);
    const auto count = count_of(document, source);
    const auto member = required_member(package, document.point_member, count, stride, document);
    require_checksum(member, document.point_checksum);
    const auto data = member.all();
    for (const auto& [axis, values] : stored) values->reserve(count);
    for (const char* at = data.data(); at != data.data() + data.size();)
        for (const auto& [axis, values] : stored) {
            values->push_back(loaded(at, axis->sample, std::endian::little) * axis->step() + axis->offset);
            at += bytes_of(axis->sample);
        }
    if (const auto valid = valid_points(package, document, count))
        for_each_invalid(*valid, 0, count, [&](Index k) { points.z[static_cast<std::size_t>(k)] = undefined; });
    return points;
}

/// <Datum>x;y;z</Datum> with the coordinates of absolute axes only; an empty element is an undefined point.
Points listed_points(const X3pDocument& document, const bytes::Source& source) {
    Points points;
    const auto stored = stored_axes(document, points);
    std::uint64_t count = 0;
    std::vector<std::string_view> cells;
    for (const auto datum : document.list.children("Datum")) {
        tables::split_cells(datum.child_value(), ';', cells);
        const bool empty = trimmed(datum.child_value()).empty();
        if (!empty && cells.size() != stored.size())
            broken_archive(source, fmt::format("point {} has {} coordinates, expected {}", count + 1, cells.size(),
                                               stored.size()));
        for (std::size_t k = 0; k < stored.size(); ++k) {
            double value = undefined;
            if (!empty && !bytes::parse_cell(cells[k], '.', value))
                broken_archive(source, fmt::format("'{:.40}' of point {} is not a number", cells[k], count + 1));
            stored[k].second->push_back(value * stored[k].first->step() + stored[k].first->offset);
        }
        ++count;
    }
    if (count != count_of(document, source))
        broken_archive(source, fmt::format("{} points listed, expected {} × {}; the file is truncated", count,
                                           document.nx, document.ny));
    return points;
}

/// Step of an absolute axis whose values are on a regular grid within 2 % of a step; index(i) is the place of point i
/// on it.
template <class GridIndex>
double grid_step(const std::vector<double>& values, Index n, const char* axis, const bytes::Source& source,
                 GridIndex index) {
    double first = undefined, last = undefined;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (index(static_cast<Index>(i)) == 0 && std::isnan(first)) first = values[i];
        if (index(static_cast<Index>(i)) == n - 1 && std::isnan(last)) last = values[i];
    }
    const double step = (last - first) / static_cast<double>(std::max<Index>(n - 1, 1));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double stray = values[i] - first - static_cast<double>(index(static_cast<Index>(i))) * step;
        if (!std::isnan(values[i]) && !(std::abs(stray) <= 0.02 * std::abs(step)))
            broken_archive(source, fmt::format("the absolute {} axis is not a regular grid at point {}", axis, i + 1));
    }
    return step;
}

/// Length of one step along an axis. @throws FormatError if neither increment nor positions give it.
template <class GridIndex>
double step_of(const X3pAxis& axis, const std::vector<double>& values, Index n, const char* name,
               const bytes::Source& source, GridIndex index) {
    if (axis.absolute) return grid_step(values, n, name, source, index);
    if (!axis.increment)
        broken_archive(
            source, fmt::format("the {} axis has no <Increment>, and a size cannot be given for listed points", name));
    return std::abs(*axis.increment);
}

Measurement to_map(const X3pDocument& document, const Points& points, const bytes::Source& source) {
    const auto nx = document.nx, ny = document.ny;
    const double dx = step_of(document.x, points.x, nx, "x", source, [nx](Index i) { return i % nx; });
    const double dy = step_of(document.y, points.y, ny, "y", source, [nx](Index i) { return i / nx; });
    HeightMap map{
        Array2D(nx, ny), {dx * static_cast<double>(nx), dy * static_cast<double>(ny)}, false, document.metadata};
    for (Index j = 0; j < ny; ++j)
        for (Index i = 0; i < nx; ++i) map.heights(i, j) = points.z[static_cast<std::size_t>(j * nx + i)];
    return checked(std::move(map), source);
}

Measurement to_line(const X3pDocument& document, const Points& points, const bytes::Source& source) {
    const Array1D heights = Eigen::Map<const Array1D>(points.z.data(), document.nx);
    if (!document.x.absolute) {
        const double step = step_of(document.x, points.x, document.nx, "x", source, [](Index i) { return i; });
        return checked(LineScan{heights, step * static_cast<double>(document.nx), false, document.metadata}, source);
    }
    Profile profile{Eigen::Map<const Array1D>(points.x.data(), document.nx), heights, document.metadata};
    if (auto scan = topography::to_line_scan(profile)) return checked(std::move(*scan), source);
    return checked(std::move(profile), source);
}

Channel points_channel(const X3pDocument& document, const Points& points, const bytes::Source& source) {
    return loaded_channel(channel_info(document, "height"),
                          document.profile ? to_line(document, points, source) : to_map(document, points, source));
}

// ---- documents and archives -----------------------------------------------------------------------------------------

/// The checksum of main.xml protects a text that users edit: a difference is a warning, no error.
std::vector<Alert> check_document(const Package& package, const std::string& xml, const X3pDocument& document,
                                  const bytes::Source& source) {
    const auto name = package.member(document.checksum_member);
    if (document.checksum_member.empty() || !package.archive.has(name)) return {};
    const auto expected = bytes::lowered(package.archive.head(name, 32));
    const bool whole = expected.size() == 32 && expected.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!whole || bytes::md5(xml) == expected) return {};
    return {{"CHECKSUM", source.name, "main.xml was changed after its checksum was written",
             "check the increments and offsets of the axes"}};
}

/// Each listed point takes some bytes of its file; smaller elements are intended to fill the memory.
void require_plausible_list(const std::string& xml, const bytes::Source& source) {
    const auto tags = static_cast<std::uint64_t>(std::count(xml.begin(), xml.end(), '<'));
    constexpr std::uint64_t always = 1'000'000;
    if (tags > always + source.size)
        broken_archive(
            source,
            fmt::format(
                "main.xml has {} tags in a file of {} bytes; if you trust the file, save the points as a binary "
                "member",
                tags, source.size));
}

std::vector<Channel> open_xml(const std::string& xml, const Package* package, const ReadOptions& options,
                              const bytes::Source& source) {
    require_plausible_list(xml, source);
    const auto tree = bytes::parsed_xml(xml, source, "X3P: main.xml");
    const auto document = parse_x3p_document(tree, source);
    std::vector<Channel> channels;
    if (!document.list.empty()) {
        channels.push_back(points_channel(document, listed_points(document, source), source));
    } else if (!package) {
        broken_archive(source, fmt::format("the points are in {}; open the archive instead of its main.xml",
                                           document.point_member));
    } else if (!document.regular()) {
        channels.push_back(points_channel(document, binary_points(document, *package, source), source));
    } else {
        (void)count_of(document, source);
        for (Index layer = 0; layer < document.layers; ++layer)
            channels.push_back(layer_channel(document, *package, layer, options, source));
    }
    if (package)
        for (auto& channel : channels)
            for (auto& alert : check_document(*package, xml, document, source))
                channel.info.alerts.push_back(std::move(alert));
    return channels;
}

constexpr std::string_view document_member = "main.xml", nested_ending = ".x3p";

/// main.xml of an archive: its own, or those in its folders.
std::vector<std::string> documents(const bytes::Archive& archive) {
    if (archive.has(std::string(document_member))) return {std::string(document_member)};
    std::vector<std::string> found;
    for (auto& name : archive.names())
        if (name.ends_with(fmt::format("/{}", document_member))) found.push_back(std::move(name));
    return found;
}

std::vector<std::string> nested_archives(const bytes::Archive& archive) {
    std::vector<std::string> found;
    for (auto& name : archive.names())
        if (bytes::lowered(name).ends_with(nested_ending)) found.push_back(std::move(name));
    return found;
}

std::vector<Channel> open_documents(const bytes::Source& source, const bytes::Archive& archive,
                                    const ReadOptions& options) {
    std::vector<Channel> channels;
    for (const auto& name : documents(archive)) {
        const Package package{archive, name.substr(0, name.size() - document_member.size())};
        for (auto& channel : open_xml(archive.read(name), &package, options, source)) {
            if (!package.folder.empty()) channel.info.name = package.folder + channel.info.name;
            channels.push_back(std::move(channel));
        }
    }
    return channels;
}

std::vector<Channel> open_nested(const bytes::Source& source, const std::string& name, const ReadOptions& options) {
    const auto member = bytes::Archive(source).member(name);
    const bytes::Archive inner(member);
    auto channels = open_documents(member, inner, options);
    if (channels.empty()) broken_archive(member, "the archive has no main.xml, which an X3P file needs");
    return channels;
}

/// Channels of an archive in the archive. It is not kept in memory: reading expands it again.
std::vector<Channel> nested_channels(const bytes::Source& source, const std::string& name, const ReadOptions& options) {
    try {
        auto channels = open_nested(source, name, options);
        for (std::size_t k = 0; k < channels.size(); ++k) {
            channels[k].info.name = name + ": " + channels[k].info.name;
            read_as_a_whole(channels[k],
                            [source, name, options, k] { return open_nested(source, name, options).at(k).read(); });
        }
        return channels;
    } catch (const Error& error) {
        return {unreadable_member(source, name, error.what())};
    }
}

Match detect_x3p(std::string_view head, const bytes::Source& source) {
    if (bytes::is_zip(head)) {
        const bytes::Archive archive(source);
        if (archive.has(std::string(document_member)) || !nested_archives(archive).empty()) return Match::yes;
        return documents(archive).empty() ? Match::no : Match::maybe;
    }
    const bool xml = head.find("<?xml") < 8;
    return xml && head.find("ISO5436_2") != std::string_view::npos ? Match::yes : Match::no;
}

std::vector<Channel> open_x3p(const bytes::Source& source, const ReadOptions& options) {
    if (!bytes::is_zip(source.head(4))) return open_xml(source.all(), nullptr, options, source);
    const bytes::Archive archive(source);
    auto channels = open_documents(source, archive, options);
    for (const auto& name : nested_archives(archive))
        for (auto& channel : nested_channels(source, name, options)) channels.push_back(std::move(channel));
    return channels;
}

}  // namespace

Format x3p_format() {
    return {
        .identifier = "x3p",
        .name = "X3P",
        .extensions = ".x3p",
        .description =
            "ZIP with main.xml and binary or listed points of a surface or profile, a single main.xml, or a "
            "ZIP of several such archives; checksums are verified",
        .heights =
            "value times increment plus offset of the axis, in metres; signed int16 or int32, float32 or float64; points marked invalid or NaN are undefined",
        .orientation = "first point at the top left, x the fastest index",
        .not_read = "clouds of points (feature type PCL) and lists that form no matrix are refused",
        .reference = "ISO 25178-72:2017 (formerly ISO 5436-2)",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = detect_x3p,
        .open = open_x3p,
        .write = write_x3p};
}

}  // namespace setae::formats
