// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/formats/container.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "container_index.hpp"
#include "container_yaml.hpp"
#include "setae/bytes/archive_writer.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::formats {
namespace {

using nlohmann::json;

bool is_index(const std::string& name) { return name == json_index || name == yaml_index; }

bool only_processed(const Container& container) {
    std::size_t count = 0;
    for (const auto& surface : container.surfaces)
        for (const auto& topography : surface.topographies) {
            if (!topography.datafile.original.empty() || topography.datafile.squeezed.empty()) return false;
            ++count;
        }
    return count > 0;
}

/// The keys of the index distinguish B and C.
ContainerGeneration generation_of(const bytes::Archive& archive, const Container& container) {
    if (only_processed(container)) return ContainerGeneration::skeleton;
    if (!archive.has(json_index)) return ContainerGeneration::yaml;
    const auto text = archive.read(json_index);
    return text.find("\"creation_time\"") != std::string::npos || text.find("\"creator\"") != std::string::npos
               ? ContainerGeneration::both
               : ContainerGeneration::json;
}

std::string readme(const Container& container) {
    std::size_t count = 0;
    for (const auto& surface : container.surfaces) count += surface.topographies.size();
    return fmt::format(
        "This archive contains {} surface(s) and {} measurement(s). index.json describes them; meta.yml has the same content for programs\n"
        "that need this index.\n\n"
        "A measurement has one to three files: \"original\", as it came from the instrument, and \"squeezed-netcdf\", the same heights as\n"
        "classic NetCDF, which is processed: multiplied by height_scale where the original carries no scale, filled by\n"
        "fill_undefined_data_mode, and with the trend of detrend_mode removed. Where other programs do not read what came from\n"
        "the instrument, \"original\" holds its heights in a layout they read, and \"setae-source\" the file as it came.\n",
        container.surfaces.size(), count);
}

bytes::Source text_source(const std::string& name, const std::string& text) { return bytes::memory_source(name, text); }

// ---- differences ----------------------------------------------------------------------------------------------------

/// Without empty values.
json pruned(const json& value) {
    if (!value.is_structured()) return value;
    auto result = value.is_array() ? json::array() : json::object();
    for (const auto& [key, entry] : value.items()) {
        auto kept = pruned(entry);
        if (value.is_array()) {
            result.push_back(std::move(kept));
            continue;
        }
        const bool is_empty = kept.is_null() || (kept.is_structured() && kept.empty()) ||
                              (kept.is_string() && kept.get_ref<const std::string&>().empty());
        if (!is_empty) result[key] = std::move(kept);
    }
    return result;
}

std::string shown(const json& root, const std::string& pointer) {
    const json::json_pointer at(pointer);
    return root.contains(at) ? root.at(at).dump(-1, ' ', false, json::error_handler_t::replace) : "absent";
}

void compare_indices(const json& before, const json& after, std::vector<std::string>& differences) {
    for (const auto& step : json::diff(before, after)) {
        const auto pointer = step.at("path").get<std::string>();
        differences.push_back(fmt::format("{}: {:.200} became {:.200}",
                                          pointer.substr(pointer.starts_with('/') ? 1 : 0), shown(before, pointer),
                                          shown(after, pointer)));
    }
}

bool same_bytes(const bytes::Source& a, const bytes::Source& b) {
    constexpr std::uint64_t step = 1 << 20;
    if (a.size != b.size) return false;
    for (std::uint64_t at = 0; at < a.size; at += step)
        if (const auto count = std::min(step, a.size - at); a.bytes(at, count) != b.bytes(at, count)) return false;
    return true;
}

void compare_members(const bytes::Archive& before, const bytes::Archive& after, std::vector<std::string>& differences) {
    for (const auto& name : before.names()) {
        if (is_index(name) || name.ends_with('/')) continue;
        if (!after.has(name)) differences.push_back(fmt::format("member {}: became absent", name));
        else if (!same_bytes(before.member(name), after.member(name)))
            differences.push_back(fmt::format("member {}: differs", name));
    }
    for (const auto& name : after.names())
        if (!is_index(name) && name != "README.txt" && !before.has(name))
            differences.push_back(fmt::format("member {}: is new", name));
}

// ---- the schema -----------------------------------------------------------------------------------------------------

class Violations {
public:
    void require(bool condition, const std::string& place, const std::string& what) {
        if (!condition)
            alerts_.push_back(
                {"NOT_IN_SCHEMA", place, what, "contact.engineering may refuse the container; complete the index"});
    }
    /// Reports a field that was kept because it violates the schema.
    void refuse_kept(const std::string& extra, const std::string& place, std::initializer_list<const char*> keys) {
        if (extra.empty()) return;
        const auto kept = json::parse(extra);
        for (const auto* key : keys)
            require(!kept.contains(key), fmt::format("{}/{}", place, key),
                    "does not have the form that the schema requires");
    }
    [[nodiscard]] std::vector<Alert> take() { return std::move(alerts_); }

private:
    std::vector<Alert> alerts_;
};

bool is_date(const std::string& text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (i != 4 && i != 7 && (text[i] < '0' || text[i] > '9')) return false;
    return text.substr(5, 2) >= "01" && text.substr(5, 2) <= "12" && text.substr(8, 2) >= "01" &&
           text.substr(8, 2) <= "31";
}

void check(const std::optional<ContainerAuthor>& author, const std::string& place, Violations& violations) {
    violations.require(!author || !author->name.empty(), place + "/created_by", "an author without a name");
}

void check(const ContainerTopography& topography, const std::string& place, Violations& violations) {
    violations.require(!topography.name.empty(), place + "/name", "no name is given");
    violations.require(!topography.datafile.original.empty() || !topography.datafile.squeezed.empty(),
                       place + "/datafile", "no file is named");
    violations.require(!topography.size.empty(), place + "/size", "no size is given");
    violations.require(topography.measurement_date.empty() || is_date(topography.measurement_date),
                       place + "/measurement_date",
                       fmt::format("'{}' is not a date such as 2016-02-15", topography.measurement_date));
    check(topography.created_by, place, violations);
    if (topography.instrument && topography.instrument->parameters) {
        const auto& tip = topography.instrument->parameters->tip_radius;
        violations.require(!tip || tip->text.empty(), place + "/instrument/parameters/tip_radius",
                           "a text with ±, where the schema requires value and unit");
    }
    violations.refuse_kept(
        topography.extra, place,
        {"name", "datafile", "size", "unit", "data_source", "has_undefined_data", "fill_undefined_data_mode",
         "detrend_mode", "is_periodic", "created_by", "description", "tags", "instrument", "height_scale"});
}

void check(const ContainerSurface& surface, const std::string& place, Violations& violations) {
    violations.require(!surface.name.empty(), place + "/name", "no name is given");
    check(surface.created_by, place, violations);
    for (std::size_t i = 0; i < surface.properties.size(); ++i)
        violations.require(!surface.properties[i].name.empty() && surface.properties[i].value,
                           fmt::format("{}/properties/{}", place, i), "a property without a name or value");
    if (const auto& publication = surface.publication) {
        const bool whole = !publication->url.empty() && !publication->license.empty() &&
                           !publication->authors.empty() && publication->version && !publication->date.empty();
        violations.require(whole, place + "/publication",
                           "a publication needs url, license, authors, version and date");
    }
    violations.refuse_kept(surface.extra, place,
                           {"name", "category", "created_by", "description", "tags", "is_published", "publication",
                            "properties", "topographies"});
    for (std::size_t i = 0; i < surface.topographies.size(); ++i)
        check(surface.topographies[i], fmt::format("{}/topographies/{}", place, i), violations);
}

}  // namespace

std::optional<Estimate> ContainerLength::estimate() const {
    if (!text.empty()) return parse_uncertain_quantity(text, positive(dimension::length));
    if (!value || unit.empty()) return std::nullopt;
    return Estimate{.value = *value * unit_factor(unit, dimension::length)};
}

std::optional<double> ContainerLength::metres() const {
    const auto length = estimate();
    return length ? std::optional(length->value) : std::nullopt;
}

std::string describe(ContainerGeneration generation) {
    switch (generation) {
        case ContainerGeneration::yaml: return "A (meta.yml)";
        case ContainerGeneration::both: return "B (index.json with the keys of meta.yml)";
        case ContainerGeneration::json: return "C (index.json)";
        case ContainerGeneration::skeleton: return "skeleton (only processed copies)";
    }
    throw InternalError("a generation of containers without description");
}

ContainerFile read_container(const bytes::Source& source) {
    const bytes::Archive archive(source);
    auto content = index_content(parsed_index(archive, source));
    ContainerFile file;
    file.generation = generation_of(archive, content.container);
    file.container = std::move(content.container);
    file.alerts = std::move(content.alerts);
    for (auto& name : archive.names())
        if (!is_index(name) && !name.ends_with('/')) file.members.push_back(std::move(name));
    return file;
}

bytes::Source container_member(const bytes::Source& source, const std::string& name) {
    return bytes::Archive(source).member(name);
}

void write_container(const std::string& path, const Container& container, const std::vector<ContainerMember>& members) {
    const auto index = index_of(container);
    std::vector<bytes::ArchiveMember> written;
    const auto add_text = [&](const char* name, std::string text) {
        written.push_back({name, [name, text = std::move(text)] { return text_source(name, text); }});
    };
    add_text(json_index, index.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
    add_text(yaml_index, yaml_from_json(index));
    const bool has_readme = std::any_of(members.begin(), members.end(),
                                        [](const ContainerMember& member) { return member.name == "README.txt"; });
    if (!has_readme) add_text("README.txt", readme(container));
    for (const auto& member : members) written.push_back({member.name, member.content});
    bytes::write_archive(path, written);
}

std::vector<Alert> schema_violations(const Container& container) {
    Violations violations;
    violations.refuse_kept(container.extra, "", {"versions", "surfaces", "created_at"});
    for (std::size_t i = 0; i < container.surfaces.size(); ++i)
        check(container.surfaces[i], fmt::format("surfaces/{}", i), violations);
    return violations.take();
}

std::vector<std::string> container_differences(const bytes::Source& before, const bytes::Source& after) {
    const bytes::Archive old_archive(before), new_archive(after);
    std::vector<std::string> differences;
    compare_indices(pruned(parsed_index(old_archive, before)), pruned(parsed_index(new_archive, after)), differences);
    compare_members(old_archive, new_archive, differences);
    return differences;
}

}  // namespace setae::formats
