// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "files/listed_file.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::cli::info_command {
namespace {

output::Json optional_number(const std::optional<double>& value) {
    return value ? output::Json(*value) : output::Json(nullptr);
}

void add_picture(output::Json& json, const imaging::PictureContent& picture) {
    json["shape"] = {picture.width, picture.height};
    json["frames"] = picture.frames;
    json["pixel_size"] =
        picture.pixel_size ? output::Json{picture.pixel_size->x, picture.pixel_size->y} : output::Json(nullptr);
    json["frame_rate"] = optional_number(picture.frame_rate);
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

}  // namespace

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
                          {"resolution", optional_number(instrument.resolution)}};
    json["acquisition_time"] = info.metadata.acquisition_time;
    json["recommended_trend"] =
        info.recommended_trend ? output::Json(topography::name(*info.recommended_trend)) : output::Json(nullptr);
    json["missing"] = formats::missing(info);
    if (!heights.error.empty()) json["error"] = heights.error;
    json["alerts"] = output::to_json(info.alerts);
    return json;
}

output::Json file_json(const ListedFile& file) {
    const auto& content = file.content;
    output::Json json{{"file", content.file},
                      {"kind", study::name(content.kind)},
                      {"format", content.format},
                      {"verbs", study::verbs_for(content.kind)}};
    if (!content.channels.empty()) json["channels"] = content.channels.size();
    if (content.picture) add_picture(json, *content.picture);
    if (content.table) {
        add_columns(json, *content.table);
        if (content.kind == study::FileKind::spectrum) add_spectrum(json, *content.table);
        else json["missing"] = content.missing;
    }
    if (content.study) add_study(json, *content.study);
    if (!content.note.empty()) json["note"] = content.note;
    return json;
}

}  // namespace setae::cli::info_command
