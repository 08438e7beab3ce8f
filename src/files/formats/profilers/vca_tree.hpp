// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/cursor.hpp"
#include "setae/core/arrays.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/channel.hpp"

/// The tree of named and typed entries in OPDx files of Bruker's Vision64, and in parts of newer OPD files.
namespace setae::formats {

enum class VcaType : std::uint8_t {
    matrix = 0x00,
    boolean = 0x01,
    int16 = 0x04,
    uint16 = 0x05,
    int32 = 0x06,
    uint32 = 0x07,
    int64 = 0x0a,
    uint64 = 0x0b,
    float32 = 0x0c,
    float64 = 0x0d,
    type_identifier = 0x0e,
    string = 0x12,
    quantity = 0x13,
    time_stamp = 0x15,
    units = 0x18,
    array = 0x40,
    string_list = 0x42,
    anonymous_matrix = 0x45,
    line_data = 0x46,
    map_data = 0x47,
    positions = 0x7c,
    container = 0x7d,
    terminator = 0x7f,
};

/// An entry. Elements of arrays and matrices are not read.
struct VcaItem {
    std::string name;
    VcaType type = VcaType::container;
    std::uint8_t element = 0;     ///< type of an array's elements
    double number = undefined;    ///< of booleans, integers, floats and quantities
    std::string text;             ///< of strings; symbol of a quantity's unit; UTC of a time stamp
    std::uint64_t offset = 0;     ///< of elements, or of the first text of a list
    std::uint64_t length = 0;     ///< their bytes
    Index rows = 0, columns = 0;  ///< of matrices
    std::vector<VcaItem> children;

    /// The entry at a path below this one, such as "MetaData/Date"; nullptr if there is none.
    [[nodiscard]] const VcaItem* find(std::string_view path) const;
    /// Text of the string there; empty if there is none.
    [[nodiscard]] std::string text_at(std::string_view path) const;
    [[nodiscard]] bool is_matrix() const { return type == VcaType::matrix || type == VcaType::anonymous_matrix; }
};

/// All entries from the position to the end of the source, as children of an entry without name.
/// @throws FormatError for unknown types, entries that extend beyond their parent, or too many entries for the size of
/// the file.
[[nodiscard]] VcaItem read_vca_tree(bytes::Cursor& cursor);

/// One entry without its name, as in OPD blocks, from the position to `end`.
[[nodiscard]] VcaItem read_vca_value(bytes::Cursor& cursor, std::string name, std::uint64_t end);

/// The texts of a list.
[[nodiscard]] std::vector<std::string> texts_of(const VcaItem& list, const bytes::Source& source,
                                                const std::string& format);

/// The channel of an entry with a matrix and its extents ("2D_Data/Raw"): heights if its scale has a unit of length.
/// `common` has format and metadata.
[[nodiscard]] Channel vca_map_channel(const VcaItem& data, const ChannelInfo& common, const bytes::Source& source,
                                      const ReadOptions& options);

/// The channel of an entry with an array ("1D_Data/Raw").
[[nodiscard]] Channel vca_line_channel(const VcaItem& data, const ChannelInfo& common, const bytes::Source& source,
                                       const ReadOptions& options);

}  // namespace setae::formats
