// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/calibration_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "setae/bytes/digest.hpp"
#include "setae/bytes/json_text.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::imaging {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* version_key = "setae_calibration";
constexpr int version = 1;

/// An object of a JSON file that records the keys that were read; errors contain file and key.
class ObjectReader {
public:
    ObjectReader(const Json& object, std::string path, std::string where)
        : object_(object), path_(std::move(path)), where_(std::move(where)) {
        if (!object.is_object()) fail("", fmt::format("{}, expected an object", object.type_name()));
    }
    [[nodiscard]] double number(const char* key) {
        const auto& value = required(key);
        if (!value.is_number()) fail(key, fmt::format("{}, expected a number", value.dump()));
        return value.get<double>();
    }
    [[nodiscard]] double positive(const char* key) {
        const double value = number(key);
        if (!(value > 0 && std::isfinite(value))) fail(key, fmt::format("{:g}, expected a positive number", value));
        return value;
    }
    [[nodiscard]] double not_negative(const char* key) {
        const double value = number(key);
        if (!(value >= 0 && std::isfinite(value))) fail(key, fmt::format("{:g}, expected a number >= 0", value));
        return value;
    }
    [[nodiscard]] std::string text(const char* key) {
        const auto& value = required(key);
        if (!value.is_string()) fail(key, fmt::format("{}, expected text", value.dump()));
        return value.get<std::string>();
    }
    [[nodiscard]] const Json* optional(const char* key) {
        read_keys_.emplace_back(key);
        const auto found = object_.find(key);
        return found == object_.end() ? nullptr : &*found;
    }
    [[nodiscard]] const Json& required(const char* key) {
        const auto* value = optional(key);
        if (!value) fail(key, "missing");
        return *value;
    }
    [[nodiscard]] ObjectReader object(const char* key) { return {required(key), path_, where_ + key + "."}; }
    [[nodiscard]] ObjectReader element(const Json& value, const char* key, std::size_t index) const {
        return {value, path_, fmt::format("{}{}[{}].", where_, key, index)};
    }
    void finish() const {
        for (const auto& [key, value] : object_.items())
            if (std::find(read_keys_.begin(), read_keys_.end(), key) == read_keys_.end()) {
                const auto nearest = nearest_match(key, read_keys_);
                fail(key,
                     "unknown key" + (nearest.empty() ? std::string() : fmt::format("; did you mean '{}'?", nearest)));
            }
    }
    [[noreturn]] void fail(const std::string& key, const std::string& what) const {
        throw FormatError(path_, {}, fmt::format("'{}{}': {}", where_, key, what));
    }

private:
    const Json& object_;
    std::string path_, where_;
    std::vector<std::string> read_keys_;
};

Json as_json(const ScaleBar& bar) {
    Json json{{"begin_x_px", bar.begin_x},
              {"end_x_px", bar.end_x},
              {"y_px", bar.y},
              {"thickness_px", bar.thickness},
              {"length_px", bar.length},
              {"length_standard_error_px", bar.length_standard_error},
              {"label", bar.label}};
    if (bar.labelled_length) json["labelled_length_m"] = *bar.labelled_length;
    json["annotation_px"] = {bar.annotation.x, bar.annotation.y, bar.annotation.width, bar.annotation.height};
    json["confidence"] = bar.confidence;
    return json;
}

ScaleBar scale_bar(ObjectReader reader) {
    ScaleBar bar;
    bar.begin_x = reader.number("begin_x_px");
    bar.end_x = reader.number("end_x_px");
    bar.y = reader.number("y_px");
    bar.thickness = reader.positive("thickness_px");
    bar.length = reader.positive("length_px");
    bar.length_standard_error = reader.not_negative("length_standard_error_px");
    bar.label = reader.text("label");
    if (reader.optional("labelled_length_m")) bar.labelled_length = reader.positive("labelled_length_m");
    const auto& region = reader.required("annotation_px");
    const bool whole =
        region.is_array() && region.size() == 4 &&
        std::all_of(region.begin(), region.end(), [](const Json& value) { return value.is_number_integer(); });
    if (!whole) reader.fail("annotation_px", "expected x, y, width, height as whole numbers");
    bar.annotation = {region[0].get<long>(), region[1].get<long>(), region[2].get<long>(), region[3].get<long>()};
    bar.confidence = reader.not_negative("confidence");
    reader.finish();
    return bar;
}

Json parsed(const std::string& path) {
    return bytes::parsed_json<Json>(bytes::read_file(path), path, "the calibration is not valid JSON");
}

}  // namespace

KeptCalibration kept_calibration(const Calibration& calibration, const std::string& picture_path) {
    return {calibration, std::filesystem::path(picture_path).filename().string(),
            bytes::sha256(bytes::file_source(picture_path))};
}

void write_calibration(const std::string& path, const KeptCalibration& kept) {
    const auto& calibration = kept.calibration;
    Json json{{version_key, version},
              {"pixel_size_x_m", calibration.pixel_size.x},
              {"pixel_size_y_m", calibration.pixel_size.y},
              {"relative_standard_error", calibration.relative_standard_error},
              {"source", calibration.source},
              {"picture", {{"name", kept.picture}, {"sha256", kept.picture_sha256}}}};
    if (calibration.scale_bar) json["scale_bar"] = as_json(*calibration.scale_bar);
    json["alerts"] = Json::array();
    for (const auto& alert : calibration.alerts)
        json["alerts"].push_back(
            {{"code", alert.code}, {"subject", alert.subject}, {"message", alert.message}, {"action", alert.action}});
    // file names may not be UTF-8
    bytes::write_whole_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

KeptCalibration read_calibration(const std::string& path) {
    const auto json = parsed(path);
    ObjectReader reader(json, path, "");
    const auto& stated = reader.required(version_key);
    if (!stated.is_number_integer() || stated.get<std::int64_t>() != version)
        reader.fail(version_key, fmt::format("version {}, expected {}", stated.dump(), version));
    KeptCalibration kept;
    auto& calibration = kept.calibration;
    calibration.pixel_size = {reader.positive("pixel_size_x_m"), reader.positive("pixel_size_y_m")};
    calibration.relative_standard_error = reader.not_negative("relative_standard_error");
    calibration.source = reader.text("source");
    auto picture = reader.object("picture");
    kept.picture = picture.text("name");
    kept.picture_sha256 = picture.text("sha256");
    if (kept.picture_sha256.size() != 64 ||
        kept.picture_sha256.find_first_not_of("0123456789abcdef") != std::string::npos)
        picture.fail("sha256", "expected 64 hexadecimal digits");
    picture.finish();
    if (reader.optional("scale_bar")) calibration.scale_bar = scale_bar(reader.object("scale_bar"));
    const auto& alerts = reader.required("alerts");
    if (!alerts.is_array()) reader.fail("alerts", "expected a list");
    for (std::size_t k = 0; k < alerts.size(); ++k) {
        auto alert = reader.element(alerts[k], "alerts", k);
        calibration.alerts.push_back(
            {alert.text("code"), alert.text("subject"), alert.text("message"), alert.text("action")});
        alert.finish();
    }
    reader.finish();
    return kept;
}

}  // namespace setae::imaging
