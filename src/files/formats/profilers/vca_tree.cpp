// SPDX-License-Identifier: GPL-3.0-or-later
#include "vca_tree.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "setae/bytes/unix_time.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/header.hpp"
#include "storage/raster.hpp"

namespace setae::formats {
namespace {

constexpr int vca_deepest = 16;
constexpr int max_items = 100000;
constexpr std::uint64_t longest_text_of_vca = 1 << 16;
constexpr std::size_t max_texts = 1000;
/// Vision writes 1e38 for missing values, which is slightly smaller in single precision.
constexpr double greatest_height = 9.9e37;

class TreeReader {
public:
    explicit TreeReader(bytes::Cursor& cursor) : cursor_(cursor) {}

    std::vector<VcaItem> items(std::uint64_t end, int depth) {
        std::vector<VcaItem> found;
        while (cursor_.position() < end) {
            auto name = this->name();
            auto item = value(std::move(name), end, depth);
            if (item.type == VcaType::terminator) break;
            found.push_back(std::move(item));
        }
        cursor_.seek(end);
        return found;
    }

    VcaItem value(std::string name, std::uint64_t end, int depth) {
        if (++count_ > max_items)
            cursor_.fail(fmt::format("more than {} entries, which is not possible; the file is damaged", max_items));
        VcaItem item;
        item.name = std::move(name);
        item.type = static_cast<VcaType>(cursor_.number<std::uint8_t>());
        content(item, depth);
        if (cursor_.position() > end)
            cursor_.fail(fmt::format("entry '{:.40}' extends beyond the entry that contains it; the file is damaged",
                                     item.name));
        return item;
    }

private:
    std::string name() {
        const auto length = cursor_.number<std::uint32_t>();
        if (length > longest_text_of_vca)
            cursor_.fail(fmt::format("a name of {} characters, expected {} at most; the file is damaged", length,
                                     longest_text_of_vca));
        return cursor_.text(length);
    }

    /// A length has a prefix for its number of bytes.
    std::uint64_t length() {
        std::uint64_t bytes = 0;
        switch (const auto width = cursor_.number<std::uint8_t>()) {
            case 1: bytes = cursor_.number<std::uint8_t>(); break;
            case 2: bytes = cursor_.number<std::uint16_t>(); break;
            case 4: bytes = cursor_.number<std::uint32_t>(); break;
            case 8: bytes = cursor_.number<std::uint64_t>(); break;
            default:
                cursor_.fail(fmt::format("a length of {} bytes, expected 1, 2, 4 or 8; the file is damaged", width));
        }
        if (bytes > cursor_.remaining())
            throw FormatError(
                cursor_.source().name, {.offset = cursor_.source().size},
                fmt::format(
                    "Vision64: the file ends here, but an entry of {} bytes begins at byte {}; it is truncated or "
                    "damaged",
                    bytes, cursor_.position()));
        return bytes;
    }

    void quantity(VcaItem& item, bool value_first) {
        const auto bytes = length();
        const auto end = cursor_.position() + bytes;
        if (value_first) item.number = cursor_.number<double>();
        (void)name();
        item.text = name();
        if (!value_first) item.number = cursor_.number<double>();
        if (cursor_.position() > end)
            cursor_.fail(
                fmt::format("quantity '{:.40}' is longer than its {} bytes; the file is damaged", item.name, bytes));
        cursor_.seek(end);
    }

    void elements(VcaItem& item) {
        item.length = length();
        item.offset = cursor_.position();
        cursor_.skip(item.length);
    }

    void matrix(VcaItem& item) {
        item.text = name();
        if (item.type == VcaType::matrix) {
            cursor_.skip(sizeof(std::uint32_t));
            (void)name();
        }
        const auto bytes = length();
        constexpr std::uint64_t dimensions = 2 * sizeof(std::uint32_t);
        if (bytes < dimensions)
            cursor_.fail(fmt::format("matrix '{:.40}' of {} bytes has no space for its dimensions; the file is damaged",
                                     item.name, bytes));
        item.rows = cursor_.number<std::uint32_t>();
        item.columns = cursor_.number<std::uint32_t>();
        item.offset = cursor_.position();
        item.length = bytes - dimensions;
        cursor_.skip(item.length);
    }

    void array(VcaItem& item) {
        (void)name();
        elements(item);
        constexpr std::uint64_t prefix = 5;  // type of elements, their bytes
        if (item.length < prefix)
            cursor_.fail(fmt::format("array '{:.40}' of {} bytes has no space for its type; the file is damaged",
                                     item.name, item.length));
        item.element = cursor_.number_at<std::uint8_t>(item.offset);
        item.offset += prefix;
        item.length -= prefix;
    }

    void content(VcaItem& item, int depth) {
        switch (item.type) {
            case VcaType::boolean: item.number = cursor_.number<std::uint8_t>(); return;
            case VcaType::int16: item.number = cursor_.number<std::int16_t>(); return;
            case VcaType::uint16: item.number = cursor_.number<std::uint16_t>(); return;
            case VcaType::int32: item.number = cursor_.number<std::int32_t>(); return;
            case VcaType::uint32: item.number = cursor_.number<std::uint32_t>(); return;
            case VcaType::int64: item.number = static_cast<double>(cursor_.number<std::int64_t>()); return;
            case VcaType::uint64: item.number = static_cast<double>(cursor_.number<std::uint64_t>()); return;
            case VcaType::float32: item.number = cursor_.number<float>(); return;
            case VcaType::float64: item.number = cursor_.number<double>(); return;
            case VcaType::string: {
                const auto bytes = length();
                if (bytes <= longest_text_of_vca) item.text = cursor_.text(bytes);
                else cursor_.skip(bytes);
                return;
            }
            case VcaType::quantity: return quantity(item, true);
            case VcaType::units: return quantity(item, false);
            case VcaType::time_stamp:
                cursor_.skip(1);
                item.text = bytes::utc_text_of_filetime(cursor_.number<std::uint64_t>());
                return;
            case VcaType::array: return array(item);
            case VcaType::type_identifier:
            case VcaType::string_list:
            case VcaType::positions: (void)name(); return elements(item);
            case VcaType::matrix:
            case VcaType::anonymous_matrix: return matrix(item);
            case VcaType::container:
            case VcaType::line_data:
            case VcaType::map_data: {
                if (depth >= vca_deepest)
                    cursor_.fail(fmt::format("entries nested deeper than {}; the file is damaged", vca_deepest));
                const auto bytes = length();
                item.children = items(cursor_.position() + bytes, depth + 1);
                return;
            }
            case VcaType::terminator: return;
        }
        cursor_.fail(
            fmt::format("entry '{:.40}' is of the unknown type {:#04x}", item.name, static_cast<unsigned>(item.type)));
    }

    bytes::Cursor& cursor_;
    int count_ = 0;
};

/// Size of n points whose first and last are `extent` apart; empty if the file states no such length.
std::optional<double> whole_size(const VcaItem* extent, Index points) {
    if (!extent || points < 2) return std::nullopt;
    const auto unit = tables::try_parse_unit(extent->text);
    if (!unit || unit->dimension != dimension::length) return std::nullopt;
    return extent->number * unit->factor * static_cast<double>(points) / static_cast<double>(points - 1);
}

/// Factor of raw values to metres; 0 if they are no heights. Without a stated scale, heights keep 1 and no unit.
double height_factor(const VcaItem& data, ChannelInfo& info) {
    const auto* scale = data.find("DataScale");
    const auto kind = data.text_at("DataKind");
    if (!scale) return kind.empty() || kind == "Height" ? 1.0 : 0.0;
    info.unit = scale->text;
    const auto unit = tables::try_parse_unit(scale->text);
    return unit && unit->dimension == dimension::length ? scale->number * unit->factor : 0.0;
}

ChannelInfo named(const VcaItem& data, const ChannelInfo& common) {
    auto info = common;
    info.name = info.metadata.name = data.name;
    if (const auto kind = data.text_at("DataKind"); !kind.empty()) info.metadata.attributes["data_kind"] = kind;
    return info;
}

Channel channel_of(ChannelInfo info, const Raster& raster, double factor, const bytes::Source& source,
                   const ReadOptions& options) {
    if (factor == 0.0) {
        require_raster(raster, source, info.format);
        return non_height_channel(std::move(info));
    }
    return raster_channel(std::move(info), source, raster,
                          {.factor = factor, .least = -greatest_height, .greatest = greatest_height}, options);
}

}  // namespace

const VcaItem* VcaItem::find(std::string_view path) const {
    const auto slash = path.find('/');
    const auto first = path.substr(0, slash);
    for (const auto& child : children) {
        if (child.name != first) continue;
        return slash == std::string_view::npos ? &child : child.find(path.substr(slash + 1));
    }
    return nullptr;
}

std::string VcaItem::text_at(std::string_view path) const {
    const auto* item = find(path);
    return item && (item->type == VcaType::string || item->type == VcaType::time_stamp) ? item->text : std::string();
}

VcaItem read_vca_tree(bytes::Cursor& cursor) {
    VcaItem root;
    const auto end = cursor.source().size;
    root.children = TreeReader(cursor).items(end, 0);
    return root;
}

VcaItem read_vca_value(bytes::Cursor& cursor, std::string name, std::uint64_t end) {
    return TreeReader(cursor).value(std::move(name), end, 0);
}

std::vector<std::string> texts_of(const VcaItem& list, const bytes::Source& source, const std::string& format) {
    std::vector<std::string> texts;
    bytes::Cursor cursor(source, format, list.offset);
    while (cursor.position() < list.offset + list.length && texts.size() < max_texts) {
        const auto length = cursor.number<std::uint32_t>();
        if (length > longest_text_of_vca)
            cursor.fail(fmt::format("a text of {} characters, expected {} at most; the file is damaged", length,
                                    longest_text_of_vca));
        texts.push_back(cursor.text(length));
    }
    return texts;
}

Channel vca_map_channel(const VcaItem& data, const ChannelInfo& common, const bytes::Source& source,
                        const ReadOptions& options) {
    auto info = named(data, common);
    const auto* matrix = data.find("Matrix");
    const auto points = static_cast<std::uint64_t>(matrix->rows) * static_cast<std::uint64_t>(matrix->columns);
    const auto bytes = points > 0 ? matrix->length / points : 0;
    if (bytes * points != matrix->length || (bytes != sizeof(float) && bytes != sizeof(double)))
        throw FormatError(source.name, {.offset = matrix->offset},
                          fmt::format("{}: matrix '{}' has {} × {} values in {} bytes, expected 4 or 8 bytes per value",
                                      info.format, info.name, matrix->columns, matrix->rows, matrix->length));
    const Raster raster{.offset = matrix->offset,
                        .nx = matrix->columns,
                        .ny = matrix->rows,
                        .sample = bytes == sizeof(float) ? Sample::float32 : Sample::float64};
    info.shape = {raster.nx, raster.ny};
    const auto width = whole_size(data.find("Dimension2Extent"), raster.nx),
               height = whole_size(data.find("Dimension1Extent"), raster.ny);
    if (width && height) info.size = {*width, *height};
    info.orientation = "rows from the top, as stored; not stated in the file";
    const double factor = height_factor(data, info);
    return channel_of(std::move(info), raster, factor, source, options);
}

Channel vca_line_channel(const VcaItem& data, const ChannelInfo& common, const bytes::Source& source,
                         const ReadOptions& options) {
    auto info = named(data, common);
    const auto* array = data.find("Array");
    const bool single = array->element == static_cast<std::uint8_t>(VcaType::float32);
    if (!single && array->element != static_cast<std::uint8_t>(VcaType::float64))
        throw FormatError(
            source.name, {.offset = array->offset},
            fmt::format("{}: values of profile '{}' are of type {:#04x}, expected 0x0c or 0x0d (floating point)",
                        info.format, info.name, array->element));
    const auto points = array->length / (single ? sizeof(float) : sizeof(double));
    const auto* announced = data.find("NumPoints");
    if (announced && announced->number != static_cast<double>(points))
        throw FormatError(source.name, {.offset = array->offset},
                          fmt::format("{}: profile '{}' announces {} points but has {}", info.format, info.name,
                                      announced->number, points));
    const Raster raster{.offset = array->offset,
                        .nx = static_cast<Index>(points),
                        .ny = 1,
                        .sample = single ? Sample::float32 : Sample::float64};
    info.shape = {raster.nx};
    if (const auto size = whole_size(data.find("Extent"), raster.nx)) info.size = {*size};
    const double factor = height_factor(data, info);
    return channel_of(std::move(info), raster, factor, source, options);
}

}  // namespace setae::formats
