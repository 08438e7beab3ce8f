// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "sample_files.hpp"
#include "setae/formats/container.hpp"

// Indices of every generation, created by code independent of the library: reading, writing and reading again gives the
// same content.
using namespace setae::tests;

namespace setae::formats::tests::container_property_test {
namespace {

using nlohmann::json;

std::string any_text() {
    const auto pieces = *rc::gen::container<std::vector<std::string>>(
        rc::gen::element<std::string>("a", "Z", "0", " ", "-", ":", "#", "\"", "'", "\\", "\n", "\t", "\x7f", "µ", "–",
                                      "😀", "\xc2\x85", "null", "1e-9", "!!", "&a", "*a"));
    std::string text = "t";
    for (const auto& piece : pieces) text += piece;
    return text;
}

double any_number() {
    return *rc::gen::oneOf(rc::gen::map(rc::gen::inRange(-100000, 100000), [](int n) { return n / 8.0; }),
                           rc::gen::element(1e-9, 2.5e300, -1e-7, 0.0));
}

bool often() { return *rc::gen::inRange(0, 4) > 0; }

json any_author() {
    json author{{"name", any_text()}};
    if (often()) author["orcid"] = "0000-0001-2345-6789";
    return author;
}

json any_texts() {
    auto list = json::array();
    for (int left = *rc::gen::inRange(0, 3); left > 0; --left) list.push_back(any_text());
    return list;
}

json any_unknown() {
    return {{"value", any_number()}, {"list", json::array({any_text(), nullptr, true, json::object()})}};
}

json any_instrument() {
    json instrument{{"name", any_text()}, {"type", "contact-based"}};
    if (often()) instrument["parameters"] = {{"tip_radius", {{"value", any_number()}, {"unit", "nm"}}}};
    if (often()) instrument["serial"] = any_unknown();
    return instrument;
}

json any_topography() {
    json topography{{"name", any_text()}, {"datafile", {{"original", any_text()}}}, {"size", {any_number()}}};
    if (often()) topography["datafile"]["squeezed-netcdf"] = any_text();
    if (often()) topography["size"].push_back(any_number());
    if (often()) topography["unit"] = "um";
    if (often()) topography["data_source"] = *rc::gen::inRange(0, 100);
    if (often()) topography["height_scale"] = any_number();
    if (often()) topography["has_undefined_data"] = often();
    if (often()) topography["undefined_data_fraction"] = any_number();
    if (often()) topography["fill_undefined_data_mode"] = "harmonic";
    if (often()) topography["detrend_mode"] = "height";
    if (often()) topography["is_periodic"] = often();
    if (often()) topography["created_by"] = any_author();
    if (often()) topography["measurement_date"] = "2016-02-15";
    if (often()) topography["description"] = any_text();
    if (often()) topography["tags"] = any_texts();
    if (often()) topography["instrument"] = any_instrument();
    if (often()) topography["humidity"] = any_unknown();
    return topography;
}

json any_surface() {
    json surface{{"name", any_text()}, {"topographies", json::array()}};
    if (often()) surface["category"] = "exp";
    if (often()) surface["created_by"] = any_author();
    if (often()) surface["tags"] = any_texts();
    if (often()) surface["is_published"] = often();
    if (often())
        surface["properties"] = {{{"name", any_text()}, {"value", any_number()}, {"unit", "GPa"}},
                                 {{"name", any_text()}, {"value", any_text()}},
                                 {{"name", any_text()}}};
    if (often())
        surface["publication"] = {{"url", any_text()},
                                  {"license", "cc0-1.0"},
                                  {"authors", any_text()},
                                  {"version", 3},
                                  {"date", "2024-05-06"}};
    for (int left = *rc::gen::inRange(0, 4); left > 0; --left) surface["topographies"].push_back(any_topography());
    return surface;
}

json any_index() {
    json index{{"versions", {{"topobank", "1.70.0"}}}, {"created_at", any_text()}, {"surfaces", json::array()}};
    if (often()) index["extra"] = any_unknown();
    for (int left = *rc::gen::inRange(1, 3); left > 0; --left) index["surfaces"].push_back(any_surface());
    return index;
}

void rename(json& object, const char* from, const char* to) {
    if (!object.contains(from)) return;
    object[to] = object[from];
    object.erase(from);
}

json with_old_keys(json index) {
    rename(index, "created_at", "creation_time");
    for (auto& surface : index["surfaces"]) {
        rename(surface, "created_by", "creator");
        for (auto& topography : surface["topographies"]) rename(topography, "created_by", "creator");
    }
    return index;
}

json as_skeleton(json index) {
    for (auto& surface : index["surfaces"])
        for (auto& topography : surface["topographies"])
            topography = {{"name", topography["name"]},
                          {"datafile", {{"squeezed-netcdf", "a.nc"}}},
                          {"size", topography["size"]}};
    return index;
}

/// The index as YAML in flow style, which JSON is; sizes are tuples as Python writes them.
std::string as_old_yaml(const json& index) {
    auto text = index.dump(-1, ' ', true);
    for (auto at = text.find("\"size\":["); at != std::string::npos; at = text.find("\"size\":[", at + 8))
        text.insert(at + 7, " !!python/tuple ");
    return text;
}

/// Characters beyond the first plane are pairs in ASCII JSON, which YAML reads as two: they are left out there.
json without_pairs(const json& index) {
    auto text = index.dump();
    for (auto at = text.find("😀"); at != std::string::npos; at = text.find("😀"))
        text.erase(at, std::string("😀").size());
    return json::parse(text);
}

void require_the_same_again(const bytes::Source& source, const json& index) {
    const TemporaryFolder folder;
    const auto before = read_container(source);
    RC_ASSERT(before.container.surfaces.size() == index["surfaces"].size());
    write_container(folder.path("c.zip"), before.container, {});
    const auto written = bytes::file_source(folder.path("c.zip"));
    RC_ASSERT(read_container(written).container == before.container);
    RC_ASSERT(container_differences(source, written).empty());
    const auto yaml = container_member(written, "meta.yml").all();
    RC_ASSERT(read_container(bytes::memory_source("y.zip", zip_archive({{"meta.yml", yaml}}))).container ==
              before.container);
}

RC_GTEST_PROP(Container, OfAnyGenerationIsUnchangedAfterWritingAndReading, ()) {
    const auto index = without_pairs(any_index());
    const auto skeleton = as_skeleton(index);
    const Members generation_a{{"meta.yml", as_old_yaml(with_old_keys(index))}};
    const Members generation_b{{"index.json", with_old_keys(index).dump()},
                               {"meta.yml", as_old_yaml(with_old_keys(index))}};
    const Members generation_c{{"index.json", index.dump()}};
    const Members skeletons{{"index.json", skeleton.dump()}, {"meta.yml", as_old_yaml(skeleton)}};
    for (const auto& [members, said] :
         {std::pair{generation_a, index}, {generation_b, index}, {generation_c, index}, {skeletons, skeleton}})
        require_the_same_again(bytes::memory_source("c.zip", zip_archive(members)), said);
}

RC_GTEST_PROP(Container, HasTheSameContentInEveryGeneration, ()) {
    const auto index = without_pairs(any_index());
    const auto read = [](const Members& members) {
        return read_container(bytes::memory_source("c.zip", zip_archive(members))).container;
    };
    const auto newest = read({{"index.json", index.dump()}});
    RC_ASSERT(read({{"index.json", with_old_keys(index).dump()}}) == newest);
    RC_ASSERT(read({{"meta.yml", as_old_yaml(with_old_keys(index))}}) == newest);
}

}  // namespace
}  // namespace setae::formats::tests::container_property_test
