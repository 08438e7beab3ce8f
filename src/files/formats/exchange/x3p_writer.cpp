// SPDX-License-Identifier: GPL-3.0-or-later
#include "x3p_writer.hpp"

#include <pugixml.hpp>

#include <limits>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "setae/bytes/archive_writer.hpp"
#include "setae/bytes/digest.hpp"
#include "setae/bytes/source.hpp"
#include "writing.hpp"
#include "x3p_document.hpp"

namespace setae::formats {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Metadata;
using topography::Profile;

constexpr double x3p_not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr const char* point_member = "bindata/data.bin";
constexpr const char* checksum_member = "md5checksum.hex";
constexpr const char* opengps = "http://www.opengps.eu/2008/ISO5436_2";

/// Axes, extents and points in the layout of the format.
struct WrittenContent {
    const char* feature = "SUR";
    double step_x = 0.0, step_y = 0.0;  ///< [m]; a step 0 is that of an absolute axis
    Index nx = 0, ny = 1;
    std::string points;
};

std::string bytes_of_line(const Array1D& heights) {
    return row_bytes(Eigen::Map<const Array2D>(heights.data(), heights.size(), 1), x3p_not_a_number);
}

WrittenContent content_of(const HeightMap& map) {
    return {"SUR",
            map.pixel_size()[0],
            map.pixel_size()[1],
            map.heights.rows(),
            map.heights.cols(),
            row_bytes(map.heights, x3p_not_a_number)};
}

WrittenContent content_of(const LineScan& scan) {
    return {"PRF", scan.pixel_size(), 1.0, scan.heights.size(), 1, bytes_of_line(scan.heights)};
}

/// Pairs of position and height.
WrittenContent content_of(const Profile& profile) {
    Array1D pairs(2 * profile.heights.size());
    for (Index i = 0; i < profile.heights.size(); ++i) {
        pairs[2 * i] = profile.positions[i];
        pairs[2 * i + 1] = profile.heights[i];
    }
    return {"PRF", 0.0, 1.0, profile.heights.size(), 1, bytes_of_line(pairs)};
}

void add(pugi::xml_node parent, const char* name, const std::string& text) {
    parent.append_child(name).text().set(text.c_str());
}

void add_axis(pugi::xml_node axes, const char* name, double step) {
    auto axis = axes.append_child(name);
    add(axis, "AxisType", step > 0.0 ? "I" : "A");
    add(axis, "DataType", "D");
    add(axis, "Increment", fmt::format("{}", step > 0.0 ? step : 1.0));
    add(axis, "Offset", "0");
}

std::string or_not_available(const std::string& text) { return text.empty() ? x3p_not_available : text; }

std::string attribute(const Metadata& metadata, const char* key) {
    const auto found = metadata.attributes.find(key);
    return found == metadata.attributes.end() ? std::string{} : found->second;
}

/// As xsd:dateTime.
std::string date_of(const Metadata& metadata) {
    const auto time = written_time(metadata.acquisition_time);
    if (!time.known()) return fmt::format("{}T00:00:00", x3p_no_date);
    return fmt::format("{}-{}-{}T{}:{}:{}{}", time.year, time.month, time.day, time.hour, time.minute, time.second,
                       time.zone);
}

/// Contacting, NonContacting or Software, as in the schema.
std::string probing_system(const Metadata& metadata) {
    const auto read = attribute(metadata, "probing_system");
    if (read == "Contacting" || read == "NonContacting" || read == "Software") return read;
    const auto& type = metadata.instrument.type;
    if (type == "stylus" || type == "afm") return "Contacting";
    return type.empty() ? "Software" : "NonContacting";
}

void add_measurement(pugi::xml_node root, const Metadata& metadata) {
    auto record = root.append_child("Record2");
    add(record, "Date", date_of(metadata));
    if (const auto creator = attribute(metadata, "creator"); !creator.empty()) add(record, "Creator", creator);
    auto instrument = record.append_child("Instrument");
    add(instrument, "Manufacturer", or_not_available(attribute(metadata, "manufacturer")));
    add(instrument, "Model", or_not_available(metadata.instrument.name));
    add(instrument, "Serial", or_not_available(attribute(metadata, "serial_number")));
    add(instrument, "Version", or_not_available(attribute(metadata, "software_version")));
    add(record, "CalibrationDate", date_of(metadata));
    auto probe = record.append_child("ProbingSystem");
    add(probe, "Type", probing_system(metadata));
    add(probe, "Identification", or_not_available(attribute(metadata, "probe")));
    const bool odd_time = !metadata.acquisition_time.empty() && !written_time(metadata.acquisition_time).known();
    auto comment = attribute(metadata, "comment");
    if (odd_time) comment += fmt::format("{}measured {}", comment.empty() ? "" : "; ", metadata.acquisition_time);
    if (!comment.empty()) add(record, "Comment", comment);
}

std::string document_of(const WrittenContent& content, const Metadata& metadata) {
    pugi::xml_document xml;
    auto declaration = xml.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    auto root = xml.append_child("p:ISO5436_2");
    root.append_attribute("xmlns:p") = opengps;
    root.append_attribute("xmlns:xsi") = "http://www.w3.org/2001/XMLSchema-instance";
    root.append_attribute("xsi:schemaLocation") = fmt::format("{0} {0}/ISO5436_2.xsd", opengps).c_str();
    auto head = root.append_child("Record1");
    add(head, "Revision", "ISO5436 - 2000");
    add(head, "FeatureType", content.feature);
    auto axes = head.append_child("Axes");
    add_axis(axes, "CX", content.step_x);
    add_axis(axes, "CY", content.step_y);
    add_axis(axes, "CZ", 0.0);
    add_measurement(root, metadata);
    auto data = root.append_child("Record3");
    auto matrix = data.append_child("MatrixDimension");
    add(matrix, "SizeX", fmt::format("{}", content.nx));
    add(matrix, "SizeY", fmt::format("{}", content.ny));
    add(matrix, "SizeZ", "1");
    auto link = data.append_child("DataLink");
    add(link, "PointDataLink", point_member);
    add(link, "MD5ChecksumPointData", bytes::md5(content.points));
    add(root.append_child("Record4"), "ChecksumFile", checksum_member);
    std::ostringstream text;
    xml.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
    return text.str();
}

}  // namespace

void write_x3p(const std::string& path, const topography::Measurement& measurement) {
    refuse_trace(measurement, path);
    auto content = std::visit([](const auto& m) { return content_of(m); }, measurement);
    const auto document = document_of(content, topography::metadata(measurement));
    const auto checksum = fmt::format("{} *main.xml\n", bytes::md5(document));
    // stored: deflate takes ten times as long as everything else and leaves 96 % of measured float64
    bytes::write_archive(path, {{"main.xml", [&] { return bytes::memory_source(path, document); }},
                                {point_member, [&] { return bytes::memory_source(path, std::move(content.points)); }},
                                {checksum_member, [&] { return bytes::memory_source(path, checksum); }}});
}

}  // namespace setae::formats
