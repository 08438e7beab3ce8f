// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Contents of files, as the JSON of `setae info` has them.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "setae/answers/contents.hpp"
#include "setae/fields/describe.hpp"

namespace setae::answers {

/// A channel and its file.
struct ChannelEntry {
    const std::string* file;
    const ListedChannel* channel;

    [[nodiscard]] const formats::ChannelInfo& info() const { return channel->info; }
    [[nodiscard]] const HeightSummary& heights() const { return channel->heights; }
    [[nodiscard]] const topography::Instrument& instrument() const { return info().metadata.instrument; }
};
[[nodiscard]] inline std::vector<ChannelEntry> channels_of(const Contents& contents) {
    std::vector<ChannelEntry> entries;
    for (const auto& file : contents.files)
        for (const auto& channel : file.channels) entries.push_back({&file.content.file, &channel});
    return entries;
}

/// Name and unit of a column.
struct ColumnEntry {
    std::string name, unit;
};
[[nodiscard]] inline std::vector<ColumnEntry> columns_of(const Table& table) {
    std::vector<ColumnEntry> entries;
    for (const auto& column : table.columns) entries.push_back({column.name, column.unit});
    return entries;
}

/// A table of a spectrum.
struct SpectrumEntry {
    std::string density, quantity, units_of_file;
    bool units_assumed = false;
    Band band;
};
[[nodiscard]] inline std::optional<SpectrumEntry> spectrum_of(const study::FileContent& content) {
    if (!content.table || content.kind != study::FileKind::spectrum) return std::nullopt;
    const auto& table = *content.table;
    const auto& q = table.at("wavevector");
    return SpectrumEntry{table.columns[1].name,
                         table.metadata.at("quantity"),
                         table.metadata.at("units_of_file"),
                         table.metadata.contains("units"),
                         {q[0], q[q.size() - 1]}};
}

/// A path without a result.
struct FailedPath {
    std::string path, reason;
};
[[nodiscard]] inline std::vector<FailedPath> failed_paths(const Contents& contents) {
    std::vector<FailedPath> entries;
    for (const auto& failed : contents.failed) entries.push_back({failed.path, failed.reason});
    return entries;
}

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<answers::ChannelEntry> {
    using T = answers::ChannelEntry;
    static constexpr std::array rows_of_instrument{
        made<T>("name", "name of the instrument; empty where it is not given",
                [](const T& of) -> const auto& { return of.instrument().name; }),
        made<T>("type", "type of the instrument; empty where it is not given",
                [](const T& of) -> const auto& { return of.instrument().type; }),
        made<T>("tip_radius", "radius of the tip", [](const T& of) { return of.instrument().tip_radius; })
            .or_null()
            .in_unit("m"),
        made<T>("tip_radius_standard_error", "standard error of the tip radius",
                [](const T& of) { return of.instrument().tip_radius_standard_error; })
            .or_null()
            .in_unit("m"),
        made<T>("resolution", "shortest wavelength that the instrument resolves",
                [](const T& of) { return of.instrument().resolution; })
            .or_null()
            .in_unit("m"),
    };
    static constexpr Description instrument{"", "instrument, as the file states it", rows_of_instrument};
    static constexpr std::array rows{
        made<T>("file", "name of the file as it was given", [](const T& of) -> const auto& { return *of.file; }),
        made<T>("channel", "number of the channel within the file, counted from 0",
                [](const T& of) { return of.channel->index; }),
        made<T>("format", "identifier of the format", [](const T& of) -> const auto& { return of.info().format; }),
        made<T>("name", "name of the channel in the file", [](const T& of) -> const auto& { return of.info().name; }),
        made<T>("shape", "number of points along x and y, or along a line",
                [](const T& of) -> const auto& { return of.info().shape; }),
        made<T>("size", "extent along x and y, or along a line; empty where it is not given",
                [](const T& of) -> const auto& { return of.info().size; })
            .in_unit("m"),
        made<T>("unit", "unit of the heights in the file; empty where it is not given",
                [](const T& of) -> const auto& { return of.info().unit; }),
        made<T>("orientation", "origin of the arrangement of rows and columns; empty for lines",
                [](const T& of) -> const auto& { return of.info().orientation; }),
        made<T>("is_height", "whether the channel contains heights", [](const T& of) { return of.info().is_height; }),
        made<T>("not_heights",
                "reason for which the channel does not contain heights; empty for heights, or where name and unit "
                "show it",
                [](const T& of) -> const auto& { return of.info().not_heights; }),
        made<T>("heights_read", "whether the heights were read", [](const T& of) { return of.heights().read; }),
        made<T>(
            "undefined_count", "number of undefined heights; null where heights were not read",
            [](const T& of) { return of.heights().read ? std::optional(of.heights().undefined_count) : std::nullopt; })
            .or_null(),
        made<T>("undefined_share", "share of undefined heights",
                [](const T& of) { return of.heights().undefined_share(); })
            .in_unit("1"),
        made<T>("mean", "mean of the heights", [](const T& of) { return of.heights().mean; }).in_unit("m"),
        made<T>("standard_deviation", "standard deviation of the heights",
                [](const T& of) { return of.heights().standard_deviation; })
            .in_unit("m"),
        made<T>("minimum", "minimum of the heights", [](const T& of) { return of.heights().least; }).in_unit("m"),
        made<T>("maximum", "maximum of the heights", [](const T& of) { return of.heights().greatest; }).in_unit("m"),
        part<T>("instrument", "instrument, as the file states it", instrument),
        made<T>("acquisition_time", "time of acquisition, as the file states it",
                [](const T& of) -> const auto& { return of.info().metadata.acquisition_time; }),
        made<T>("recommended_trend", "trend that the container recommends to remove",
                [](const T& of) {
                    const auto& trend = of.info().recommended_trend;
                    return trend ? std::optional<std::string>(topography::name(*trend)) : std::nullopt;
                })
            .or_null(),
        made<T>("missing", "missing metadata, such as size and unit",
                [](const T& of) { return formats::missing(of.info()); }),
        made<T>("error", "reason for which the heights could not be read",
                [](const T& of) -> const auto& { return of.heights().error; })
            .with(Missing::left_out),
        made<T>("alerts", "warnings", [](const T& of) -> const auto& { return of.info().alerts; }),
    };
    static constexpr Description description{"", "a channel of a file", rows};
};

template <>
struct Described<answers::ColumnEntry> {
    using T = answers::ColumnEntry;
    static constexpr std::array rows{
        field<&T::name>("name", "name of the column"),
        field<&T::unit>("unit", "unit of the numbers of the column"),
    };
    static constexpr Description description{"", "a column of a table", rows};
};
static_assert(complete<answers::ColumnEntry>);

template <>
struct Described<answers::SpectrumEntry> {
    using T = answers::SpectrumEntry;
    static constexpr std::array rows{
        field<&T::density>("density", "name of the second column of a spectrum"),
        field<&T::quantity>("quantity", "quantity of the second column of a spectrum"),
        field<&T::units_of_file>("units_of_file", "units in the file, before conversion to SI"),
        field<&T::units_assumed>("units_assumed",
                                 "whether the units are assumed, because the file does not state them"),
        field<&T::band>("band", "range of the wavevectors"),
    };
    static constexpr Description description{"", "a table of a spectrum", rows};
};
static_assert(complete<answers::SpectrumEntry>);

template <>
struct Described<imaging::ImageEntry> {
    using T = imaging::ImageEntry;
    static constexpr std::array<std::string_view, 4> kinds{"image", "spectrum", "spectrum image", "Fourier transform"};
    static constexpr std::array rows{
        field<&T::title>("title", "title in the file; empty without a title"),
        field<&T::kind>("kind", "kind of the image").one_of(kinds),
    };
    static constexpr Description description{"", "an image of a file", rows};
};
static_assert(complete<imaging::ImageEntry>);

template <>
struct Described<answers::ListedFile> {
    using T = answers::ListedFile;
    using P = imaging::PictureContent;
    static constexpr std::array rows_of_picture{
        made<P>("shape", "width and height of a picture in pixels",
                [](const P& of) {
                    return std::array{of.width, of.height};
                }),
        field<&P::frames>("frames", "number of frames"),
        made<P>("pixel_size", "width and height of a pixel; null where it is not given",
                [](const P& of) -> std::optional<std::array<double, 2>> {
                    if (!of.pixel_size) return std::nullopt;
                    return std::array{of.pixel_size->x, of.pixel_size->y};
                })
            .or_null()
            .in_unit("m"),
        field<&P::frame_rate>("frame_rate", "frames per second; null where it is not given").or_null().in_unit("1/s"),
        field<&P::images>("images", "images of the file, in the order of their numbers"),
        field<&P::image>("image", "number of the described image, counted from 0"),
        field<&P::instrument>("instrument", "instrument, as the file states it"),
        field<&P::acquisition_time>("acquisition_time", "time of acquisition, as the file states it"),
        field<&P::alerts>("alerts", "warnings of the picture"),
    };
    static constexpr Description of_picture{"", "a picture or a recording", rows_of_picture};
    static constexpr std::array rows_of_table{
        made<Table>("rows", "number of rows of a table", [](const Table& of) { return of.rows(); }),
        made<Table>("columns", "columns of a table", [](const Table& of) { return answers::columns_of(of); }),
    };
    static constexpr Description of_table{"", "a table", rows_of_table};
    static constexpr std::array rows_of_study{
        field<&study::Study::title>("title", "title of a study"),
        made<study::Study>("surfaces", "number of surfaces of a study",
                           [](const study::Study& of) { return of.surfaces.size(); }),
        made<study::Study>("elastomers", "number of elastomers of a study",
                           [](const study::Study& of) { return of.elastomers.size(); }),
        made<study::Study>("experiments", "number of experiments of a study",
                           [](const study::Study& of) { return of.experiments.size(); }),
    };
    static constexpr Description of_study{"", "a study", rows_of_study};
    static constexpr std::array rows{
        made<T>("file", "name of the file as it was given", [](const T& of) -> const auto& { return of.content.file; }),
        made<T>("kind", "kind of the contents", [](const T& of) { return study::name(of.content.kind); }),
        made<T>("format", "identifier of the format; empty for a kind with one format",
                [](const T& of) -> const auto& { return of.content.format; }),
        made<T>("verbs", "commands that read the file, the most relevant first",
                [](const T& of) { return study::commands_for(of.content.kind); }),
        made<T>("channels", "number of channels",
                [](const T& of) {
                    const auto count = of.content.channels.size();
                    return count > 0 ? std::optional(count) : std::nullopt;
                }),
        fields_of<T>(of_picture, [](const T& of) -> const auto& { return of.content.picture; }),
        fields_of<T>(of_table, [](const T& of) -> const auto& { return of.content.table; }),
        fields_of<T>([](const T& of) { return answers::spectrum_of(of.content); }),
        made<T>("missing", "missing metadata of a loop or a force curve, such as the radius of the sphere",
                [](const T& of) {
                    const bool is_loop = of.content.table && of.content.kind != study::FileKind::spectrum;
                    return is_loop ? std::optional(of.content.missing) : std::nullopt;
                }),
        made<T>("curves", "number of force curves of the file; the first one is described",
                [](const T& of) {
                    const bool is_curve = of.content.table && of.content.kind == study::FileKind::force_curve;
                    return is_curve ? std::optional(of.content.curves) : std::nullopt;
                }),
        fields_of<T>(of_study, [](const T& of) -> const auto& { return of.content.study; }),
        made<T>("note", "note on the file", [](const T& of) -> const auto& { return of.content.note; })
            .with(Missing::left_out),
        inner<&T::content>(),
        inner<&T::channels>(),
        inner<&T::bytes>(),
        inner<&T::too_large>(),
    };
    static constexpr Description description{"", "a file, with the properties of its kind", rows};
};
static_assert(complete<answers::ListedFile>);

template <>
struct Described<answers::FailedPath> {
    using T = answers::FailedPath;
    static constexpr std::array rows{
        field<&T::path>("file", "name of the file as it was given"),
        field<&T::reason>("error", "reason for which the file could not be read"),
    };
    static constexpr Description description{"", "a file that could not be read", rows};
};
static_assert(complete<answers::FailedPath>);

template <>
struct Described<answers::Contents> {
    using T = answers::Contents;
    static constexpr std::array rows{
        made<T>("channels", "channels of topographies and containers",
                [](const T& of) { return answers::channels_of(of); }),
        field<&T::files>("files", "files that were read"),
        made<T>("failed", "files that could not be read", [](const T& of) { return answers::failed_paths(of); }),
        field<&T::own>("passed_over", "files of folders that setae wrote: figures, tables, reports"),
        inner<&T::failed>(),
    };
    static constexpr Description description{"", "contents of files", rows};
};
static_assert(complete<answers::Contents>);

}  // namespace setae::fields
