// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pugixml.hpp>

#include <optional>
#include <string>

#include "setae/bytes/source.hpp"
#include "setae/topography/measurement.hpp"
#include "storage/raster.hpp"

namespace setae::formats {

/// An axis of an X3P document: coordinate [m] = value · increment + offset.
struct X3pAxis {
    bool absolute = false;            ///< its values are among the points; otherwise value = index
    Sample sample = Sample::float64;  ///< of stored values
    std::optional<double> increment;
    double offset = 0.0;

    [[nodiscard]] double step() const { return increment.value_or(1.0); }
};

/// Content of main.xml.
struct X3pDocument {
    bool profile = false;
    X3pAxis x, y, z;
    Index nx = 0, ny = 1, layers = 1;
    topography::Metadata metadata;
    std::string point_member, valid_member;      ///< names in the archive, or empty
    std::string point_checksum, valid_checksum;  ///< MD5 in lower case, or empty if missing or incomplete
    std::string checksum_member;                 ///< contains the MD5 of main.xml
    pugi::xml_node list;                         ///< <DataList>, if points are listed

    [[nodiscard]] bool regular() const { return !x.absolute && !y.absolute; }
};

/// The document of a tree, which must outlive it.
/// @throws FormatError "X3P: …" for missing content and for anything but a surface or profile.
[[nodiscard]] X3pDocument parse_x3p_document(const pugi::xml_document& xml, const bytes::Source& source);

/// Text in main.xml for unknown entries.
inline constexpr const char* x3p_not_available = "not available";
/// Begin of the time that MountainsMap writes for measurements without a date; the date is mandatory.
inline constexpr const char* x3p_no_date = "1970-01-01";

}  // namespace setae::formats
