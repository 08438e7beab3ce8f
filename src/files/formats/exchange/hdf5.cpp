// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/header.hpp"
#include "storage/hdf5_file.hpp"
#include "storage/height_likeness.hpp"
#include "storage/stored_array.hpp"

// HDF5 without a known layout: every dataset of numbers with one or two dimensions is a channel, with heights if they
// are likely.
namespace setae::formats {
namespace {

constexpr const char* element_size =
    "element_size_um";  // per index, slowest first: the convention of ImageJ's and napari's plugins
constexpr std::size_t max_shown_attributes = 100, longest_attribute = 1000;
constexpr std::size_t max_groups_looked_at = 1000;  ///< for the mark of an EMD

void keep_attributes(const Attributes& attributes, topography::Metadata& metadata) {
    for (const auto& attribute : attributes) {
        if (metadata.attributes.size() == max_shown_attributes) return;
        if (!attribute.text.empty() && attribute.text.size() <= longest_attribute)
            metadata.attributes[attribute.name] = attribute.text;
        if (attribute.numbers.size() == 1)
            metadata.attributes[attribute.name] = fmt::format("{}", attribute.numbers.front());
    }
}

/// Extents [m] from the distance of neighbours [µm] along each index, the attribute's last numbers; empty if it is not
/// stated.
std::vector<double> size_of(const StoredArray& array) {
    const auto found = std::find_if(array.attributes.begin(), array.attributes.end(),
                                    [](const Attribute& attribute) { return attribute.name == element_size; });
    const auto dimensions = array.shape.size();
    if (found == array.attributes.end() || found->numbers.size() < dimensions) return {};
    std::vector<double> size;
    for (std::size_t k = 0; k < dimensions; ++k)
        size.push_back(found->numbers[found->numbers.size() - dimensions + k] * units::um *
                       static_cast<double>(array.shape[k]));
    return size;
}

/// Data that other programs add: indices of PyTables, parts of tables of pandas, pictures.
std::string reason_if_foreign(const StoredArray& array, const Hdf5File& file) {
    const auto kind = text_of(array.attributes, "CLASS");
    if (array.name.find("/_i_") != std::string::npos || kind == "INDEXARRAY" || kind == "LASTROWARRAY" ||
        kind == "CACHEARRAY")
        return "an index of PyTables";
    if (kind == "IMAGE" && bytes_of(array.sample) == 1) return "a picture (attribute CLASS = IMAGE)";
    const auto parent = array.name.substr(0, array.name.rfind('/'));
    if (!parent.empty() && !text_of(file.attributes(parent), "pandas_type").empty()) return "part of a table of pandas";
    return {};
}

bool holds_integers(Sample sample) { return sample != Sample::float32 && sample != Sample::float64; }

Channel channel_of(const StoredArray& array, const Hdf5File& file, bool only_array, const bytes::Source& source,
                   const ReadOptions& options) {
    ChannelInfo info{.name = array.name.substr(1), .format = "hdf5"};
    keep_attributes(array.attributes, info.metadata);
    const bool is_map = !orientation_of(array, FirstIndex::x_to_the_right).empty();
    if (is_map || array.shape.size() == 1) info.size = size_of(array);
    auto unit = text_of(array.attributes, "unit");
    if (unit.empty()) unit = text_of(array.attributes, "units");
    const auto known = tables::try_parse_unit(unit);
    if (known && known->dimension != dimension::length) {
        info.unit = unit;
        info.shape = array.shape;
        info.orientation = orientation_of(array, FirstIndex::x_to_the_right);
        info.metadata.file = source.name;
        return non_height_channel(std::move(info));
    }
    if (known) info.unit = unit;
    auto channel = array_channel(std::move(info), array, FirstIndex::x_to_the_right,
                                 {.factor = known ? known->factor : 1.0}, options_for(array, options));
    auto why = reason_if_foreign(array, file);
    if (why.empty())
        why = reason_against_heights({.array = array,
                                      .name = array.name.substr(array.name.rfind('/') + 1),
                                      .integers = holds_integers(array.sample),
                                      .has_length = known.has_value(),
                                      .only_array = only_array});
    return why.empty() ? channel : doubtful_channel(std::move(channel), why);
}

/// A file of electron microscopy: its arrays are pictures, spectra and their metadata.
bool is_emd(const Hdf5File& file) {
    for (const char* group : {"Image", "SpectrumImage", "SpectrumStream", "Spectrum"})
        if (!file.members(std::string("/Data/") + group).empty()) return true;
    const auto is_marked = [&](const std::string& path) {
        const auto attributes = file.attributes(path);
        return std::any_of(attributes.begin(), attributes.end(),
                           [](const Attribute& attribute) { return attribute.name == "emd_group_type"; });
    };
    std::size_t looked_at = 0;
    for (const auto& outer : file.members("/")) {
        if (looked_at++ > max_groups_looked_at) return false;
        if (is_marked("/" + outer)) return true;
        for (const auto& inner : file.members("/" + outer)) {
            if (looked_at++ > max_groups_looked_at) return false;
            if (is_marked("/" + outer + "/" + inner)) return true;
        }
    }
    return false;
}

Match detect_hdf5(std::string_view head, const bytes::Source&) {
    return bytes::find_hdf5(head) ? Match::maybe : Match::no;
}

std::vector<Channel> open_hdf5(const bytes::Source& source, const ReadOptions& options) {
    const Hdf5File file(source);
    if (is_emd(file))
        throw FormatError(source.name, {.offset = 0},
                          "an EMD file of electron microscopy contains pictures and spectra, no heights; `setae info` "
                          "lists its images, `setae contour` traces edges in them");
    std::vector<StoredArray> arrays;
    for (const auto& path : file.datasets())
        if (auto array = file.array(path); array && (is_map_or_line(*array) || !array->refusal.empty()))
            arrays.push_back(std::move(*array));
    std::vector<Channel> channels;
    for (const auto& array : arrays) channels.push_back(channel_of(array, file, arrays.size() == 1, source, options));
    if (channels.empty())
        throw FormatError(source.name, {.offset = 0},
                          "HDF5: no dataset of numbers with one or two dimensions and more than one value");
    return channels;
}

}  // namespace

Format hdf5_format() {
    return {
        .identifier = "hdf5",
        .name = "HDF5",
        .extensions = ".h5 .hdf5 .hdf",
        .description =
            "every dataset of integers or floats with one or two dimensions, in groups too, is a channel; size and unit must be given where no attribute states them. Those that do not look "
            "like heights are listed with the reason and read only when chosen",
        .heights =
            "values in the unit of the attribute unit or units, or in the unit given; NaN and infinities are undefined",
        .orientation = "first index x, second y downwards; not stated in the file, taken as SurfaceTopography does",
        .not_read =
            "values of other types, of more dimensions, reached by links that are not hard, in other files, "
            "or packed otherwise than with deflate; the library is not made for damaged files: open only "
            "HDF5 files that you trust",
        .reference = "HDF5 File Format Specification 3.0; element_size_um as ImageJ's HDF5 plugin writes it",
        .tested_on_real_files = true,
        .carries_scale = false,
        .detect = detect_hdf5,
        .open = open_hdf5};
}

}  // namespace setae::formats
