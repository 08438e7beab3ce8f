// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/contents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::answers {
namespace {

/// Larger files are not read without a request.
constexpr std::uint64_t largest_read = 64'000'000;

HeightSummary summary_of(const Eigen::Ref<const Array1D>& heights) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    HeightSummary summary{.read = true, .undefined_count = heights.isNaN().count(), .points = heights.size()};
    const auto count = static_cast<double>(summary.points - summary.undefined_count);
    const double offset = summary.mean = heights.isNaN().select(0.0, heights).sum() / count;
    summary.standard_deviation = std::sqrt(heights.isNaN().select(0.0, heights - offset).square().sum() / count);
    summary.least = heights.isNaN().select(infinity, heights).minCoeff();
    summary.greatest = heights.isNaN().select(-infinity, heights).maxCoeff();
    return summary;
}

/// Reads the heights of a channel. An error is stated in the result.
HeightSummary summarise(const formats::Channel& channel) {
    try {
        const auto measurement = channel.read();
        auto summary = std::visit(
            [](const auto& m) { return summary_of(Eigen::Map<const Array1D>(m.heights.data(), m.heights.size())); },
            measurement);
        summary.alerts = topography::metadata(measurement).alerts;
        return summary;
    } catch (const std::exception& error) {
        return {.error = reason_of(error)};
    }
}

output::Json optional_number(const std::optional<double>& value) {
    return value ? output::Json(*value) : output::Json(nullptr);
}

void add_picture(output::Json& json, const imaging::PictureContent& picture) {
    json["shape"] = {picture.width, picture.height};
    json["frames"] = picture.frames;
    json["pixel_size"] =
        picture.pixel_size ? output::Json{picture.pixel_size->x, picture.pixel_size->y} : output::Json(nullptr);
    json["frame_rate"] = optional_number(picture.frame_rate);
    json["images"] = output::Json::array();
    for (const auto& image : picture.images) json["images"].push_back({{"title", image.title}, {"kind", image.kind}});
    json["image"] = picture.image;
    json["instrument"] = picture.instrument;
    json["acquisition_time"] = picture.acquisition_time;
    json["alerts"] = output::to_json(picture.alerts);
}

void add_columns(output::Json& json, const Table& table) {
    json["rows"] = table.rows();
    json["columns"] = output::Json::array();
    for (const auto& column : table.columns) json["columns"].push_back({{"name", column.name}, {"unit", column.unit}});
}

void add_spectrum(output::Json& json, const Table& table) {
    const auto& q = table.at("wavevector");
    json["density"] = table.columns[1].name;
    json["quantity"] = table.metadata.at("quantity");
    json["units_of_file"] = table.metadata.at("units_of_file");
    json["units_assumed"] = table.metadata.contains("units");
    json["band"] = {{"lower", q[0]}, {"upper", q[q.size() - 1]}, {"unit", "1/m"}};
}

void add_study(output::Json& json, const study::Study& study) {
    json["title"] = study.title;
    json["surfaces"] = study.surfaces.size();
    json["elastomers"] = study.elastomers.size();
    json["experiments"] = study.experiments.size();
}

/// A channel with all its known properties; null where they are unknown.
output::Json channel_json(const std::string& file, const ListedChannel& channel) {
    using output::number;
    const auto& info = channel.info;
    const auto& heights = channel.heights;
    output::Json json{{"file", file},
                      {"channel", channel.index},
                      {"format", info.format},
                      {"name", info.name},
                      {"shape", info.shape},
                      {"size", info.size},
                      {"unit", info.unit},
                      {"orientation", info.orientation},
                      {"is_height", info.is_height},
                      {"not_heights", info.not_heights},
                      {"heights_read", heights.read},
                      {"undefined_count", heights.read ? output::Json(heights.undefined_count) : output::Json(nullptr)},
                      {"undefined_share", number(heights.undefined_share())},
                      {"mean", number(heights.mean)},
                      {"standard_deviation", number(heights.standard_deviation)},
                      {"minimum", number(heights.least)},
                      {"maximum", number(heights.greatest)}};
    const auto& instrument = info.metadata.instrument;
    json["instrument"] = {{"name", instrument.name},
                          {"type", instrument.type},
                          {"tip_radius", optional_number(instrument.tip_radius)},
                          {"tip_radius_standard_error", optional_number(instrument.tip_radius_standard_error)},
                          {"resolution", optional_number(instrument.resolution)}};
    json["acquisition_time"] = info.metadata.acquisition_time;
    json["recommended_trend"] =
        info.recommended_trend ? output::Json(topography::name(*info.recommended_trend)) : output::Json(nullptr);
    json["missing"] = formats::missing(info);
    if (!heights.error.empty()) json["error"] = heights.error;
    json["alerts"] = output::to_json(info.alerts);
    return json;
}

/// A file: its kind, format and commands, and further properties of its kind.
output::Json file_json(const ListedFile& file) {
    const auto& content = file.content;
    output::Json json{{"file", content.file},
                      {"kind", study::name(content.kind)},
                      {"format", content.format},
                      {"verbs", study::commands_for(content.kind)}};
    if (!content.channels.empty()) json["channels"] = content.channels.size();
    if (content.picture) add_picture(json, *content.picture);
    if (content.table) {
        add_columns(json, *content.table);
        if (content.kind == study::FileKind::spectrum) add_spectrum(json, *content.table);
        else json["missing"] = content.missing;
        if (content.kind == study::FileKind::force_curve) json["curves"] = content.curves;
    }
    if (content.study) add_study(json, *content.study);
    if (!content.note.empty()) json["note"] = content.note;
    return json;
}

ListedFile listed(const std::string& file, const ContentsRequest& request) {
    ListedFile listed{.content = study::file_content(file, request.questions),
                      .channels = {},
                      .bytes = bytes::file_source(file).size};
    const bool large = listed.bytes > largest_read;
    const bool wanted = !request.no_heights && (request.heights || !large);
    listed.too_large = large && !request.heights && !request.no_heights;
    const auto& channels = listed.content.channels;
    std::optional<std::size_t> only;
    if (request.channel && !channels.empty()) only = formats::chosen_channels(file, channels, request.channel).front();
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (only && *only != i) continue;
        auto info = channels[i].info;
        auto heights = wanted && can_be_read(info) ? summarise(channels[i]) : HeightSummary{};
        const auto& made = heights.read ? heights.alerts : info.metadata.alerts;
        info.alerts.insert(info.alerts.end(), made.begin(), made.end());
        listed.channels.push_back({i, std::move(info), std::move(heights)});
    }
    return listed;
}

}  // namespace

bool can_be_read(const formats::ChannelInfo& info) {
    return info.is_height && !info.size.empty() && !info.unit.empty();
}

Contents contents(const ContentsRequest& request) {
    if (request.paths.empty()) throw InvalidArgument("no file; expected at least one file or folder");
    if (request.heights && request.no_heights)
        throw InvalidArgument("`heights` and `no_heights` contradict each other; expected one of them");
    const auto found = study::found_files(request.paths);
    Contents contents{.files = {}, .failed = found.unreadable, .own = found.own};
    for (const auto& file : found.files) {
        try {
            contents.files.push_back(listed(file, request));
        } catch (const std::exception& error) {
            contents.failed.push_back({file, reason_of(error, file)});
        }
    }
    return contents;
}

output::Json to_json(const Contents& contents) {
    output::Json json{
        {"channels", output::Json::array()}, {"files", output::Json::array()}, {"failed", output::Json::array()}};
    for (const auto& file : contents.files) {
        json["files"].push_back(file_json(file));
        for (const auto& channel : file.channels) json["channels"].push_back(channel_json(file.content.file, channel));
    }
    json["passed_over"] = contents.own;
    for (const auto& failed : contents.failed)
        json["failed"].push_back({{"file", failed.path}, {"error", failed.reason}});
    return json;
}

}  // namespace setae::answers
