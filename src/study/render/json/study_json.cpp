// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "json_writer.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/json.hpp"
#include "setae/output/study_description.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/parallel/for_each.hpp"
#include "study_fields.hpp"

namespace setae::output {
namespace {

/// An array of whose items there may be thousands.
struct List {
    std::size_t size = 0;
    std::function<Json(std::size_t)> item;

    void fill(Json& array, std::size_t most) const {
        for (std::size_t i = 0; i < std::min(size, most); ++i) array.push_back(item(i));
    }
};

List measurements_of(const study::SurfaceResult& surface) {
    return {surface.measurements.size(),
            [&](std::size_t i) { return described(MeasurementEntry{&surface.measurements[i]}); }};
}

List inputs_of(const study::StudyResult& result) {
    return {result.inputs.size(), [&](std::size_t i) { return described(result.inputs[i]); }};
}

/// The arrays of a study that are filled later, but that of the inputs.
std::map<std::string, List> lists_of(const study::StudyResult& result) {
    return {{"pairs",
             {result.pairs.size(),
              [&](std::size_t i) {
                  return described(PairEntry{&result.pairs[i], &result.draws});
              }}},
            {"experiments",
             {result.experiments.size(),
              [&](std::size_t i) { return described(ExperimentEntry{&result.experiments[i]}); }}},
            {"alerts", {result.alerts.size(), [&](std::size_t i) { return described(result.alerts[i]); }}}};
}

/// A surface as a study has it, without measurements: `stem` names the file of its spectrum.
Json named_frame(const study::SurfaceResult& surface, const std::string& stem,
                 const study::SurfaceAnalysisOptions& options) {
    return described(SurfaceEntry{&surface, &options, surface.failed() ? "" : "psd_" + stem + ".csv"});
}

/// Requested numbers of entries of a study's lists.
struct Wanted {
    std::size_t entries = std::numeric_limits<std::size_t>::max();
    std::size_t experiments = entries;
};

/// A study with the first entries of its lists, and of each surface's measurements.
Json study_json(const study::StudyResult& result, const Wanted& most) {
    auto json = described(StudyEntry{&result});
    const auto stems = spectrum_stems(result);
    for (std::size_t i = 0; i < std::min(most.entries, stems.size()); ++i) {
        const auto& surface = result.surfaces[i];
        auto& entry = json["surfaces"][surface.name] = named_frame(surface, stems[i], result.study.analysis);
        measurements_of(surface).fill(entry["measurements"], most.entries);
    }
    for (const auto& [key, list] : lists_of(result))
        list.fill(json[key], key == "experiments" ? most.experiments : most.entries);
    inputs_of(result).fill(json["provenance"]["inputs"], most.entries);
    return json;
}

/// Without long columns of numbers, and so many objects of longer lists.
Json without_curves(const Json& json, std::size_t most) {
    constexpr std::size_t longest = 16;
    if (json.is_array()) {
        if (json.size() > longest &&
            std::all_of(json.begin(), json.end(), [](const Json& item) { return item.is_number() || item.is_null(); }))
            return nullptr;
        Json copy = Json::array();
        for (const auto& item : json) {
            if (copy.size() == most && item.is_object()) break;
            copy.push_back(without_curves(item, most));
        }
        return copy;
    }
    if (!json.is_object()) return json;
    Json copy = Json::object();
    for (const auto& [key, item] : json.items()) copy[key] = without_curves(item, most);
    return copy;
}

/// Writes a list's items in groups, each made on a thread of its own: thousands would not fit into memory.
void write_list(const List& list, JsonWriter& writer) {
    constexpr std::size_t at_once = 32;
    writer.begin_array();
    for (std::size_t first = 0; first < list.size; first += at_once) {
        std::vector<std::string> texts(std::min(at_once, list.size - first));
        parallel::for_each_index(texts.size(), {}, [&](std::size_t i) {
            texts[i] = JsonWriter::text_within(writer.depth(), list.item(first + i));
        });
        for (const auto& text : texts) writer.element_as(text);
    }
    writer.end_array();
}

/// Writes an object whose entry `key` is a list.
void write_with_list(const Json& json, const char* key, const List& list, JsonWriter& writer) {
    writer.begin_object();
    for (const auto& [name, value] : json.items()) {
        writer.key(name);
        if (name == key) write_list(list, writer);
        else writer.value(value);
    }
    writer.end_object();
}

void write_surfaces(const study::StudyResult& result, JsonWriter& writer) {
    const auto stems = spectrum_stems(result);
    writer.begin_object();
    for (std::size_t i = 0; i < stems.size(); ++i) {
        const auto& surface = result.surfaces[i];
        writer.key(surface.name);
        write_with_list(named_frame(surface, stems[i], result.study.analysis), "measurements", measurements_of(surface),
                        writer);
    }
    writer.end_object();
}

}  // namespace

Json to_json(const study::SurfaceResult& surface, const study::SurfaceAnalysisOptions& options) {
    auto json = described(SurfaceEntry{&surface, &options, ""});
    measurements_of(surface).fill(json["measurements"], surface.measurements.size());
    return json;
}

Json to_json(const study::StudyResult& result) { return study_json(result, {}); }

Json json_without_curves(const study::StudyResult& result, std::size_t max_entries, std::size_t max_experiments) {
    return without_curves(study_json(result, {max_entries, max_experiments}), max_entries);
}

void write_json(const study::StudyResult& result, const std::function<void(std::string_view)>& write) {
    JsonWriter writer(write);
    const auto json = described(StudyEntry{&result});
    const auto lists = lists_of(result);
    writer.begin_object();
    for (const auto& [key, value] : json.items()) {
        writer.key(key);
        if (key == "surfaces") write_surfaces(result, writer);
        else if (key == "provenance") write_with_list(value, "inputs", inputs_of(result), writer);
        else if (const auto list = lists.find(key); list != lists.end()) write_list(list->second, writer);
        else writer.value(value);
    }
    writer.end_object();
}

constinit const fields::Description study_description = fields::Described<StudyEntry>::description;

}  // namespace setae::output
