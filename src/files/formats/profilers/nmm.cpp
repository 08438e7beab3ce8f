// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/header_number.hpp"

// SIOS nanomeasuring machine: a ZIP archive with NAME.dsc, which describes the scan field, and for scan s and line l
// the pair NAME_s_l.dsc, which names columns ("number : date : name : points : description"), and NAME_s_l.dat, which
// holds them as text. Lines have length/distance + 1 points; heights are in the column "-Lz+Az" in metres.
namespace setae::formats {
namespace {

constexpr std::string_view dashes = "------------------------------------------",
                           title = "Scan procedure description file", nmm_height_column = "-Lz+Az";
constexpr double agreement = 1e-6;  ///< relative, between lengths that must be equal
constexpr Index max_lines = 1 << 20;

[[noreturn]] void broken_nmm(const bytes::Source& source, std::uint64_t line, const std::string& what) {
    throw FormatError(source.name, {.line = line}, "NMM: " + what);
}

/// The member that describes the procedure; empty if the archive is of another kind.
std::string description_member(const bytes::Archive& archive) {
    for (const auto& name : archive.names()) {
        const auto file = name.substr(name.find_last_of("/\\") + 1);
        if (!bytes::lowered(name).ends_with(".dsc") || file.starts_with('.') || file.starts_with('_')) continue;
        const auto head = archive.head(name, 256);
        if (head.starts_with(dashes) && head.find(title) != std::string::npos) return name;
    }
    return {};
}

std::map<std::string, std::string> parse_description(const bytes::Source& source) {
    std::map<std::string, std::string> entries;
    const auto text = bytes::decoded(source.all(), bytes::Encoding::detect);
    for (const auto raw : bytes::split_lines(text)) {
        const auto line = trimmed(raw);
        const auto colon = line.find(':');
        if (colon != std::string_view::npos)
            entries.emplace(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
    }
    return entries;
}

const std::string& entry(const std::map<std::string, std::string>& entries, const std::string& key,
                         const bytes::Source& source) {
    const auto at = entries.find(key);
    if (at == entries.end())
        throw FormatError(source.name, {}, fmt::format("NMM: no '{}' in the description of the scan", key));
    return at->second;
}

/// "10.0 [µm]" in metres.
double length_of(const std::map<std::string, std::string>& entries, const std::string& key,
                 const bytes::Source& source) {
    const auto& text = entry(entries, key, source);
    const auto open = text.find('['), close = text.find(']');
    const auto number = tables::finite_number(std::string_view(text).substr(0, open));
    if (open == std::string::npos || close == std::string::npos || close < open || !number || !(*number >= 0.0))
        throw FormatError(source.name, {},
                          fmt::format("NMM: '{}' is '{:.40}', expected a length such as '10.0 [µm]'", key, text));
    return *number * length_unit(text.substr(open + 1, close - open - 1), source).factor;
}

Index number_of(const std::map<std::string, std::string>& entries, const std::string& key,
                const bytes::Source& source) {
    const auto count = tables::count_in(entry(entries, key, source));
    if (!count || *count < 1 || *count > max_lines)
        throw FormatError(
            source.name, {},
            fmt::format("NMM: '{}' is '{:.40}', expected 1 to {}", key, entry(entries, key, source), max_lines));
    return *count;
}

struct ScanField {
    std::string prefix;  ///< of members: the name of the description without its ending
    Index scans = 1, lines = 1, points = 2;
    double dx = 0.0, dy = 0.0;  ///< [m]
    std::string date;
};

/// Number of points of a length at a distance, both ends included: length/distance + 1.
Index points_along(double length, double distance, const bytes::Source& source) {
    const double steps = length / distance;
    if (!(distance > 0.0) || !(steps >= 1.0) || steps > 0x1p31 || std::abs(std::round(steps) / steps - 1.0) > agreement)
        throw FormatError(source.name, {},
                          fmt::format("NMM: a line of {} m with points {} m apart, expected a whole number of steps",
                                      length, distance));
    return static_cast<Index>(std::llround(steps)) + 1;
}

ScanField read_field(const bytes::Archive& archive, const std::string& member) {
    const auto source = archive.member(member);
    const auto entries = parse_description(source);
    ScanField field;
    field.prefix = member.substr(0, member.size() - 4);
    field.scans = number_of(entries, "Number of scans", source);
    field.lines = number_of(entries, "Number of lines", source);
    field.dx = length_of(entries, "Distance beetween points", source);
    field.points = points_along(length_of(entries, "Scan line length", source), field.dx, source);
    if (field.lines > 1) {
        field.dy = length_of(entries, "Distance beetween lines", source);
        const double width = length_of(entries, "Scan field width", source);
        if (points_along(width, field.dy, source) != field.lines)
            throw FormatError(source.name, {},
                              fmt::format("NMM: {} lines {} m apart do not fit into a field {} m wide", field.lines,
                                          field.dy, width));
    }
    if (const auto at = entries.find("Creation time"); at != entries.end()) field.date = at->second;
    return field;
}

/// Names of the columns of a line, with their stated number of points.
struct NmmColumns {
    std::vector<std::string> names;
    Index points = 0;
};

NmmColumns read_columns(const bytes::Source& source) {
    const auto text = bytes::decoded(source.all(), bytes::Encoding::detect);
    const auto lines = bytes::split_lines(text);
    if (lines.empty() || trimmed(lines[0]) != dashes) broken_nmm(source, 1, "expected a line of dashes");
    NmmColumns columns;
    for (std::size_t i = 1; i < lines.size() && trimmed(lines[i]) != dashes; ++i) {
        std::vector<std::string_view> cells;
        auto rest = lines[i];
        for (auto at = rest.find(" : "); at != std::string_view::npos; at = rest.find(" : ")) {
            cells.push_back(trimmed(rest.substr(0, at)));
            rest.remove_prefix(at + 3);
        }
        const auto count = cells.size() < 4 ? std::nullopt : tables::count_in(cells[3]);
        if (!count || (columns.points != 0 && *count != columns.points))
            broken_nmm(
                source, i + 1,
                "expected 'number : date : name : points : description' and as many points as the column before");
        columns.points = *count;
        columns.names.emplace_back(cells[2]);
    }
    return columns;
}

std::string line_member(const ScanField& field, Index scan, Index line) {
    return fmt::format("{}_{}_{}", field.prefix, scan + 1, line + 1);
}

/// Appends the heights of one line; memory grows with the actual data.
void read_line(const bytes::Archive& archive, const ScanField& field, Index scan, Index line,
               std::vector<double>& heights) {
    const auto member = line_member(field, scan, line);
    const auto description = archive.member(member + ".dsc");
    const auto columns = read_columns(description);
    const auto at = std::find(columns.names.begin(), columns.names.end(), nmm_height_column);
    if (at == columns.names.end())
        throw FormatError(
            description.name, {},
            fmt::format("NMM: no column '{}', got {}", nmm_height_column, fmt::join(columns.names, ", ")));
    if (columns.points != field.points)
        throw FormatError(description.name, {},
                          fmt::format("NMM: a line of {} points, expected {}", columns.points, field.points));
    const auto column = static_cast<std::size_t>(at - columns.names.begin());
    const auto data = archive.member(member + ".dat");
    const auto text = data.all();
    std::vector<std::string_view> cells;
    Index row = 0;
    for (const auto raw : bytes::split_lines(text)) {
        tables::split_cells(raw, ' ', cells);
        if (cells.empty()) continue;
        if (row == field.points)
            broken_nmm(data, static_cast<std::uint64_t>(row) + 1,
                       fmt::format("more rows than the {} points announced", field.points));
        double value = 0.0;
        if (cells.size() != columns.names.size() || !bytes::parse_cell(cells[column], '.', value))
            broken_nmm(data, static_cast<std::uint64_t>(row) + 1,
                       fmt::format("'{:.60}', expected {} numbers", trimmed(raw), columns.names.size()));
        heights.push_back(value);
        ++row;
    }
    if (row != field.points)
        broken_nmm(data, static_cast<std::uint64_t>(row) + 1,
                   fmt::format("the member ends after {} of {} points", row, field.points));
}

topography::Measurement read_scan(const bytes::Source& source, const ScanField& field, Index scan,
                                  const topography::Metadata& metadata) {
    const bytes::Archive archive(source);
    std::vector<double> heights;
    for (Index line = 0; line < field.lines; ++line) read_line(archive, field, scan, line, heights);
    const Eigen::Map<const Array2D> lines(heights.data(), field.lines, field.points);
    if (field.lines == 1)
        return checked(topography::LineScan{lines.row(0).transpose(), field.dx * static_cast<double>(field.points),
                                            false, metadata},
                       source);
    const std::array<double, 2> size{field.dx * static_cast<double>(field.points),
                                     field.dy * static_cast<double>(field.lines)};
    return checked(topography::HeightMap{lines.transpose(), size, false, metadata}, source);
}

void require_members(const bytes::Archive& archive, const ScanField& field, const bytes::Source& source) {
    if (archive.names().size() < 2 * static_cast<std::uint64_t>(field.scans) * static_cast<std::uint64_t>(field.lines))
        throw FormatError(
            source.name, {},
            fmt::format("NMM: {} scans of {} lines announced, the archive has {} members; it is not complete",
                        field.scans, field.lines, archive.names().size()));
    for (Index scan = 0; scan < field.scans; ++scan)
        for (Index line = 0; line < field.lines; ++line)
            for (const auto* ending : {".dsc", ".dat"})
                if (const auto name = line_member(field, scan, line) + ending; !archive.has(name))
                    throw FormatError(source.name, {},
                                      fmt::format("NMM: no member '{}'; the archive is not complete", name));
}

/// Unit of the other columns of the instrument; empty for those of unknown meaning.
std::string column_unit(std::string_view name) {
    for (const auto* length : {"Lx", "Ly", "Lz", "Az", "Az0", "Az1", "XY vector"})
        if (name == length) return "m";
    return name == "Ax" ? "V" : "";
}

std::vector<Channel> open_nmm(const bytes::Source& source, const ReadOptions& options) {
    const bytes::Archive archive(source);
    const auto field = read_field(archive, description_member(archive));
    require_members(archive, field, source);
    std::vector<Channel> channels;
    for (Index scan = 0; scan < field.scans; ++scan) {
        ChannelInfo info{.name = fmt::format("scan {}", scan + 1), .format = "nmm"};
        info.shape =
            field.lines == 1 ? std::vector<Index>{field.points} : std::vector<Index>{field.points, field.lines};
        info.size = {field.dx * static_cast<double>(field.points)};
        if (field.lines > 1) info.size.push_back(field.dy * static_cast<double>(field.lines));
        if (field.lines > 1)
            info.orientation =
                "lines in the order of their numbers from the top; not stated in the file, taken as Gwyddion does";
        info.unit = "m";
        info.metadata.acquisition_time = field.date;
        info.metadata.instrument.name = "SIOS nanomeasuring machine";
        (void)complete(info, options, source);
        auto read = [source, field, scan, metadata = info.metadata] {
            return read_scan(source, field, scan, metadata);
        };
        channels.push_back({info, std::move(read)});
        for (const auto& column : read_columns(archive.member(line_member(field, scan, 0) + ".dsc")).names) {
            if (column == nmm_height_column) continue;
            auto other = info;
            other.name = fmt::format("scan {}: {}", scan + 1, column);
            other.unit = column_unit(column);
            channels.push_back(non_height_channel(std::move(other)));
        }
    }
    return channels;
}

Match detect_nmm(std::string_view head, const bytes::Source& source) {
    if (!bytes::is_zip(head)) return Match::no;
    return description_member(bytes::Archive(source)).empty() ? Match::no : Match::yes;
}

}  // namespace

Format nmm_format() {
    return {
        .identifier = "nmm",
        .name = "Nanomeasuring machine",
        .extensions = ".zip",
        .description =
            "ZIP archives of the SIOS nanomeasuring machine: a description and a pair of .dsc and .dat a line; a channel a scan, a map or a profile",
        .heights = "the column -Lz+Az in metres; 'nan' is undefined",
        .orientation = "lines in the order of their numbers, from the top",
        .not_read = "other columns are listed; positions are those of the grid, not the measured ones",
        .reference =
            "nmmxyz module of Gwyddion, NMM reader of SurfaceTopography 1.27; not tested on an instrument "
            "file",
        .carries_scale = true,
        .detect = detect_nmm,
        .open = open_nmm};
}

}  // namespace setae::formats
