// SPDX-License-Identifier: GPL-3.0-or-later
#include "container_index.hpp"

#include <concepts>
#include <type_traits>

#include <fmt/format.h>

#include "container_yaml.hpp"
#include "setae/bytes/json_text.hpp"
#include "setae/core/errors.hpp"

namespace setae::formats {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

// ---- the fields, for reading and writing alike ----------------------------------------------------------------------

template <class Fields>
void fields_of(ContainerAuthor& author, Fields& fields) {
    fields("name", author.name);
    fields("orcid", author.orcid);
}

template <class Fields>
void fields_of(ContainerProperty& property, Fields& fields) {
    fields("name", property.name);
    fields("value", property.value);
    fields("unit", property.unit);
}

template <class Fields>
void fields_of(ContainerPublication& publication, Fields& fields) {
    fields("url", publication.url);
    fields("license", publication.license);
    fields("authors", publication.authors);
    fields("version", publication.version);
    fields("date", publication.date);
    fields("doi_url", publication.doi_url);
    fields("doi_state", publication.doi_state);
}

template <class Fields>
void fields_of(ContainerLength& length, Fields& fields) {
    fields("value", length.value);
    fields("unit", length.unit);
}

template <class Fields>
void fields_of(ContainerInstrument::Parameters& parameters, Fields& fields) {
    fields("tip_radius", parameters.tip_radius);
    fields("resolution", parameters.resolution);
    fields("tip_radius_standard_error", parameters.tip_radius_standard_error);
    fields("height_calibration", parameters.height_calibration);
    fields("lateral_calibration", parameters.lateral_calibration);
}

template <class Fields>
void fields_of(ContainerInstrument& instrument, Fields& fields) {
    fields("name", instrument.name);
    fields("type", instrument.type);
    fields("parameters", instrument.parameters);
}

template <class Fields>
void fields_of(ContainerTopography::Datafile& datafile, Fields& fields) {
    fields("original", datafile.original);
    fields("squeezed-netcdf", datafile.squeezed);
    fields("setae-source", datafile.source);
    fields("setae-source-channel", datafile.source_channel);
}

template <class Fields>
void fields_of(ContainerTopography::Channel& channel, Fields& fields) {
    fields("name", channel.name);
    fields("occurrence", channel.occurrence);
}

template <class Fields>
void fields_of(ContainerTopography& topography, Fields& fields) {
    fields("name", topography.name);
    fields("datafile", topography.datafile);
    fields("data_source", topography.data_source);
    fields("channel", topography.channel);
    fields("size", topography.size);
    fields("unit", topography.unit);
    fields("height_scale", topography.height_scale);
    fields("has_undefined_data", topography.has_undefined_data);
    fields("undefined_data_fraction", topography.undefined_data_fraction);
    fields("fill_undefined_data_mode", topography.fill_undefined_data_mode);
    fields("detrend_mode", topography.detrend_mode);
    fields("is_periodic", topography.is_periodic);
    fields("created_by", topography.created_by);
    fields("measurement_date", topography.measurement_date);
    fields("description", topography.description);
    fields("tags", topography.tags);
    fields("instrument", topography.instrument);
}

template <class Fields>
void fields_of(ContainerSurface& surface, Fields& fields) {
    fields("name", surface.name);
    fields("category", surface.category);
    fields("created_by", surface.created_by);
    fields("description", surface.description);
    fields("tags", surface.tags);
    fields("is_published", surface.is_published);
    fields("publication", surface.publication);
    fields("properties", surface.properties);
    fields("topographies", surface.topographies);
}

template <class Fields>
void fields_of(Container& container, Fields& fields) {
    fields("versions", container.versions);
    fields("surfaces", container.surfaces);
    fields("created_at", container.created_at);
}

template <class Type>
concept Described = requires(Type& value) { value.extra; };

/// Whether a value is empty.
bool is_empty(const json& value) {
    return value.is_null() || (value.is_structured() && value.empty()) ||
           (value.is_string() && value.get_ref<const std::string&>().empty());
}

// ---- reading --------------------------------------------------------------------------------------------------------

/// Takes the known fields from an object; the rest is `extra`.
class FieldReader {
public:
    FieldReader(json& object, std::string path, std::vector<Alert>& alerts)
        : object_(object), path_(std::move(path)), alerts_(alerts) {}

    template <class Type>
    void operator()(const char* key, Type& value) {
        const auto found = object_.find(key);
        if (found == object_.end()) return;
        const auto place = path_.empty() ? key : path_ + "/" + key;
        if (is_empty(*found) || take(*found, value, place)) {
            object_.erase(found);
            return;
        }
        malformed_.emplace_back(key);
        alerts_.push_back(
            {"MALFORMED_FIELD", place,
             fmt::format("the value {:.80} does not have the form that the schema requires", shown(*found)),
             "correct the index; until then, the value is kept in the index but not used"});
    }

    /// The rest as text; the "extra" of the container is never interpreted.
    std::string rest() {
        for (const auto& [key, value] : object_.items())
            if (std::find(malformed_.begin(), malformed_.end(), key) == malformed_.end() &&
                !(path_.empty() && key == "extra"))
                alerts_.push_back({"UNKNOWN_FIELD", path_.empty() ? key : path_ + "/" + key,
                                   fmt::format("this field is unknown; its value is {:.80}", shown(value)),
                                   "check its spelling; the field is kept when the container is written again"});
        return object_.empty() ? std::string{} : shown(object_);
    }

private:
    static std::string shown(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

    static bool take(const json& from, std::string& value, const std::string&) {
        if (from.is_string()) value = from.get<std::string>();
        return from.is_string();
    }
    static bool take(const json& from, double& value, const std::string&) {
        if (from.is_number()) value = from.get<double>();
        return from.is_number();
    }
    static bool take(const json& from, bool& value, const std::string&) {
        if (from.is_boolean()) value = from.get<bool>();
        return from.is_boolean();
    }
    static bool take(const json& from, std::size_t& value, const std::string&) {
        constexpr double most = 1e6;
        if (!from.is_number()) return false;
        const double number = from.get<double>();
        const bool counts =
            number >= 0.0 && number <= most && number == static_cast<double>(static_cast<std::size_t>(number));
        if (counts) value = static_cast<std::size_t>(number);
        return counts;
    }
    static bool take(const json& from, std::variant<double, std::string>& value, const std::string&) {
        if (from.is_string()) value = from.get<std::string>();
        if (from.is_number()) value = from.get<double>();
        return from.is_string() || from.is_number();
    }
    static bool take(const json& from, std::map<std::string, std::string>& value, const std::string&) {
        if (!from.is_object()) return false;
        for (const auto& entry : from)
            if (!entry.is_string()) return false;
        value = from.get<std::map<std::string, std::string>>();
        return true;
    }
    bool take(json& from, ContainerLength& value, const std::string& place) {
        if (take(from, value.text, place)) return true;
        return take<ContainerLength>(from, value, place);
    }
    template <class Type>
    bool take(json& from, std::optional<Type>& value, const std::string& place) {
        Type taken{};
        if (!take(from, taken, place)) return false;
        value = std::move(taken);
        return true;
    }
    template <class Type>
    bool take(json& from, std::vector<Type>& value, const std::string& place) {
        if (!from.is_array()) return false;
        const auto alerts_before = alerts_.size();
        std::vector<Type> taken(from.size());
        for (std::size_t i = 0; i < from.size(); ++i) {
            json copy = from[i];  // the list remains complete if one of its entries is invalid
            if (take(copy, taken[i], fmt::format("{}/{}", place, i))) continue;
            alerts_.resize(alerts_before);
            return false;
        }
        value = std::move(taken);
        return true;
    }
    template <Described Type>
    bool take(json& from, Type& value, const std::string& place) {
        if (!from.is_object()) return false;
        FieldReader reader(from, place, alerts_);
        fields_of(value, reader);
        value.extra = reader.rest();
        return true;
    }

    json& object_;
    std::string path_;
    std::vector<Alert>& alerts_;
    std::vector<std::string> malformed_;
};

// ---- writing --------------------------------------------------------------------------------------------------------

class FieldWriter {
public:
    template <class Type>
    void operator()(const char* key, Type& value) {
        if (auto written = put(value); !written.is_null()) object_[key] = std::move(written);
    }

    /// The object with the unknown fields that were kept; empty if there are none.
    ordered_json finish(const std::string& extra) {
        const auto kept = extra.empty() ? ordered_json::object() : ordered_json::parse(extra);
        for (const auto& [key, value] : kept.items())
            if (!object_.contains(key)) object_[key] = value;
        return object_.empty() ? ordered_json(nullptr) : std::move(object_);
    }

private:
    static ordered_json put(const std::string& value) {
        return value.empty() ? ordered_json(nullptr) : ordered_json(value);
    }
    static ordered_json put(double value) { return value; }
    static ordered_json put(bool value) { return value; }
    static ordered_json put(std::size_t value) { return value; }
    static ordered_json put(const std::variant<double, std::string>& value) {
        return std::visit([](const auto& held) { return put(held); }, value);
    }
    static ordered_json put(const std::map<std::string, std::string>& value) {
        return value.empty() ? ordered_json(nullptr) : ordered_json(value);
    }
    static ordered_json put(ContainerLength& value) {
        return value.text.empty() ? put<ContainerLength>(value) : ordered_json(value.text);
    }
    template <class Type>
    static ordered_json put(std::optional<Type>& value) {
        return value ? put(*value) : ordered_json(nullptr);
    }
    template <class Type>
    static ordered_json put(std::vector<Type>& value) {
        if (value.empty()) return nullptr;
        auto list = ordered_json::array();
        for (auto& entry : value) {
            auto written = put(entry);
            list.push_back(written.is_null() ? empty_like(entry) : std::move(written));
        }
        return list;
    }
    template <Described Type>
    static ordered_json put(Type& value) {
        FieldWriter writer;
        fields_of(value, writer);
        return writer.finish(value.extra);
    }
    static ordered_json empty_like(const std::string&) { return ""; }
    template <class Type>
    static ordered_json empty_like(const Type&) {
        return ordered_json::object();
    }

    ordered_json object_ = ordered_json::object();
};

// ---- generations ----------------------------------------------------------------------------------------------------

void rename(json& object, const char* from, const char* to) {
    if (!object.is_object() || !object.contains(from) || object.contains(to)) return;
    object[to] = std::move(object[from]);
    object.erase(from);
}

/// Moves the content of the newer document "metadata" to the places of generation C.
void flatten_metadata(json& topography) {
    if (!topography.is_object() || !topography.contains("metadata") || !topography["metadata"].is_object()) return;
    auto& metadata = topography["metadata"];
    if (!topography.contains("size") && metadata.contains("size_x")) {
        topography["size"] = json::array({metadata["size_x"]});
        if (metadata.contains("size_y")) topography["size"].push_back(metadata["size_y"]);
        metadata.erase("size_x");
        metadata.erase("size_y");
    }
    for (const char* key : {"unit", "height_scale", "detrend_mode", "fill_undefined_data_mode", "is_periodic",
                            "has_undefined_data", "instrument"}) {
        if (topography.contains(key) || !metadata.contains(key)) continue;
        topography[key] = std::move(metadata[key]);
        metadata.erase(key);
    }
    if (metadata.empty()) topography.erase("metadata");
}

/// Converts keys of other generations to those of generation C.
void modernise(json& index) {
    rename(index, "creation_time", "created_at");
    for (auto& surface : index["surfaces"]) {
        rename(surface, "creator", "created_by");
        rename(surface, "measurements", "topographies");
        if (!surface.is_object() || !surface.contains("topographies") || !surface["topographies"].is_array()) continue;
        for (auto& topography : surface["topographies"]) {
            rename(topography, "creator", "created_by");
            flatten_metadata(topography);
        }
    }
}

}  // namespace

json parsed_index(const bytes::Archive& archive, const bytes::Source& source) {
    const auto* name = archive.has(json_index) ? json_index : yaml_index;
    const auto label = fmt::format("{}: {}", source.name, name);
    if (!archive.has(name))
        throw FormatError(source.name, {}, "an archive without index.json or meta.yml, one of which a container needs");
    auto index = name == json_index
                     ? bytes::parsed_json(archive.read(name), label, "the index is not valid JSON; it is damaged")
                     : json_from_yaml(archive.read(name), label);
    if (!index.is_object() || !index.contains("surfaces") || !index["surfaces"].is_array())
        throw FormatError(label, {}, "the index has no list of surfaces");
    modernise(index);
    return index;
}

IndexContent index_content(json index) {
    IndexContent content;
    FieldReader reader(index, "", content.alerts);
    fields_of(content.container, reader);
    content.container.extra = reader.rest();
    return content;
}

ordered_json index_of(const Container& container) {
    auto copy = container;
    FieldWriter writer;
    fields_of(copy, writer);
    auto index = writer.finish(copy.extra);
    if (!index.contains("surfaces")) index["surfaces"] = ordered_json::array();
    return index;
}

}  // namespace setae::formats
