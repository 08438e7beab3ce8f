// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "mat_arrays.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/core/errors.hpp"
#include "storage/hdf5_file.hpp"
#include "storage/height_likeness.hpp"

// MATLAB: levels 4 and 5, and version 7.3, which is HDF5 after a block of 512 bytes. A row of a matrix is a line of the
// picture, the first row its top, as imagesc shows it.
namespace setae::formats {
namespace {

constexpr const char* mat_identifier = "mat";
constexpr std::string_view version_73 = "MATLAB 7.3 MAT-file";
constexpr const char* orientation = "rows of the matrix from the top, as stored";

bool is_mat73(std::string_view head) {
    return head.starts_with(version_73) || (head.starts_with("MATLAB") && bytes::find_hdf5(head).value_or(0) > 0);
}

Match detect_mat(std::string_view head, const bytes::Source&) {
    if (is_mat5(head) || is_mat73(head)) return Match::yes;
    return can_be_mat4(head) ? Match::maybe : Match::no;
}

/// HDF5 stores a matrix with its columns as first index.
std::vector<MatVariable> mat73_variables(const bytes::Source& source) {
    const Hdf5File file(source);
    std::vector<MatVariable> variables;
    for (const auto& name : file.members("/")) {
        auto array = file.array("/" + name);
        if (!array || number_of(array->attributes, "MATLAB_empty").value_or(0.0) != 0.0) continue;
        const auto kind = text_of(array->attributes, "MATLAB_class");
        if (kind == "char" || kind == "logical" || kind == "cell") continue;
        array->name = name;
        const bool integers = kind.find("int") != std::string::npos;
        variables.push_back({std::move(*array), false, integers});
    }
    return variables;
}

Channel channel_of(const MatVariable& variable, FirstIndex first, bool only_array, const bytes::Source& source,
                   const ReadOptions& options) {
    ChannelInfo info{.name = variable.array.name, .format = mat_identifier};
    if (!orientation_of(variable.array, first).empty()) info.orientation = orientation;
    if (!variable.complex) {
        auto channel = array_channel(std::move(info), variable.array, first, {}, options_for(variable.array, options));
        const auto why = reason_against_heights({.array = variable.array,
                                                 .name = variable.array.name,
                                                 .integers = variable.integers,
                                                 .only_array = only_array});
        return why.empty() ? channel : doubtful_channel(std::move(channel), why);
    }
    info.shape = first == FirstIndex::y_downwards
                     ? std::vector<Index>{variable.array.shape.rbegin(), variable.array.shape.rend()}
                     : variable.array.shape;
    info.metadata.file = source.name;
    info.metadata.attributes["numbers"] = "complex";
    return non_height_channel(std::move(info), "complex numbers");
}

std::vector<Channel> open_mat(const bytes::Source& source, const ReadOptions& options) {
    const auto head = source.head(bytes::detection_bytes);
    const bool hdf5 = is_mat73(head);
    const auto variables = hdf5            ? mat73_variables(source)
                           : is_mat5(head) ? mat5_variables(source)
                                           : mat4_variables(source);
    const auto counts = [](const MatVariable& variable) {
        return is_map_or_line(variable.array) || !variable.array.refusal.empty();
    };
    const bool only_array = std::count_if(variables.begin(), variables.end(), counts) == 1;
    std::vector<Channel> channels;
    for (const auto& variable : variables)
        if (counts(variable))
            channels.push_back(channel_of(variable, hdf5 ? FirstIndex::x_to_the_right : FirstIndex::y_downwards,
                                          only_array, source, options));
    if (channels.empty())
        throw FormatError(
            source.name, {.offset = 0},
            "MAT: no matrix of numbers with more than one value; structs, cells and objects are not read: "
            "save the matrix itself");
    return channels;
}

}  // namespace

Format mat_format() {
    return {
        .identifier = mat_identifier,
        .name = "MATLAB",
        .extensions = ".mat",
        .description =
            "levels 4 and 5, compressed or not, of either byte order, and version 7.3: each matrix of numbers is a channel; size and unit must be given. Those that do not look like heights are listed with the reason and read only when chosen",
        .heights = "values in the unit given; NaN and infinities are undefined",
        .orientation =
            "a row of the matrix is a line of the picture, the first its top, as imagesc shows it: h(x = column, y = row); not stated in the file",
        .not_read =
            "single numbers, arrays of more dimensions, texts, cells, structs, objects, sparse and logical matrices are passed over; complex ones are listed, not read",
        .reference = "MathWorks, MAT-File Format; version 7.3 from files that MATLAB's documentation describes as HDF5",
        .tested_on_real_files = false,
        .carries_scale = false,
        .detect = detect_mat,
        .open = open_mat};
}

}  // namespace setae::formats
