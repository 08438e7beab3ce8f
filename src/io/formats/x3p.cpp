// SPDX-License-Identifier: GPL-3.0-or-later
#include <pugixml.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "archive.hpp"
#include "bytes.hpp"
#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/io/digest.hpp"
#include "setae/topography/line_scans.hpp"
#include "text.hpp"
#include "xml_file.hpp"

// X3P (ISO 25178-72, formerly ISO 5436-2): a ZIP with main.xml and, unless the XML lists the points itself, a binary file.
// coordinate [m] = value · Increment + Offset; x is the fastest index; int16, int32, float32 or float64, little-endian.
namespace setae::io {
namespace {

[[noreturn]] void broken(const Source& source, const std::string& what) { throw FormatError(source.name, {}, "X3P: " + what); }

/// Number in an element's text, or the default where the element is missing or empty.
double number(const pugi::xml_node& node, double fallback, const Source& source) {
    const auto text = trimmed(node.child_value());
    if (text.empty()) return fallback;
    double value = 0.0;
    if (!parse_cell(text, '.', value) || !std::isfinite(value))
        broken(source, fmt::format("'{:.40}' in <{}> is no number", text, node.name()));
    return value;
}

struct Axis {
    bool absolute = false;  ///< its values stand among the points; else value = index
    char type = 'D';        ///< I int16, L int32, F float32, D float64
    double increment = 1.0;
    double offset = 0.0;

    [[nodiscard]] std::size_t bytes() const { return type == 'I' ? 2 : type == 'D' ? 8 : 4; }
};

Axis parse_axis(const pugi::xml_node& node, const char* name, const Source& source) {
    if (!node) broken(source, fmt::format("no <{}> among the axes", name));
    Axis axis;
    const auto kind = trimmed(node.child_value("AxisType")), type = trimmed(node.child_value("DataType"));
    if (kind != "I" && kind != "A") broken(source, fmt::format("axis type '{:.40}' of {}, expected I or A", kind, name));
    axis.absolute = kind == "A";
    if (type.size() != 1 || std::string_view("ILFD").find(type) == std::string_view::npos)
        broken(source, fmt::format("data type '{:.40}' of {}, expected I, L, F or D", type, name));
    axis.type = type[0];
    axis.increment = number(node.child("Increment"), 1.0, source);
    axis.offset = number(node.child("Offset"), 0.0, source);
    return axis;
}

/// What main.xml says, checked against the size of what holds the points.
struct Document {
    bool profile = false;
    Axis x, y, z;
    Index nx = 0, ny = 0;
    topography::Metadata metadata;
    std::string point_member, valid_member;
    std::string point_checksum, valid_checksum;

    [[nodiscard]] Index points() const { return nx * ny; }
};

Index extent(const pugi::xml_node& node, const Source& source) {
    const auto text = trimmed(node.child_value());
    Index value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || value < 1 || value > (Index{1} << 31))
        broken(source, fmt::format("<{}> is '{:.40}', expected a positive integer", node.name(), text));
    return value;
}

/// A matrix has three extents, a list one; a profile is either, with a single row.
void parse_shape(const pugi::xml_node& record, Document& document, const Source& source) {
    if (const auto matrix = record.child("MatrixDimension")) {
        document.nx = extent(matrix.child("SizeX"), source);
        document.ny = extent(matrix.child("SizeY"), source);
        if (extent(matrix.child("SizeZ"), source) != 1) broken(source, "several layers, expected SizeZ 1");
    } else {
        document.nx = extent(record.child("ListDimension"), source);
        document.ny = 1;
        if (!document.profile) broken(source, "a list of points that form no matrix; surfaces are read as matrices");
    }
    if (document.profile && document.ny != 1) broken(source, fmt::format("a profile with SizeY {}, expected 1", document.ny));
}

topography::Metadata parse_metadata(const pugi::xml_node& record, const Source& source) {
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.format = "x3p";
    metadata.unit = "m";
    metadata.acquisition_time = trimmed(record.child_value("Date"));
    const auto instrument = record.child("Instrument");
    metadata.instrument.name = trimmed(instrument.child_value("Model"));
    metadata.attributes["manufacturer"] = trimmed(instrument.child_value("Manufacturer"));
    metadata.attributes["software_version"] = trimmed(instrument.child_value("Version"));
    metadata.attributes["comment"] = trimmed(record.child_value("Comment"));
    return metadata;
}

Document parse_document(const pugi::xml_node& root, const Source& source) {
    Document document;
    const auto head = root.child("Record1"), data = root.child("Record3");
    const std::string feature(trimmed(head.child_value("FeatureType")));
    if (feature != "SUR" && feature != "PRF")
        broken(source, fmt::format("feature type '{:.40}', expected SUR (surface) or PRF (profile)", feature));
    document.profile = feature == "PRF";
    const auto axes = head.child("Axes");
    document.x = parse_axis(axes.child("CX"), "CX", source);
    document.z = parse_axis(axes.child("CZ"), "CZ", source);
    if (!document.profile) document.y = parse_axis(axes.child("CY"), "CY", source);
    if (!document.z.absolute) broken(source, "CZ is incremental, expected an absolute axis");
    parse_shape(data, document, source);
    document.metadata = parse_metadata(root.child("Record2"), source);
    const auto link = data.child("DataLink");
    document.point_member = trimmed(link.child_value("PointDataLink"));
    document.valid_member = trimmed(link.child_value("ValidPointsLink"));
    document.point_checksum = lowered(trimmed(link.child_value("MD5ChecksumPointData")));
    document.valid_checksum = lowered(trimmed(link.child_value("MD5ChecksumValidPoints")));
    return document;
}

pugi::xml_node find_root(const pugi::xml_document& xml) {
    for (const auto& node : xml.children())
        if (std::string_view(node.name()).ends_with("ISO5436_2")) return node;
    return {};
}

/// Coordinates of the points in file order, x fastest; empty for incremental axes.
struct Points {
    std::vector<double> x, y, z;
};

std::vector<std::pair<const Axis*, std::vector<double>*>> stored_axes(const Document& document, Points& points) {
    std::vector<std::pair<const Axis*, std::vector<double>*>> stored;
    if (document.x.absolute) stored.emplace_back(&document.x, &points.x);
    if (!document.profile && document.y.absolute) stored.emplace_back(&document.y, &points.y);
    stored.emplace_back(&document.z, &points.z);
    return stored;
}

double load_value(const char* from, char type) {
    constexpr auto order = std::endian::little;
    switch (type) {
        case 'I': return load<std::int16_t>(from, order);
        case 'L': return load<std::int32_t>(from, order);
        case 'F': return static_cast<double>(load<float>(from, order));
        default: return load<double>(from, order);
    }
}

Points binary_points(const Document& document, const std::string& data, const Source& source) {
    Points points;
    const auto stored = stored_axes(document, points);
    std::size_t stride = 0;
    for (const auto& [axis, values] : stored) stride += axis->bytes();
    const auto count = static_cast<std::uint64_t>(document.points());
    if (count > data.size() / stride || data.size() != count * stride)
        broken(source, fmt::format("{} holds {} bytes, expected {} × {} points of {} bytes", document.point_member, data.size(), document.nx, document.ny, stride));
    for (const auto& [axis, values] : stored) values->reserve(count);
    for (const char* at = data.data(); at != data.data() + data.size();)
        for (const auto& [axis, values] : stored) {
            values->push_back(load_value(at, axis->type) * axis->increment + axis->offset);
            at += axis->bytes();
        }
    return points;
}

/// <Datum>x;y;z</Datum> with the coordinates of absolute axes only; an empty element is an undefined point.
Points listed_points(const Document& document, const pugi::xml_node& list, const Source& source) {
    Points points;
    const auto stored = stored_axes(document, points);
    Index count = 0;
    std::vector<std::string_view> cells;
    for (const auto datum : list.children("Datum")) {
        split_cells(datum.child_value(), ';', cells);
        const bool empty = trimmed(datum.child_value()).empty();
        if (!empty && cells.size() != stored.size())
            broken(source, fmt::format("point {} has {} coordinates, expected {}", count + 1, cells.size(), stored.size()));
        for (std::size_t k = 0; k < stored.size(); ++k) {
            double value = undefined;
            if (!empty && !parse_cell(cells[k], '.', value))
                broken(source, fmt::format("'{:.40}' of point {} is no number", cells[k], count + 1));
            stored[k].second->push_back(value * stored[k].first->increment + stored[k].first->offset);
        }
        ++count;
    }
    if (count != document.points())
        broken(source, fmt::format("{} points listed, expected {} × {}; the file is truncated", count, document.nx, document.ny));
    return points;
}

/// One bit a point, least significant first; 0 = undefined.
void apply_valid_points(std::vector<double>& heights, const std::string& bits, const Source& source) {
    if (bits.size() < (heights.size() + 7) / 8)
        broken(source, fmt::format("the list of valid points has {} bytes for {} points", bits.size(), heights.size()));
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (((static_cast<unsigned char>(bits[i / 8]) >> (i % 8)) & 1u) == 0) heights[i] = undefined;
}

/// Step of an absolute axis whose values lie on a regular grid within 2 % of a step; index(i) is point i's place on it.
template <class GridIndex>
double grid_step(const std::vector<double>& values, Index n, const char* axis, const Source& source, GridIndex index) {
    double first = undefined, last = undefined;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (index(static_cast<Index>(i)) == 0 && std::isnan(first)) first = values[i];
        if (index(static_cast<Index>(i)) == n - 1 && std::isnan(last)) last = values[i];
    }
    const double step = (last - first) / static_cast<double>(std::max<Index>(n - 1, 1));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double stray = values[i] - first - static_cast<double>(index(static_cast<Index>(i))) * step;
        if (!std::isnan(values[i]) && !(std::abs(stray) <= 0.02 * std::abs(step)))
            broken(source, fmt::format("absolute {} axis is no regular grid at point {}", axis, i + 1));
    }
    return step;
}

topography::Measurement to_map(const Document& document, const Points& points, const Source& source) {
    const auto nx = document.nx, ny = document.ny;
    const double dx = document.x.absolute ? grid_step(points.x, nx, "x", source, [nx](Index i) { return i % nx; }) : document.x.increment;
    const double dy = document.y.absolute ? grid_step(points.y, ny, "y", source, [nx](Index i) { return i / nx; }) : document.y.increment;
    topography::HeightMap map{Array2D(nx, ny), {dx * static_cast<double>(nx), dy * static_cast<double>(ny)}, false, document.metadata};
    for (Index j = 0; j < ny; ++j)
        for (Index i = 0; i < nx; ++i) map.heights(i, j) = points.z[static_cast<std::size_t>(j * nx + i)];
    return checked(std::move(map), source);
}

topography::Measurement to_line(const Document& document, const Points& points, const Source& source) {
    const Array1D heights = Eigen::Map<const Array1D>(points.z.data(), document.nx);
    if (!document.x.absolute)
        return checked(topography::LineScan{heights, document.x.increment * static_cast<double>(document.nx), false, document.metadata}, source);
    topography::Profile profile{Eigen::Map<const Array1D>(points.x.data(), document.nx), heights, document.metadata};
    if (auto scan = topography::to_line_scan(profile)) return checked(std::move(*scan), source);
    return checked(std::move(profile), source);
}

Channel to_channel(const Document& document, const Points& points, std::vector<Alert> alerts, const Source& source) {
    ChannelInfo info;
    info.name = "height";
    info.format = "x3p";
    info.unit = "m";
    if (!document.profile) info.orientation = "rows from the top, as stored";
    info.alerts = std::move(alerts);
    return loaded_channel(std::move(info), document.profile ? to_line(document, points, source) : to_map(document, points, source));
}

void require_checksum(const std::string& content, const std::string& expected, const std::string& member, const Source& source) {
    if (!expected.empty() && md5(content) != expected)
        broken(source, fmt::format("{} has the MD5 checksum {}, the file says {}; it is damaged", member, md5(content), expected));
}

/// The checksum of main.xml guards a text people edit: a difference is worth an alert, no refusal.
std::vector<Alert> check_document(const Archive& archive, const std::string& xml, const std::string& checksum_member, const Source& source) {
    if (checksum_member.empty() || !archive.has(checksum_member)) return {};
    const auto expected = lowered(archive.read(checksum_member).substr(0, 32));
    if (md5(xml) == expected) return {};
    return {{"CHECKSUM", source.name, "main.xml was changed after its checksum was written", "make sure of increments and offsets"}};
}

std::vector<Channel> open_xml(const std::string& xml, const Archive* archive, const Source& source) {
    const auto tree = parsed_xml(xml, source, "X3P: main.xml");
    const auto root = find_root(tree);
    if (!root) broken(source, "main.xml holds no ISO5436_2 document");
    const auto document = parse_document(root, source);
    const auto list = root.child("Record3").child("DataList");
    if (document.point_member.empty() == list.empty()) broken(source, "expected either a list of points or a link to them");
    if (!list.empty()) return {to_channel(document, listed_points(document, list, source), {}, source)};
    if (!archive) broken(source, fmt::format("the points stand in {}; open the archive instead of its main.xml", document.point_member));
    const auto data = archive->read(document.point_member);
    require_checksum(data, document.point_checksum, document.point_member, source);
    auto points = binary_points(document, data, source);
    if (!document.valid_member.empty()) {
        const auto valid = archive->read(document.valid_member);
        require_checksum(valid, document.valid_checksum, document.valid_member, source);
        apply_valid_points(points.z, valid, source);
    }
    const auto checksum_member = std::string(trimmed(root.child("Record4").child_value("ChecksumFile")));
    return {to_channel(document, points, check_document(*archive, xml, checksum_member, source), source)};
}

constexpr const char* document_member = "main.xml";

Match detect_x3p(std::string_view head, const Source& source) {
    if (is_zip(head)) return Archive(source).has(document_member) ? Match::yes : Match::no;
    const bool xml = head.find("<?xml") < 8;
    return xml && head.find("ISO5436_2") != std::string_view::npos ? Match::yes : Match::no;
}

std::vector<Channel> open_x3p(const Source& source, const ReadOptions&) {
    if (!is_zip(source.head(4))) return open_xml(source.all(), nullptr, source);
    const Archive archive(source);
    return open_xml(archive.read(document_member), &archive, source);
}

}  // namespace

Format x3p_format() {
    return {.identifier = "x3p",
            .name = "X3P",
            .extensions = ".x3p .xml",
            .description = "ZIP with main.xml and binary or listed points of a surface or profile; checksums are verified",
            .heights = "value times increment plus offset of the axis, in metres; int16, int32, float32 or float64; points marked invalid or NaN are undefined",
            .orientation = "first point at the top left, x the fastest index",
            .reference = "ISO 25178-72:2017 (formerly ISO 5436-2)",
            .tested_on_real_files = true,
            .carries_scale = true,
            .detect = detect_x3p,
            .open = open_x3p};
}

}  // namespace setae::io
