// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/io/format.hpp"

#include <cmath>

#include <fmt/format.h>

#include "readers.hpp"
#include "setae/core/errors.hpp"
#include "text.hpp"

namespace setae::io {

const std::vector<Format>& formats() {
    static const std::vector<Format> table{
        {.identifier = "ce-container",
         .name = "contact.engineering container",
         .extensions = ".zip",
         .description = "ZIP with index.json or meta.yml and one measurement or more; the original file is preferred to its "
                        "processed copy, its heights are scaled by the index only where they carry no scale themselves",
         .reference = "https://contact.engineering",
         .tested_on_real_files = true,
         .detect = detect_container,
         .open = open_container},
        {.identifier = "x3p",
         .name = "X3P",
         .extensions = ".x3p .xml",
         .description = "ZIP with main.xml and binary or listed points of a surface or profile; signed integers or floats, "
                        "increments and offsets applied, invalid points undefined, checksums verified",
         .reference = "ISO 25178-72:2017 (formerly ISO 5436-2)",
         .tested_on_real_files = true,
         .detect = detect_x3p,
         .open = open_x3p},
        {.identifier = "di",
         .name = "Nanoscope",
         .extensions = ".spm .001 .002 .003 .di .txt",
         .description = "Digital Instruments, Veeco, Bruker from version 4.3: text header and an integer image a channel; "
                        "hard scale times soft sensitivity, rows stored from bottom to top",
         .reference = "Nanoscope 5 to 9 file headers, as described by Gwyddion's user guide",
         .tested_on_real_files = true,
         .detect = detect_nanoscope,
         .open = open_nanoscope},
        {.identifier = "nc",
         .name = "NetCDF topography",
         .extensions = ".nc",
         .description = "classic NetCDF with variables heights, x, y and perhaps mask, as containers hold them",
         .reference = "NetCDF Users Guide, classic format",
         .writes = true,
         .tested_on_real_files = true,
         .detect = detect_netcdf,
         .open = open_netcdf},
        {.identifier = "npy",
         .name = "NumPy array",
         .extensions = ".npy",
         .description = "versions 1 to 3, floats or integers of either byte order, C or Fortran order, first index x; size "
                        "and unit must be given",
         .reference = "NumPy Enhancement Proposal 1",
         .writes = true,
         .tested_on_real_files = true,
         .carries_scale = false,
         .detect = detect_npy,
         .open = open_npy},
        {.identifier = "matrix",
         .name = "text matrix",
         .extensions = ".txt .asc",
         .description = "numbers only, a row of the map a line from the top, with Gwyddion's header (width, height, value "
                        "units) or size and unit given",
         .reference = "Gwyddion user guide, export as ASCII data matrix",
         .tested_on_real_files = true,
         .carries_scale = false,
         .detect = detect_matrix_text,
         .open = open_matrix_text},
        {.identifier = "xy",
         .name = "two-column text",
         .extensions = ".txt .csv .asc .dat .hfm",
         .description = "x and height with any separator, decimal point or comma, header and units in it or given; equal "
                        "steps give a line scan, others a profile as traced; also Dektak CSV, a third column 'valid' "
                        "or 'standard_error', and setae's own profiles with the response of their trace",
         .reference = "no standard; the dialects stand in setae/io/table_file.hpp",
         .writes = true,
         .tested_on_real_files = true,
         .carries_scale = false,
         .detect = detect_xy,
         .open = open_xy},
    };
    return table;
}

namespace {

std::string first_bytes(std::string_view head) {
    std::string shown;
    for (const char c : head.substr(0, 16)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7f)
            shown += c;
        else
            shown += fmt::format("\\x{:02x}", byte);
    }
    return shown;
}

[[noreturn]] void unknown(const Source& source, std::string_view head) {
    if (head.empty()) throw FormatError(source.name, {.offset = 0}, "the file is empty");
    if (looks_like_text(head))
        throw FormatError(source.name, {.line = 1}, "text without a row of numbers; expected columns x and height below a header");
    throw FormatError(source.name, {.offset = 0},
                      fmt::format("begins with '{}', which no format setae reads does; `setae formats` lists them", first_bytes(head)));
}

/// Sizes the user or an index gave against the file's own, which stay.
void compare_sizes(std::vector<Channel>& channels, const ReadOptions& options, const Source& source) {
    if (!options.size) return;
    for (auto& channel : channels) {
        const auto& size = channel.info.size;
        bool same = size.size() == options.size->size();
        for (std::size_t i = 0; same && i < size.size(); ++i) same = std::abs(size[i] / (*options.size)[i] - 1.0) < 1e-4;
        if (!same && !size.empty())
            channel.info.alerts.push_back({"SIZE_MISMATCH", source.name, fmt::format("a size of {} m was given, the file says {} m, which was used", options.size->front(), size.front()),
                                           "check which of the two is right"});
    }
}

}  // namespace

const Format& detect_format(const Source& source) {
    const auto head = source.head(detection_bytes);
    const Format* possible = nullptr;
    for (const auto& format : formats()) {
        const auto match = format.detect(head, source);
        if (match == Match::yes) return format;
        if (match == Match::maybe && !possible) possible = &format;
    }
    if (!possible) unknown(source, head);
    return *possible;
}

std::vector<Channel> open(const Source& source, const ReadOptions& options) {
    auto channels = detect_format(source).open(source, options);
    compare_sizes(channels, options, source);
    return channels;
}

std::vector<Channel> open(const std::string& path, const ReadOptions& options) { return open(file_source(path), options); }

topography::Measurement read(const std::string& path, std::size_t channel, const ReadOptions& options) {
    const auto channels = open(path, options);
    if (channel >= channels.size())
        throw InvalidArgument(fmt::format("{}: no channel {}, the file has {} (counted from 0)", path, channel, channels.size()));
    return channels[channel].read();
}

}  // namespace setae::io
