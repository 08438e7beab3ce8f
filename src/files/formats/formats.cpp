// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/formats/format.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "format_list.hpp"
#include "no_data_channel.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/bytes/expand.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/bytes/rehearsal.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/force_curve.hpp"
#include "storage/tiff_pixels.hpp"
#include "text/text_start.hpp"

namespace setae::formats {

const std::vector<Format>& formats() {
    static const std::vector<Format> table{
        // exchange
        container_format(),
        x3p_format(),
        sdf_format(),
        gwy_format(),
        gsf_format(),

        // arrays
        netcdf_format(),
        npy_format(),
        npz_format(),
        mat_format(),
        hdf5_format(),
        datx_format(),
        jpk_hdf5_format(),
        topostats_format(),

        // scanning probes
        nanoscope_format(),
        ibw_format(),
        jpk_format(),
        jpk_qi_format(),
        park_format(),
        mi_format(),
        nanosurf_format(),
        wsxm_format(),
        mdt_format(),
        nmm_format(),
        nanonis_format(),

        // optical and stylus profilers
        opd_format(),
        opdx_format(),
        metropro_format(),
        bcr_format(),
        nms_format(),
        frt_format(),
        tmd_format(),
        zmg_format(),
        os3d_format(),
        hgt_format(),
        qep_format(),
        plu_format(),
        plux_format(),
        al3d_format(),
        sur_format(),
        mnt_format(),
        vk_format(),
        zon_format(),
        zag_format(),
        lext_format(),
        oir_format(),
        poir_format(),
        height_tiff_format(),

        // text and sheets last: their columns may begin anywhere
        mitutoyo_format(),
        workbook_format(),
        dektak_csv_format(),
        hfm_format(),
        dabam_format(),
        matrix_text_format(),
        xyz_format(),
        xy_format(),
    };
    return table;
}

namespace {

std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> found;
    tables::split_cells(text, ' ', found);
    return found;
}

std::string first_bytes(std::string_view head) {
    std::string shown;
    for (const char c : head.substr(0, 16)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7f) shown += c;
        else shown += fmt::format("\\x{:02x}", byte);
    }
    return shown;
}

/// Formats with the ending of the name, for a file that no format recognises.
std::string expected_by_name(const std::string& name) {
    std::string names;
    for (const auto& format : formats())
        for (const auto ending : words(format.extensions))
            if (ending != ".zip" && bytes::lowered(name).ends_with(ending))
                names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", format.identifier, format.name);
    return names.empty()
               ? ""
               : fmt::format(
                     "; its name is that of {}, whose files begin differently: the file may be damaged or of another "
                     "version",
                     names);
}

/// Kind of file by its first bytes, for kinds of other programs.
std::string kind_of(std::string_view head, const bytes::Source& source) {
    using namespace std::string_view_literals;
    if (bytes::is_zip(head)) {
        auto names = bytes::Archive(source).names();
        if (names.size() > 5) names.resize(5);
        return fmt::format("a ZIP archive with {}", fmt::join(names, ", "));
    }
    static constexpr std::pair<std::string_view, const char*> kinds[] = {{"\x89HDF\r\n"sv, "an HDF5 file"},
                                                                         {"II*\0"sv, "a TIFF picture"},
                                                                         {"MM\0*"sv, "a TIFF picture"},
                                                                         {"\xd0\xcf\x11\xe0"sv, "an OLE compound file"},
                                                                         {"\x89PNG"sv, "a PNG picture"},
                                                                         {"\xff\xd8\xff"sv, "a JPEG picture"},
                                                                         {"BM"sv, "a bitmap picture"},
                                                                         {"%PDF"sv, "a PDF document"},
                                                                         {"\x28\xb5\x2f\xfd"sv, "a Zstandard stream"},
                                                                         {"7z\xbc\xaf"sv, "a 7z archive"},
                                                                         {"Rar!"sv, "a RAR archive"},
                                                                         {"\x7f"
                                                                          "ELF"sv,
                                                                          "a program"}};
    for (const auto& [signature, kind] : kinds)
        if (head.starts_with(signature)) return kind;
    return {};
}

/// The first member that is no folder.
std::string first_member(const bytes::Source& source) {
    const auto names = bytes::Archive(source).names();
    const auto file =
        std::find_if(names.begin(), names.end(), [](const std::string& name) { return !name.ends_with('/'); });
    return file == names.end() ? "member" : *file;
}

[[noreturn]] void unknown(const bytes::Source& source, std::string_view head) {
    if (head.empty()) throw FormatError(source.name, {.offset = 0}, "the file is empty");
    if (bytes::is_tiff(head)) refuse_tiff(source);
    if (bytes::looks_like_text(head)) {
        const auto text = bytes::decoded(std::string(head.substr(0, head.rfind('\n'))), bytes::Encoding::detect);
        if (const auto broken = tables::broken_row_of(bytes::split_lines(text)))
            throw FormatError(source.name, {.line = broken->line}, tables::described(*broken));
        throw FormatError(source.name, {.line = 1},
                          "text without a row of numbers; expected columns x and height below a header" +
                              expected_by_name(source.name));
    }
    const auto kind = kind_of(head, source);
    if (bytes::is_zip(head))
        throw FormatError(
            source.name, {.offset = 0},
            fmt::format(
                "{} is not one of the supported formats{}; `setae info` lists its members, and each of them can "
                "be given as a file, such as {}/{}",
                kind, expected_by_name(source.name), source.name, first_member(source)));
    throw FormatError(
        source.name, {.offset = 0},
        fmt::format("begins with '{}'{}, which no supported format does{}; `setae formats` lists the supported "
                    "formats",
                    first_bytes(head), kind.empty() ? "" : ", as " + kind, expected_by_name(source.name)));
}

/// Compares sizes given by the user or an index with those of the file, which are used.
void compare_sizes(std::vector<Channel>& channels, const ReadOptions& options, const bytes::Source& source) {
    if (!options.size) return;
    for (auto& channel : channels) {
        const auto& size = channel.info.size;
        bool same = size.size() == options.size->size();
        for (std::size_t i = 0; same && i < size.size(); ++i)
            same = std::abs(size[i] / (*options.size)[i] - 1.0) < 1e-4;
        if (!same && !size.empty())
            channel.info.alerts.push_back(
                {"SIZE_MISMATCH", source.name,
                 fmt::format("a size of {} m was given, but the file states {} m, which was used",
                             options.size->front(), size.front()),
                 "check which of the two sizes is right"});
    }
}

}  // namespace

namespace {

const Format& detected_in(std::string_view head, const bytes::Source& source) {
    const Format* possible = nullptr;
    for (const auto& format : formats()) {
        const auto match = format.detect(head, source);
        if (match == Match::yes) return format;
        if (match == Match::maybe && !possible) possible = &format;
    }
    if (!possible) unknown(source, head);
    return *possible;
}

/// Calls of the HDF5 library in a child process first: its release 1.10.8 crashes on some damaged bytes.
void rehearse_hdf5(std::string_view head, const bytes::Source& source, const ReadOptions& options) {
    constexpr std::uint64_t small = 1 << 24;  // for larger files the library reads only the headers
    (void)formats();
    const bytes::Hdf5Session session;
    bytes::rehearse(source.name, "HDF5", [&] {
        for (const auto& channel : detected_in(head, source).open(source, options)) {
            try {
                if (source.size <= small) (void)channel.read();
            } catch (const Error&) {  // the other files are read anyway
            }
        }
    });
}

/// @throws FormatError, too, for bytes that crash the library of their format.
const Format& detected(const bytes::Source& source, const ReadOptions& options = {}) {
    const auto head = source.head(bytes::detection_bytes);
    if (bytes::find_hdf5(head)) rehearse_hdf5(head, source, options);
    return detected_in(head, source);
}

}  // namespace

const Format& detect_format(const bytes::Source& packed) {
    const auto source = bytes::unpacked(packed);
    const KeptStart start(source);
    return detected(source);
}

const Format& format_to_write(const std::string& path) {
    std::string endings;
    for (const auto& format : formats()) {
        if (!format.writes()) continue;
        for (const auto ending : words(format.extensions)) {
            if (bytes::lowered(path).ends_with(ending)) return format;
            endings += fmt::format("{}{}", endings.empty() ? "" : ", ", ending);
        }
    }
    throw InvalidArgument(
        fmt::format("{}: cannot tell the format from the name; expected an ending {}", path, endings));
}

std::vector<std::string> missing(const ChannelInfo& info) {
    std::vector<std::string> names;
    if (info.size.empty()) names.emplace_back("size");
    if (info.unit.empty()) names.emplace_back("unit");
    if (info.metadata.instrument.name.empty()) names.emplace_back("instrument");
    if (info.metadata.acquisition_time.empty()) names.emplace_back("date");
    return names;
}

std::optional<topography::TiledMap> tiled(const Channel& channel) {
    const auto& info = channel.info;
    if (!channel.lines || info.shape.size() != 2 || info.size.size() != 2) return {};
    return topography::TiledMap{info.shape[0], info.shape[1], {info.size[0], info.size[1]}, false,
                                info.metadata, channel.lines, channel.alerts_of_lines};
}

namespace {

/// Refuses force curves, recognised by their header: their numbers are no heights. Formats with both images and force
/// curves list both themselves; Igor waves can be either.
void require_no_force_curve(const bytes::Source& source, const Format& format) {
    const bool may_be_curve = !format.carries_scale || format.identifier == "ibw";
    if (!may_be_curve || format.is_container) return;
    if (const auto curve = tables::stated_force_curve_format(source))
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("a force curve ({}) contains no heights; `setae jkr fit` reads it", *curve));
}

}  // namespace

std::vector<Channel> open(const bytes::Source& source, const Format& format, const ReadOptions& options) {
    require_no_force_curve(source, format);
    auto channels = format.open(source, options);
    compare_sizes(channels, options, source);
    if (options.keep_values || format.is_container) return channels;  // members of containers were opened separately
    for (auto& channel : channels) channel = without_no_data(std::move(channel));
    return channels;
}

std::vector<Channel> open(const bytes::Source& packed, const ReadOptions& options) {
    const auto source = bytes::unpacked(packed);
    const KeptStart start(source);
    return open(source, detected(source, options), options);
}

std::vector<Channel> open(const std::string& path, const ReadOptions& options) {
    return open(bytes::file_source(path), options);
}

std::vector<Channel> open_chosen(const std::string& path, const ChannelChoice& wanted, const ReadOptions& options) {
    const auto source = bytes::unpacked(bytes::file_source(path));
    const auto& format = detected(source, options);
    const auto channels = open(source, format, options);
    std::vector<Channel> chosen;
    for (const auto i : chosen_channels(path, channels, wanted, format.is_container)) chosen.push_back(channels[i]);
    return chosen;
}

topography::Measurement read(const std::string& path, const ChannelChoice& channel, const ReadOptions& options) {
    return open_chosen(path, channel, options).front().read();
}

topography::Measurement read(const std::string& path, std::size_t channel, const ReadOptions& options) {
    return read(path, ChannelChoice(fmt::format("{}", channel)), options);
}

}  // namespace setae::formats
