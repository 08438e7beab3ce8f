// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/file_content.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "setae/bytes/expand.hpp"
#include "setae/bytes/text.hpp"
#include "setae/bytes/toml_reader.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"
#include "setae/study/open_loop.hpp"
#include "setae/study/pipeline_file.hpp"
#include "setae/study/study_keys.hpp"
#include "setae/tables/column_guess.hpp"
#include "setae/tables/force_curve.hpp"
#include "setae/tables/force_map.hpp"
#include "setae/tables/loop_file.hpp"
#include "setae/tables/mapping.hpp"
#include "setae/tables/spreadsheet.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study {
namespace {

/// "[surfaces.NAME]" is a table of the key "surfaces".
std::string first_key(const std::string& table) {
    const auto begin = table.find_first_not_of('[');
    return begin == std::string::npos ? "" : table.substr(begin, table.find_first_of(".]", begin) - begin);
}

/// Whether a document has a table that a study may have.
bool has_table_of_study(const toml::table& document) {
    const auto tables = study_keys();
    return std::any_of(tables.begin(), tables.end(), [&](const KeyTable& table) {
        return table.name.starts_with('[') && document.contains(first_key(table.name));
    });
}

FileContent content_of_toml(const std::string& file) {
    const auto document = bytes::parse_toml_file(file);
    FileContent content{.file = file, .kind = FileKind::study, .format = "toml"};
    if (document.contains("steps")) {
        (void)read_pipeline(file);
        content.kind = FileKind::pipeline;
    } else if (document.contains("table") && document.contains("columns")) {
        (void)tables::read_mapping(file);
        content.kind = FileKind::mapping;
    } else if (document.contains("protocols") || document.contains("seed")) {
        content.kind = FileKind::recipe;
    } else if (has_table_of_study(document)) {
        content.study = read_study(file);
    } else {
        throw FormatError(file, {},
                          "TOML without a known key; expected a study ([surfaces.NAME], [[experiments]] …), a recipe "
                          "([protocols.NAME]), a mapping ([columns.NAME], [table]) or processing ([[steps]])");
    }
    return content;
}

/// The missing constants of a force curve.
std::vector<std::string> names_in(const std::string& list) {
    std::vector<std::string> names;
    for (std::size_t at = 0; at < list.size();) {
        const auto end = std::min(list.find(", ", at), list.size());
        names.push_back(list.substr(at, end - at));
        at = end + 2;
    }
    return names;
}

/// Content of a file of force curves, the first of which is described.
FileContent content_of_force_curve(const std::string& file, const bytes::Source& source, std::string format) {
    const auto curves = tables::open_force_curves(source);
    auto curve = curves.read(curves.numbers.front()).table;
    FileContent content{.file = file, .kind = FileKind::force_curve, .format = std::move(format)};
    content.curves = curves.numbers.size();
    if (content.curves > 1)
        content.note = fmt::format("{} force curves, numbered {} to {}", content.curves, curves.numbers.front(),
                                   curves.numbers.back());
    if (const auto missing = curve.metadata.find("missing"); missing != curve.metadata.end())
        content.missing = names_in(missing->second);
    content.table = std::move(curve);
    return content;
}

/// A loop that can be fitted; missing metadata are listed.
FileContent content_of_loop(const std::string& file) {
    auto opened = open_loop({.file = file});
    FileContent content{.file = file, .kind = FileKind::loop, .format = ""};
    if (!(bodies_stated_in(opened.table).values.radius > 0.0)) content.missing.emplace_back("sphere_radius");
    content.table = std::move(opened.table);
    return content;
}

/// Columns of a loop that the header of a text or workbook names by words.
struct NamedColumns {
    bool force = false, displacement = false, contact_radius = false, time = false;
    bool text = false;  ///< one of its columns holds no numbers

    [[nodiscard]] bool loop() const { return force && (displacement || contact_radius); }
    /// A record that needs columns given by the user for a force or a radius.
    [[nodiscard]] bool foreign() const { return time && (force || displacement) && !text; }
};

/// Whole lines from the beginning of a text, enough for its header and some numbers; a workbook whole; nothing of
/// others.
std::optional<bytes::Source> beginning_of(const bytes::Source& source) {
    constexpr std::uint64_t enough = 16384;
    auto text = source.head(enough);
    if (!bytes::looks_like_text(text)) return tables::is_spreadsheet(source) ? std::optional(source) : std::nullopt;
    if (text.size() < source.size) text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
    return bytes::memory_source(source.name, std::move(text));
}

NamedColumns named_columns(const bytes::Source& source, const std::string& file) {
    constexpr double by_word = 0.75;  // a lower confidence is only a symbol or a unit, which heights may have, too
    NamedColumns named;
    try {
        const auto beginning = beginning_of(source);
        if (!beginning) return named;
        const auto guess = tables::guess_columns(tables::read_raw_table(*beginning), file);
        const auto has = [&](const char* role, double confidence) {
            return std::any_of(guess.roles.begin(), guess.roles.end(), [&](const auto& found) {
                return found.role == role &&
                       std::any_of(found.candidates.begin(), found.candidates.end(),
                                   [&](const auto& candidate) { return candidate.confidence >= confidence; });
            });
        };
        const bool text = std::any_of(guess.columns.begin(), guess.columns.end(),
                                      [](const auto& column) { return column.note.starts_with("text"); });
        named = {has("force", 0.0), has("displacement", by_word), has("contact_radius", 0.5), has("time", by_word),
                 text};
    } catch (const Error&) {  // no table; other readers report its kind
    }
    return named;
}

/// A record in time of which columns are named, but not all a fit needs.
FileContent content_of_foreign_loop(const std::string& file, const std::string& reason) {
    FileContent content{.file = file, .kind = FileKind::loop, .format = ""};
    content.table = tables::read_table(file);
    content.missing.emplace_back("columns");
    content.note = reason;
    return content;
}

std::optional<FileContent> loop_by_columns(const std::string& file, const NamedColumns& named) {
    if (!named.loop()) return std::nullopt;
    try {
        return content_of_loop(file);
    } catch (const FormatError& error) {
        return content_of_foreign_loop(file, error.what());
    }
}

FileContent content_of_spectrum(const std::string& file, const FileQuestions& questions) {
    FileContent content{.file = file, .kind = FileKind::spectrum, .format = ""};
    content.table = tables::read_power_spectrum_table(file, questions.spectrum);
    for (const char* key : {"converted", "assumed"})
        if (const auto said = content.table->metadata.find(key); said != content.table->metadata.end())
            content.note = said->second;
    return content;
}

FileContent content_of_picture(const std::string& file, imaging::PictureContent picture) {
    constexpr std::size_t min_frames = 3;  // two pages are a picture and its copy
    const auto kind = picture.frames >= min_frames ? FileKind::recording : FileKind::micrograph;
    FileContent content{.file = file, .kind = kind, .format = picture.format};
    content.picture = std::move(picture);
    return content;
}

FileContent content_of_heights(const std::string& file, const formats::ReadOptions& options) {
    const auto source = bytes::unpacked(bytes::file_source(file));
    const auto& format = formats::detect_format(source);
    return {.file = file,
            .kind = format.is_container ? FileKind::container : FileKind::topography,
            .format = format.identifier,
            .channels = formats::open(source, format, options)};
}

/// NT-MDT's text has no header: three columns of numbers may also be heights, which are kept in addition to the curve.
std::optional<FileContent> content_of_guessed_curve(const std::string& file, const bytes::Source& source,
                                                    const formats::ReadOptions& options) {
    if (options.layout || options.size || options.unit) return std::nullopt;  // these options imply heights
    auto content = content_of_force_curve(file, source, "nt-mdt");
    try {
        content.channels = content_of_heights(file, options).channels;
    } catch (const Error&) {  // no heights then
    }
    return content;
}

/// Whether a file is a picture whose grey levels are not declared as heights: TIFF contains both.
bool is_picture_first(const FileContent& content, const FileQuestions& questions) {
    return content.format == "tiff" && !questions.heights.unit &&
           std::all_of(content.channels.begin(), content.channels.end(),
                       [](const formats::Channel& channel) { return channel.info.unit.empty(); });
}

/// Whether the first channel states its size and unit, and thus the meaning of the columns of a text.
bool is_certain(const FileContent& content) {
    const auto& info = content.channels.front().info;
    return !info.size.empty() && !info.unit.empty();
}

bool is_hdf5(const bytes::Source& source) { return source.head(8).starts_with("\x89HDF"); }

/// Pictures in HDF5 have precedence over their arrays. @throws as picture_content for data that begin as a picture.
std::optional<imaging::PictureContent> picture_in_hdf5(const std::string& file, const bytes::Source& source) {
    if (!is_hdf5(source)) return std::nullopt;
    try {
        return imaging::picture_content(file);
    } catch (const Error&) {  // an array, not a picture
        return std::nullopt;
    }
}

FileContent content_of_measurement(const std::string& file, const bytes::Source& source,
                                   const FileQuestions& questions) {
    if (auto picture = picture_in_hdf5(file, source)) return content_of_picture(file, std::move(*picture));
    const auto named = named_columns(source, file);
    if (auto loop = loop_by_columns(file, named)) return std::move(*loop);
    try {
        auto content = content_of_heights(file, questions.heights);
        if (is_picture_first(content, questions))
            if (auto picture = imaging::picture_content(file)) return content_of_picture(file, std::move(*picture));
        if (!named.foreign() || is_certain(content)) return content;
    } catch (const Error&) {
        if (!named.foreign()) {
            if (is_hdf5(source)) throw;  // no picture, as determined above: the reason is that of the arrays
            if (auto picture = imaging::picture_content(file)) return content_of_picture(file, std::move(*picture));
            throw;
        }
    }
    return content_of_foreign_loop(file, named.force
                                             ? "no column of displacement or contact radius"
                                             : "no column of force; a mapping can define force from the other columns");
}

bool ends_with_any(const std::string& file, std::initializer_list<const char*> endings) {
    const auto ending = bytes::lowered(std::filesystem::path(file).extension().string());
    return std::any_of(endings.begin(), endings.end(), [&](const char* known) { return ending == known; });
}

}  // namespace

std::string name(FileKind kind) {
    switch (kind) {
        case FileKind::topography: return "topography";
        case FileKind::container: return "container";
        case FileKind::micrograph: return "micrograph";
        case FileKind::recording: return "recording";
        case FileKind::loop: return "loop";
        case FileKind::force_curve: return "force_curve";
        case FileKind::spectrum: return "spectrum";
        case FileKind::study: return "study";
        case FileKind::recipe: return "recipe";
        case FileKind::mapping: return "mapping";
        case FileKind::pipeline: return "pipeline";
    }
    throw InternalError("a kind of file without a name");
}

std::vector<std::string> commands_for(FileKind kind) {
    switch (kind) {
        case FileKind::topography: return {"setae check", "setae psd", "setae params", "setae adhesion", "setae level"};
        case FileKind::container: return {"setae container check", "setae psd", "setae params", "setae adhesion"};
        case FileKind::micrograph: return {"setae contour"};
        case FileKind::recording: return {"setae jkr radius"};
        case FileKind::loop: return {"setae jkr fit", "setae jkr energy", "setae jkr import"};
        case FileKind::force_curve: return {"setae jkr fit", "setae jkr import"};
        case FileKind::spectrum: return {"setae psd", "setae params", "setae adhesion", "setae synthesize --spectrum"};
        case FileKind::study: return {"setae study", "setae plot"};
        case FileKind::recipe: return {"setae lab make", "setae lab closure"};
        case FileKind::mapping: return {"setae jkr fit --map", "setae jkr import --map"};
        case FileKind::pipeline: return {"setae level --pipeline"};
    }
    throw InternalError("a kind of file without a command");
}

FileContent file_content(const std::string& file, const FileQuestions& questions) {
    const auto source = bytes::file_source(file);
    if (questions.is_spectrum) return content_of_spectrum(file, questions);
    if (ends_with_any(file, {".toml"})) return content_of_toml(file);
    if (ends_with_any(file, {".yml", ".yaml"})) {
        (void)read_pipeline(file);
        return {.file = file, .kind = FileKind::pipeline, .format = "yaml"};
    }
    if (tables::is_loop_file(source)) return content_of_loop(file);
    if (auto format = tables::force_curve_format(source)) {
        if (*format != "nt-mdt") return content_of_force_curve(file, source, std::move(*format));
        if (auto curve = content_of_guessed_curve(file, source, questions.heights)) return std::move(*curve);
    }
    if (tables::is_power_spectrum_table(source)) return content_of_spectrum(file, questions);
    return content_of_measurement(file, source, questions);
}

}  // namespace setae::study
