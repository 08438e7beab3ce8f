// SPDX-License-Identifier: GPL-3.0-or-later
#include "x3p_document.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/bytes/text.hpp"
#include "setae/bytes/xml_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"

namespace setae::formats {
namespace {

constexpr Index max_points_of_x3p = Index{1} << 31;

[[noreturn]] void broken_document(const bytes::Source& source, const std::string& what) {
    throw FormatError(source.name, {}, "X3P: " + what);
}

Sample sample_of(std::string_view type, const char* name, const bytes::Source& source) {
    if (type == "I") return Sample::int16;
    if (type == "L") return Sample::int32;
    if (type == "F") return Sample::float32;
    if (type == "D") return Sample::float64;
    broken_document(source, fmt::format("data type '{:.40}' of {}, expected I, L, F or D", type, name));
}

X3pAxis parse_axis(const pugi::xml_node& node, const char* name, const bytes::Source& source) {
    if (!node) broken_document(source, fmt::format("no <{}> among the axes", name));
    X3pAxis axis;
    const auto kind = trimmed(node.child_value("AxisType"));
    if (kind != "I" && kind != "A")
        broken_document(source, fmt::format("axis type '{:.40}' of {}, expected I or A", kind, name));
    axis.absolute = kind == "A";
    const auto type = trimmed(node.child_value("DataType"));
    if (axis.absolute || !type.empty()) axis.sample = sample_of(type, name, source);
    if (!trimmed(node.child_value("Increment")).empty())
        axis.increment = bytes::xml_number(node.child("Increment"), 1.0, source, "X3P");
    axis.offset = bytes::xml_number(node.child("Offset"), 0.0, source, "X3P");
    return axis;
}

Index extent(const pugi::xml_node& node, const char* name, const bytes::Source& source) {
    const auto text = trimmed(node.child_value());
    auto digits = text;
    const auto value = leading<Index>(digits).value_or(0);
    if (value < 1 || value > max_points_of_x3p)
        broken_document(source, fmt::format("<{}> is '{:.40}', expected a positive integer", name, text));
    return value;
}

/// A matrix has three extents, a list one; a profile is either, with a single row.
void parse_shape(const pugi::xml_node& record, X3pDocument& document, const bytes::Source& source) {
    if (const auto matrix = record.child("MatrixDimension")) {
        document.nx = extent(matrix.child("SizeX"), "SizeX", source);
        document.ny = extent(matrix.child("SizeY"), "SizeY", source);
        document.layers = extent(matrix.child("SizeZ"), "SizeZ", source);
    } else {
        document.nx = extent(record.child("ListDimension"), "ListDimension", source);
        if (!document.profile)
            broken_document(source, "the listed points form no matrix; expected a matrix for a surface");
    }
    if (document.profile && document.ny != 1)
        broken_document(source, fmt::format("a profile with SizeY {}, expected 1", document.ny));
}

std::string known(const pugi::xml_node& parent, const char* name) {
    std::string text(trimmed(parent.child_value(name)));
    return bytes::lowered(text) == x3p_not_available ? std::string{} : text;
}

topography::Metadata parse_metadata(const pugi::xml_node& record, const bytes::Source& source) {
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.format = "x3p";
    metadata.unit = "m";
    if (const auto date = known(record, "Date"); !date.starts_with(x3p_no_date)) metadata.acquisition_time = date;
    const auto instrument = record.child("Instrument"), probe = record.child("ProbingSystem");
    metadata.instrument.name = known(instrument, "Model");
    const auto keep = [&](const char* key, const std::string& value) {
        if (!value.empty()) metadata.attributes[key] = value;
    };
    keep("manufacturer", known(instrument, "Manufacturer"));
    keep("serial_number", known(instrument, "Serial"));
    keep("software_version", known(instrument, "Version"));
    keep("creator", known(record, "Creator"));
    keep("probing_system", known(probe, "Type"));
    keep("probe", known(probe, "Identification"));
    keep("comment", known(record, "Comment"));
    return metadata;
}

/// Such as "272F5FAF0A067C56A8EF08F98D96B187"; a shorter one cannot be compared.
std::string whole_checksum(const pugi::xml_node& link, const char* name) {
    const auto text = bytes::lowered(trimmed(link.child_value(name)));
    return text.size() == 32 ? text : std::string{};
}

pugi::xml_node find_root(const pugi::xml_document& xml) {
    for (const auto& node : xml.children())
        if (std::string_view(node.name()).ends_with("ISO5436_2")) return node;
    return {};
}

}  // namespace

X3pDocument parse_x3p_document(const pugi::xml_document& xml, const bytes::Source& source) {
    const auto root = find_root(xml);
    if (!root) broken_document(source, "main.xml has no ISO5436_2 document");
    X3pDocument document;
    const auto head = root.child("Record1"), data = root.child("Record3");
    const std::string feature(trimmed(head.child_value("FeatureType")));
    if (feature == "PCL")
        broken_document(source,
                        "a cloud of points (feature type PCL), expected a surface (SUR) or profile (PRF); interpolate "
                        "it on a grid in another program first");
    if (feature != "SUR" && feature != "PRF")
        broken_document(source, fmt::format("feature type '{:.40}', expected SUR (surface) or PRF (profile)", feature));
    document.profile = feature == "PRF";
    const auto axes = head.child("Axes");
    document.x = parse_axis(axes.child("CX"), "CX", source);
    document.z = parse_axis(axes.child("CZ"), "CZ", source);
    if (!document.profile) document.y = parse_axis(axes.child("CY"), "CY", source);
    if (!document.z.absolute) broken_document(source, "CZ is incremental, expected an absolute axis");
    parse_shape(data, document, source);
    document.metadata = parse_metadata(root.child("Record2"), source);
    const auto link = data.child("DataLink");
    document.point_member = trimmed(link.child_value("PointDataLink"));
    document.valid_member = trimmed(link.child_value("ValidPointsLink"));
    document.point_checksum = whole_checksum(link, "MD5ChecksumPointData");
    document.valid_checksum = whole_checksum(link, "MD5ChecksumValidPoints");
    document.checksum_member = trimmed(root.child("Record4").child_value("ChecksumFile"));
    document.list = data.child("DataList");
    if (document.point_member.empty() == document.list.empty())
        broken_document(source, "expected either a list of points or a link to them");
    const bool layered = document.layers > 1;
    if (layered && (!document.regular() || !document.list.empty()))
        broken_document(source,
                        fmt::format("{} layers of listed points or absolute axes, expected SizeZ 1", document.layers));
    return document;
}

}  // namespace setae::formats
