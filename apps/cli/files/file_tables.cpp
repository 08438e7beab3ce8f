// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "files/channel_lines.hpp"
#include "files/listed_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/named_choice.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::cli::info_command {
namespace {

namespace fs = std::filesystem;
using study::FileKind;
using tables::TidyTable;

constexpr int digits = 3;

/// Values with one unit if all have the same prefix: "5.00 × 5.00 µm", "-90.1 nm … 1.20 µm". Zero fits any prefix.
std::string joined_values(const std::vector<double>& values, const char* unit, const char* separator) {
    std::vector<std::string> numbers, texts;
    std::string shared;
    bool same = true;
    for (const double value : values) {
        texts.push_back(value == 0.0 ? "0" : format_value(value, unit, digits));
        const auto blank = texts.back().rfind(' ');
        numbers.push_back(texts.back().substr(0, blank));
        if (blank == std::string::npos) continue;
        same = same && (shared.empty() || texts.back().substr(blank) == shared);
        shared = texts.back().substr(blank);
    }
    return same ? fmt::format("{}{}", fmt::join(numbers, separator), shared)
                : fmt::format("{}", fmt::join(texts, separator));
}

std::string shape_text(const std::vector<Index>& shape) { return fmt::format("{}", fmt::join(shape, " × ")); }

std::string bytes_for_readers(std::uint64_t bytes) {
    const auto value = static_cast<double>(bytes);
    return bytes >= 1'000'000'000 ? fmt::format("{:.1f} GB", 1e-9 * value) : fmt::format("{:.0f} MB", 1e-6 * value);
}

/// The range of the heights of a channel, or the reason why there is none.
std::string heights_text(const ListedFile& file, const ListedChannel& channel) {
    const auto& heights = channel.heights;
    if (!heights.error.empty() || channel.info.format.empty()) return "unreadable";
    if (!channel.info.is_height)
        return channel.info.not_heights.empty() ? "no heights" : "not heights: " + channel.info.not_heights;
    if (heights.read) return joined_values({heights.least, heights.greatest}, "m", " … ");
    if (!can_be_read(channel.info) || !file.too_large) return "";
    return fmt::format("not read: {}, --heights", bytes_for_readers(file.bytes));
}

/// Missing metadata of a channel of heights; the date only with Detail::all.
std::string missing_text(const formats::ChannelInfo& info, Detail detail) {
    if (!info.is_height) return "";
    auto names = formats::missing(info);
    if (detail != Detail::all) std::erase(names, "date");
    if (detail == Detail::little || !info.metadata.instrument.type.empty()) std::erase(names, "instrument");
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Names of channels and instruments are shortened unless all details are listed.
std::string name_text(const std::string& name, Detail detail) {
    constexpr std::size_t longest = 22, longest_of_little = 16;
    return detail == Detail::all ? name : shortened(name, detail == Detail::usual ? longest : longest_of_little);
}

std::string instrument_text(const topography::Instrument& instrument) {
    return instrument.name.empty() ? instrument.type : instrument.name;
}

/// Files of one kind, and their names in the tables.
struct Listing {
    std::vector<const ListedFile*> files;
    std::function<std::string(const std::string&)> shown;  ///< path as printed in the tables
    Detail detail;
};

void add_channel(TidyTable& table, const Listing& listing, const ListedFile& file, const ListedChannel& channel) {
    const auto& info = channel.info;
    const auto& heights = channel.heights;
    std::vector<TidyTable::Cell> row{
        listing.shown(file.content.file),
        info.format,
        name_text(fmt::format("{} {}", channel.index, info.name), listing.detail),
        shape_text(info.shape),
        info.size.empty() ? "" : joined_values(info.size, "m", " × "),
        heights_text(file, channel),
        heights.read && heights.undefined_count > 0 ? percent(heights.undefined_share()) : "",
        name_text(instrument_text(info.metadata.instrument), listing.detail),
        missing_text(info, listing.detail)};
    if (listing.detail == Detail::all) {
        row.emplace_back(heights.read ? format_value(heights.standard_deviation, "m", 5) : "");
        row.emplace_back(info.unit);
        row.emplace_back(info.metadata.acquisition_time);
        row.emplace_back(info.orientation);
    }
    table.rows.push_back(std::move(row));
}

/// True for channels of heights, and for the first channel of a file without heights.
bool is_shown(const ListedFile& file, const ListedChannel& channel, Detail detail) {
    const auto holds_heights = [](const ListedChannel& c) { return c.info.is_height; };
    return detail == Detail::all || channel.info.is_height ||
           (&channel == &file.channels.front() &&
            std::none_of(file.channels.begin(), file.channels.end(), holds_heights));
}

TidyTable table_of_channels(const Listing& listing) {
    TidyTable table{
        "", {"file", "format", "channel", "points", "size", "heights", "undefined", "instrument", "missing"}, {}};
    if (listing.detail == Detail::all)
        for (const char* column : {"rms", "unit of the file", "date", "orientation"})
            table.columns.emplace_back(column);
    for (const auto* file : listing.files)
        for (const auto& channel : file->channels)
            if (is_shown(*file, channel, listing.detail)) add_channel(table, listing, *file, channel);
    return table;
}

/// "0 HAADF of 3": the image that is described; with Detail::all every image with its kind.
std::string image_text(const imaging::PictureContent& picture, Detail detail) {
    const auto& images = picture.images;
    if (images.size() < 2) return images.empty() ? "" : name_text(images.front().title, detail);
    if (detail != Detail::all || picture.frames > 1)
        return fmt::format("{} {} of {}", picture.image, name_text(images[picture.image].title, detail), images.size());
    std::vector<std::string> names;
    for (const auto& image : images)
        names.push_back(image.is_picture() ? image.title : fmt::format("{} ({})", image.title, image.kind));
    return numbered_names(names);
}

TidyTable table_of_pictures(const Listing& listing) {
    TidyTable table{
        "", {"file", "format", "image", "pixels", "frames", "pixel size", "size", "instrument", "missing"}, {}};
    if (listing.detail == Detail::all) table.columns.emplace_back("date");
    for (const auto* file : listing.files) {
        const auto& picture = *file->content.picture;
        const auto& pixel = picture.pixel_size;
        constexpr double as_good_as_square = 1e-3;
        const bool square = pixel && std::abs(pixel->x / pixel->y - 1.0) < as_good_as_square;
        std::vector<TidyTable::Cell> row{listing.shown(file->content.file),
                                         picture.format,
                                         image_text(picture, listing.detail),
                                         fmt::format("{} × {}", picture.width, picture.height),
                                         picture.frames > 1 ? fmt::format("{}", picture.frames) : "",
                                         !pixel   ? ""
                                         : square ? format_value(pixel->x, "m", digits)
                                                  : joined_values({pixel->x, pixel->y}, "m", " × "),
                                         pixel ? joined_values({pixel->x * static_cast<double>(picture.width),
                                                                pixel->y * static_cast<double>(picture.height)},
                                                               "m", " × ")
                                               : "",
                                         name_text(picture.instrument, listing.detail),
                                         pixel                ? ""
                                         : picture.frames > 1 ? "--pixel"
                                                              : "--pixel or --scale-bar"};
        if (listing.detail == Detail::all) row.emplace_back(picture.acquisition_time);
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// Smallest and largest value of a column; empty for a column without values.
std::vector<double> range_of(const Table& table, const char* name) {
    const auto* column = table.find(name);
    if (column == nullptr || column->values.isNaN().all()) return {};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {column->values.isNaN().select(infinity, column->values).minCoeff(),
            column->values.isNaN().select(-infinity, column->values).maxCoeff()};
}

std::string range_text(const Table& table, const char* name) {
    const auto range = range_of(table, name);
    return range.empty() ? "" : joined_values(range, table.find(name)->unit.c_str(), " … ");
}

std::string largest_text(const Table& table, const char* name) {
    const auto range = range_of(table, name);
    return range.empty() ? "" : format_value(range.back(), table.find(name)->unit, digits);
}

std::string column_names(const Table& table, Detail detail) {
    constexpr std::size_t longest = 40;
    std::vector<std::string> names;
    for (const auto& column : table.columns) names.push_back(column.name);
    const auto text = fmt::format("{}", fmt::join(names, ", "));
    return detail == Detail::all ? text : shortened(text, longest);
}

/// Options for the metadata that fits need and the file does not contain.
std::string missing_text(const study::FileContent& content) {
    std::string text;
    for (const auto& name : content.missing) {
        const char* option = name == "sphere_radius"     ? "--radius"
                             : name == "spring_constant" ? "--spring-constant"
                             : name == "sensitivity"     ? "--sensitivity"
                                                         : "--map";
        text += fmt::format("{}{}", text.empty() ? "" : ", ", option);
    }
    return text;
}

TidyTable table_of_loops(const Listing& listing) {
    TidyTable table{
        "", {"file", "format", "curves", "samples", "force", "displacement", "radius up to", "columns", "missing"}, {}};
    for (const auto* file : listing.files) {
        const auto& content = file->content;
        const auto& record = *content.table;
        const bool foreign =
            std::find(content.missing.begin(), content.missing.end(), "columns") != content.missing.end();
        table.rows.push_back({listing.shown(content.file), content.format,
                              content.curves > 1 ? fmt::format("{}", content.curves) : "",
                              fmt::format("{}", record.rows()), range_text(record, "force"),
                              range_text(record, "displacement"), largest_text(record, "contact_radius"),
                              foreign || listing.detail == Detail::all ? column_names(record, listing.detail) : "",
                              missing_text(content)});
    }
    return table;
}

/// Quantity of the first column of a table, with its conversion to a wavevector.
std::string convention_text(const std::string& quantity) {
    if (quantity == "frequency") return "frequency, q = 2π f";
    return quantity == "wavelength" ? "wavelength, q = 2π/λ" : "wavevector q";
}

TidyTable table_of_spectra(const Listing& listing) {
    TidyTable table{"", {"file", "density", "units", "first column", "points", "wavelengths", "errors"}, {}};
    for (const auto* file : listing.files) {
        const auto& spectrum = *file->content.table;
        const auto& q = spectrum.at("wavevector");
        const double shortest = 2.0 * pi / q[q.size() - 1], longest = q[0] > 0.0 ? 2.0 * pi / q[0] : undefined;
        table.rows.push_back(
            {listing.shown(file->content.file), spectrum.columns[1].name,
             spectrum.metadata.at("units_of_file") + (spectrum.metadata.contains("units") ? " (assumed)" : ""),
             convention_text(spectrum.metadata.at("quantity")), fmt::format("{}", spectrum.rows()),
             joined_values({shortest, longest}, "m", " … "),
             spectrum.find("standard_error") != nullptr ? "yes" : "no"});
    }
    return table;
}

TidyTable table_of_studies(const Listing& listing) {
    TidyTable table{"", {"file", "title", "surfaces", "elastomers", "experiments"}, {}};
    for (const auto* file : listing.files) {
        const auto& study = *file->content.study;
        table.rows.push_back({listing.shown(file->content.file), name_text(study.title, listing.detail),
                              fmt::format("{}", study.surfaces.size()), fmt::format("{}", study.elastomers.size()),
                              fmt::format("{}", study.experiments.size())});
    }
    return table;
}

TidyTable table_of_names(const Listing& listing) {
    TidyTable table{"", {"file"}, {}};
    for (const auto* file : listing.files) table.rows.push_back({listing.shown(file->content.file)});
    return table;
}

/// A kind of file: title of its table, and the function that makes the table.
struct Kind {
    FileKind kind;
    const char* title;
    TidyTable (*table)(const Listing&);
};
constexpr Kind kinds[] = {{FileKind::topography, "Topographies", table_of_channels},
                          {FileKind::container, "Containers", table_of_channels},
                          {FileKind::micrograph, "Micrographs", table_of_pictures},
                          {FileKind::recording, "Recordings", table_of_pictures},
                          {FileKind::loop, "Loops", table_of_loops},
                          {FileKind::force_curve, "Force curves", table_of_loops},
                          {FileKind::spectrum, "Spectra", table_of_spectra},
                          {FileKind::study, "Studies", table_of_studies},
                          {FileKind::recipe, "Recipes", table_of_names},
                          {FileKind::mapping, "Mappings", table_of_names},
                          {FileKind::pipeline, "Processing", table_of_names}};

/// "Loops: setae jkr fit, jkr energy".
std::string heading(const Kind& kind) {
    std::string commands;
    for (const auto& command : study::commands_for(kind.kind))
        commands += commands.empty() ? command : ", " + command.substr(std::string_view("setae ").size());
    return fmt::format("{}: {}", kind.title, commands);
}

/// The folder that contains all files; empty for the current folder.
fs::path common_folder(const std::vector<ListedFile>& files) {
    auto common = fs::path(files.front().content.file).parent_path();
    for (const auto& file : files) {
        const auto folder = fs::path(file.content.file).parent_path();
        const auto [end, ignored] = std::mismatch(common.begin(), common.end(), folder.begin(), folder.end());
        fs::path shared;
        for (auto part = common.begin(); part != end; ++part) shared /= *part;
        common = shared;
    }
    return common;
}

/// Rows grouped by folders, each below a row for its folder, if a file is in a folder.
TidyTable by_folder(TidyTable table) {
    std::vector<std::vector<TidyTable::Cell>> rows;
    std::string last;
    for (auto& row : table.rows) {
        const fs::path path(std::get<std::string>(row.front()));
        if (const auto folder = path.parent_path().string(); folder != last) {
            rows.emplace_back(row.size(), std::string());
            rows.back().front() = (folder.empty() ? "." : folder) + "/";
            last = folder;
        }
        if (!last.empty()) row.front() = "  " + path.filename().string();
        rows.push_back(std::move(row));
    }
    table.rows = std::move(rows);
    return table;
}

/// Beginning and end of a name with "…" between them, at most `width` characters.
std::string middle_cut(const std::string& name, std::size_t width) {
    if (display_width(name) <= width) return name;
    const auto end = name.size() - std::min(name.size(), width / 2);
    auto from = end;
    while (from < name.size() && (static_cast<unsigned char>(name[from]) & 0xc0) == 0x80) ++from;  // within a character
    return shortened(name, width - display_width(name.substr(from))) + name.substr(from);
}

/// Characters of the widest line of a table.
std::size_t width_of(TidyTable table) {
    constexpr std::size_t any_width = 100000;
    table.title.clear();
    const auto text = tables::as_text_within(table, any_width);
    std::size_t width = 0;
    for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
        width = std::max(width, display_width(text.substr(at, text.find('\n', at) - at)));
    return width;
}

/// The table with names of files shortened to fit a width; nothing if the names could not be distinguished.
std::optional<TidyTable> with_shorter_names(TidyTable table, std::size_t width) {
    constexpr std::size_t min_name = 18;
    const auto needed = width_of(table);
    if (needed <= width) return table;
    std::size_t longest = 0;
    for (const auto& row : table.rows) longest = std::max(longest, display_width(std::get<std::string>(row.front())));
    if (longest < needed - width + min_name) return std::nullopt;
    for (auto& row : table.rows)
        row.front() = middle_cut(std::get<std::string>(row.front()), longest - (needed - width));
    return table;
}

/// The table without the columns that Detail::little leaves out.
TidyTable compact_table(const TidyTable& table) {
    static const std::set<std::string> dispensable{"format", "frames", "undefined", "instrument", "radius up to"};
    TidyTable kept{table.title, {}, std::vector<std::vector<TidyTable::Cell>>(table.rows.size())};
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (dispensable.contains(table.columns[i])) continue;
        kept.columns.push_back(table.columns[i]);
        for (std::size_t r = 0; r < table.rows.size(); ++r) kept.rows[r].push_back(table.rows[r][i]);
    }
    return kept;
}

/// Options for missing size and unit, and for channels that are not listed.
std::string hint(const Listing& listing) {
    std::size_t hidden = 0;
    bool open = false;
    for (const auto* file : listing.files) {
        if (file->content.table) continue;
        for (const auto& channel : file->channels) {
            hidden += is_shown(*file, channel, listing.detail) ? 0 : 1;
            open = open || (channel.info.is_height && !channel.info.format.empty() && !can_be_read(channel.info));
        }
    }
    return (open ? "  missing metadata: give --size and --unit, in a study the keys size and unit\n" : std::string()) +
           (hidden > 0 ? fmt::format("  {} channel{} without heights not listed; --long lists all channels\n", hidden,
                                     hidden == 1 ? "" : "s")
                       : std::string());
}

/// The table of a kind in the most detailed form that fits, with hints.
std::string text_of(Listing listing, const Kind& kind, std::size_t width) {
    const auto made = [&](Detail detail) {
        listing.detail = detail;
        auto table = kind.table(listing);
        table.title = heading(kind);
        return table;
    };
    if (listing.detail == Detail::all) return tables::as_text_within(made(Detail::all), width) + hint(listing);
    const auto usual = made(Detail::usual);
    const auto notes = hint(listing);
    if (const auto fitting = with_shorter_names(by_folder(usual), width))
        return tables::as_text_within(*fitting, width) + notes;
    if (const auto fitting = with_shorter_names(compact_table(by_folder(made(Detail::little))), width))
        return tables::as_text_within(*fitting, width) + notes + "  --long also lists format and instrument\n";
    return tables::as_text_within(usual, width) + notes;
}

}  // namespace

std::string file_tables(const std::vector<ListedFile>& files, Detail detail, std::size_t width) {
    if (files.empty()) return "";
    const auto folder = common_folder(files);
    std::string text = folder.empty() ? "" : fmt::format("In {}\n", folder.string());
    const auto shown = [&folder](const std::string& path) {
        return folder.empty() ? path : fs::path(path).lexically_relative(folder).string();
    };
    for (const auto& kind : kinds) {
        Listing listing{{}, shown, detail};
        for (const auto& file : files)
            if (file.content.kind == kind.kind) listing.files.push_back(&file);
        if (!listing.files.empty()) text += (text.empty() ? "" : "\n") + text_of(listing, kind, width);
    }
    return text;
}

}  // namespace setae::cli::info_command
