// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/contour_file.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "setae/bytes/json_text.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/output/json.hpp"

namespace setae::output {
namespace {

/// The enumerator of a word.
template <class Value, class Words>
Value value_of(const Words& words, const std::string& name, const char* what) {
    const auto found = std::find(words.begin(), words.end(), name);
    if (found == words.end())
        throw InvalidArgument(fmt::format("{} '{}', expected one of {}", what, name, fmt::join(words, ", ")));
    return static_cast<Value>(found - words.begin());
}

/// An object whose keys are all known; errors name the file and the key.
class Object {
public:
    Object(const Json& json, std::string path, std::string where, const std::vector<std::string>& keys)
        : json_(json), path_(std::move(path)), where_(std::move(where)) {
        if (!json.is_object()) fail("", "is no object");
        for (const auto& [key, value] : json.items())
            if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
                const auto near = nearest_match(key, keys);
                fail(key, "is not a known key" + (near.empty() ? std::string() : "; did you mean '" + near + "'?"));
            }
    }

    [[nodiscard]] bool has(const char* key) const { return json_.contains(key) && !json_.at(key).is_null(); }

    /// The value of a key. @throws FormatError where it is missing or of another kind.
    template <class Value>
    [[nodiscard]] Value value(const char* key) const {
        if (!has(key)) fail(key, "is missing");
        try {
            return json_.at(key).get<Value>();
        } catch (const Json::exception&) {
            fail(key, fmt::format("has the value {}, of another kind than expected", json_.at(key).dump()));
        }
    }
    template <class Value>
    [[nodiscard]] std::optional<Value> maybe(const char* key) const {
        return has(key) ? std::optional(value<Value>(key)) : std::nullopt;
    }
    [[nodiscard]] const Json& at(const char* key) const {
        if (!has(key)) fail(key, "is missing");
        return json_.at(key);
    }
    [[noreturn]] void fail(const std::string& key, const std::string& what) const {
        throw FormatError(path_, {}, fmt::format("'{}{}' {}", where_, key, what));
    }

private:
    const Json& json_;
    std::string path_, where_;
};

std::vector<imaging::Anchor> anchor_list(const Json& list, const Object& object) {
    std::vector<imaging::Anchor> anchors;
    for (const auto& point : list) {
        if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number())
            object.fail("anchors", fmt::format("holds {}, expected [x, y] in pixels", point.dump()));
        anchors.push_back({point[0].get<double>(), point[1].get<double>()});
    }
    return anchors;
}

std::vector<std::vector<imaging::Anchor>> anchor_lists(const Json& json, const Object& object) {
    if (!json.is_array()) object.fail("anchors", "is no list");
    if (json.empty()) return {};
    const bool nested = json[0].is_array() && (json[0].empty() || json[0][0].is_array());
    if (!nested) return {anchor_list(json, object)};
    std::vector<std::vector<imaging::Anchor>> lists;
    for (const auto& list : json) lists.push_back(anchor_list(list, object));
    return lists;
}

study::ContourOptions stored_options(const Json& json, const std::string& path) {
    const Object object(json, path, "options.",
                        {"vacuum", "smoothing_length", "denoise", "least_length", "hidden", "hide_annotations", "shape",
                         "foil_thickness"});
    study::ContourOptions options;
    options.trace.vacuum = vacuum_from_name(object.value<std::string>("vacuum"));
    options.trace.smoothing_length = object.maybe<double>("smoothing_length");
    options.trace.denoise = object.value<double>("denoise");
    options.trace.min_length = object.maybe<double>("least_length");
    for (const auto& region : object.at("hidden")) {
        if (!region.is_array() || region.size() != 4)
            object.fail("hidden", "holds something else than [x, y, width, height]");
        options.trace.hidden.push_back(
            {region[0].get<long>(), region[1].get<long>(), region[2].get<long>(), region[3].get<long>()});
    }
    options.hide_annotations = object.value<bool>("hide_annotations");
    options.shape = shape_from_name(object.value<std::string>("shape"));
    options.foil_thickness = object.maybe<double>("foil_thickness");
    return options;
}

imaging::Calibration stored_calibration(const Json& json, const std::string& path) {
    const Object object(json, path, "calibration.", {"pixel_size", "relative_standard_error", "source"});
    imaging::Calibration calibration;
    const auto size = object.value<std::vector<double>>("pixel_size");
    if (size.size() != 2 || !(size[0] > 0 && size[1] > 0)) object.fail("pixel_size", "is no pair of positive lengths");
    calibration.pixel_size = {size[0], size[1]};
    calibration.relative_standard_error = object.value<double>("relative_standard_error");
    calibration.source = object.value<std::string>("source");
    return calibration;
}

}  // namespace

std::string to_string(imaging::Vacuum vacuum) { return std::string(vacuum_words.at(static_cast<std::size_t>(vacuum))); }
std::string to_string(study::ContourShape shape) {
    return std::string(shape_words.at(static_cast<std::size_t>(shape)));
}
imaging::Vacuum vacuum_from_name(const std::string& name) {
    return value_of<imaging::Vacuum>(vacuum_words, name, "vacuum");
}
study::ContourShape shape_from_name(const std::string& name) {
    return value_of<study::ContourShape>(shape_words, name, "shape");
}

StoredTrace read_trace(const std::string& path) {
    const auto json = bytes::parsed_json<Json>(bytes::read_file(path), path,
                                               "no JSON; expected a trace or {\"anchors\": [[x, y], …]}");
    const Object object(
        json, path, "",
        {"format", "version", "image", "calibration", "options", "anchors", "levels", "segments", "alerts", "setae"});
    StoredTrace stored;
    stored.anchors = anchor_lists(object.at("anchors"), object);
    if (!object.has("format")) {
        for (const char* key : {"image", "calibration", "options"})
            if (object.has(key)) object.fail(key, "is given in a file without \"format\": \"setae trace\"");
        return stored;
    }
    if (object.value<std::string>("format") != trace_format)
        object.fail("format", fmt::format("is '{}', expected '{}'", object.value<std::string>("format"), trace_format));
    if (object.value<int>("version") != trace_version)
        object.fail("version", fmt::format("is {}, expected {}", object.value<int>("version"), trace_version));
    const Object image(object.at("image"), path, "image.",
                       {"file", "sha256", "width", "height", "format", "image", "title"});
    stored.digest = image.value<std::string>("sha256");
    try {
        stored.options = stored_options(object.at("options"), path);
    } catch (const InvalidArgument& error) {
        throw FormatError(path, {}, error.what());
    } catch (const Json::exception&) {
        object.fail("options", "holds a value of another kind than expected");
    }
    stored.options->micrograph.image = fmt::format("{}", image.value<std::size_t>("image"));
    stored.options->shared_calibration = stored_calibration(object.at("calibration"), path);
    stored.options->trace.anchors = stored.anchors;
    return stored;
}

}  // namespace setae::output
