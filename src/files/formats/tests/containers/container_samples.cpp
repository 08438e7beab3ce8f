// SPDX-License-Identifier: GPL-3.0-or-later
#include "container_samples.hpp"

#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/netcdf.hpp"

using namespace setae::tests;

namespace setae::formats::tests {

std::string old_yaml_index() {
    return R"(creation_time: '2021-06-21 15:06:49.300694+00:00'
surfaces:
- category: exp
  creator: &id001
    name: A. Person
    orcid: 0000-0001-0000-0000
  description: "two instruments \u2013 one wafer"
  is_published: false
  name: wafer
  tags: [lab/diamond]
  topographies:
  - creator: *id001
    data_source: 0
    datafile:
      original: line.txt
    detrend_mode: curvature
    height_scale: 2.0
    is_periodic: true
    measurement_date: 2016-02-15
    name: '1'
    size: !!python/tuple
    - 4.0
    tags: []
    unit: um
  - creator: *id001
    datafile:
      squeezed-netcdf: map.nc
    detrend_mode: center
    name: map
    size: !!python/tuple
    - 0.5
    - 0.25
    unit: um
versions:
  topobank: 0.13.0
)";
}

std::string transitional_json_index() {
    return R"({"versions": {"topobank": "1.64.0"}, "creation_time": "2025-01-02 03:04:05", "surfaces": [{"name": "wafer", "category": "exp",
"creator": {"name": "A. Person", "orcid": null}, "topographies": [
{"name": "1", "creator": {"name": "A. Person"}, "datafile": {"original": "line.txt"}, "unit": "um", "size": [4.0], "height_scale": 2.0, "is_periodic": true},
{"name": "map", "datafile": {"squeezed-netcdf": "map.nc"}, "unit": "um", "size": [0.5, 0.25], "has_undefined_data": true}]}]})";
}

std::string json_index_text() {
    return R"({"versions": {"topobank": "1.70.0"}, "created_at": "2026-01-02 03:04:05", "extra": {"groups": [[0]]}, "surfaces": [{"name": "wafer",
"category": "exp", "created_by": {"name": "A. Person", "orcid": "0000-0001-0000-0000"}, "description": "two instruments", "tags": ["lab/diamond"],
"is_published": true, "publication": {"url": "https://contact.engineering/go/abc", "license": "ccby-4.0", "authors": "A. Person", "version": 2,
"date": "2026-01-01", "doi_url": "https://doi.org/10.57703/ce-abc", "doi_state": "findable"},
"properties": [{"name": "hardness", "value": 9.5, "unit": "GPa"}, {"name": "batch", "value": "W7"}], "topographies": [
{"name": "1", "datafile": {"original": "line.txt"}, "unit": "um", "size": [4.0], "data_source": 0, "height_scale": 2.0, "is_periodic": true,
"undefined_data_fraction": 0.0, "detrend_mode": "curvature", "fill_undefined_data_mode": "do-not-fill", "measurement_date": "2016-02-15",
"instrument": {"name": "P", "type": "contact-based", "parameters": {"tip_radius": {"value": 5.0, "unit": "um"}}, "vendor": "V"}},
{"name": "map", "datafile": {"squeezed-netcdf": "map.nc"}, "unit": "um", "size": [0.5, 0.25], "humidity": {"value": 40, "unit": "%"}}]}]})";
}

std::string skeleton_json_index() {
    return R"({"versions": {"SurfaceTopography": "1.27.1"}, "surfaces": [{"name": "surface0", "description": "", "tags": [], "is_published": false,
"topographies": [{"name": "topography0.nc", "datafile": {"squeezed-netcdf": "map.nc"}, "size": [0.5, 0.25], "unit": "um", "data_source": 0,
"fill_undefined_data_mode": "do-not-fill", "detrend_mode": "center", "is_periodic": false, "measurement_date": "1970-01-01", "description": "", "tags": []}]}],
"created_at": "2026-11-21 09:19:58.409657"})";
}

std::vector<FormatSample> container_samples() {
    auto heights = lopsided_heights(5, 4, 1e-9);
    heights(2, 1) = undefined;
    const auto map = netcdf_content(topography::HeightMap{heights, {0.5e-6, 0.25e-6}, false, {}}, "um");
    const std::string line = "0 1\n1 3\n2 2\n3 5\n";
    const Members both{{"line.txt", line}, {"map.nc", map}};
    const auto with = [&](const char* name, const std::string& index, Members members) {
        members.insert(members.begin(), {name, index});
        return zip_archive(members);
    };
    std::vector<FormatSample> samples;
    const auto add = [&](const char* name, std::string content, std::size_t channel) {
        auto& sample = samples.emplace_back();
        sample.format = "ce-container";
        sample.name = name;
        sample.content = std::move(content);
        sample.channel = channel;
        sample.shape = {5, 4};
        sample.size = {0.5e-6, 0.25e-6};
        sample.heights = heights;
        sample.member_format = "nc";
    };
    add("generation A", with("meta.yml", old_yaml_index(), both), 1);
    add("generation B", with("index.json", transitional_json_index(), both), 1);
    add("generation C", with("index.json", json_index_text(), both), 1);
    add("skeleton", with("index.json", skeleton_json_index(), {{"map.nc", map}}), 0);
    return samples;
}

}  // namespace setae::formats::tests
