// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "container_samples.hpp"
#include "sample_files.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/container.hpp"
#include "setae/formats/format.hpp"
#include "setae/formats/netcdf.hpp"
#include "setae/formats/npy.hpp"

using namespace setae::tests;

namespace setae::formats::tests::container_test {
namespace {

using topography::HeightMap;
using topography::LineScan;

bytes::Source container(const Members& members) { return bytes::memory_source("c.zip", zip_archive(members)); }

const std::string line_text = "0 1\n1 3\n2 2\n3 5\n";

bytes::Source one_line(const std::string& index_fields) {
    return container(
        {{"index.json", R"({"surfaces": [{"name": "s", "topographies": [{"name": "l", )" + index_fields + "}]}]}"},
         {"line.txt", line_text}});
}

/// The members of a container, unchanged.
std::vector<ContainerMember> members_of(const bytes::Source& source) {
    std::vector<ContainerMember> members;
    for (const auto& name : read_container(source).members)
        members.push_back({name, [source, name] { return container_member(source, name); }});
    return members;
}

TEST(ContainerIndex, DetectsTheGeneration) {
    EXPECT_EQ(read_container(container({{"meta.yml", old_yaml_index()}})).generation, ContainerGeneration::yaml);
    EXPECT_EQ(read_container(container({{"index.json", transitional_json_index()}, {"meta.yml", old_yaml_index()}}))
                  .generation,
              ContainerGeneration::both);
    EXPECT_EQ(read_container(container({{"index.json", json_index_text()}})).generation, ContainerGeneration::json);
    EXPECT_EQ(read_container(container({{"index.json", skeleton_json_index()}})).generation,
              ContainerGeneration::skeleton);
}

TEST(ContainerIndex, ReadsOldKeys) {
    const auto file = read_container(container({{"meta.yml", old_yaml_index()}}));
    EXPECT_TRUE(file.alerts.empty());
    EXPECT_EQ(file.container.created_at, "2021-06-21 15:06:49.300694+00:00");
    const auto& surface = file.container.surfaces.at(0);
    EXPECT_EQ(surface.created_by->orcid, "0000-0001-0000-0000");
    EXPECT_EQ(surface.description, "two instruments – one wafer");
    ASSERT_EQ(surface.topographies.size(), 2u);
    EXPECT_EQ(surface.topographies[0].created_by->name, "A. Person");
    EXPECT_EQ(surface.topographies[0].measurement_date, "2016-02-15");
    EXPECT_EQ(surface.topographies[0].name, "1");
    EXPECT_EQ(surface.topographies[1].size, (std::vector<double>{0.5, 0.25}));
    EXPECT_EQ(surface.topographies[1].data_source, std::nullopt);
}

TEST(ContainerIndex, ReadsAllFieldsOfTheNewestGeneration) {
    const auto file = read_container(container({{"index.json", json_index_text()}}));
    const auto& surface = file.container.surfaces.at(0);
    EXPECT_EQ(file.container.extra, R"({"extra":{"groups":[[0]]}})");
    EXPECT_EQ(std::get<double>(surface.properties.at(0).value.value()), 9.5);
    EXPECT_EQ(std::get<std::string>(surface.properties.at(1).value.value()), "W7");
    EXPECT_EQ(surface.publication->version, 2u);
    EXPECT_EQ(surface.topographies.at(0).undefined_data_fraction, 0.0);
    EXPECT_DOUBLE_EQ(surface.topographies[0].instrument->parameters->tip_radius->metres().value(), 5e-6);
    EXPECT_EQ(surface.topographies[0].instrument->extra, R"({"vendor":"V"})");
    EXPECT_EQ(surface.topographies.at(1).extra, R"({"humidity":{"unit":"%","value":40}})");
    ASSERT_EQ(file.alerts.size(), 2u);
    EXPECT_EQ(file.alerts[0].code, "UNKNOWN_FIELD");
    EXPECT_EQ(file.alerts[0].subject, "surfaces/0/topographies/0/instrument/vendor");
}

TEST(ContainerIndex, ReadsStandardErrorsOfInstrumentParameters) {
    const auto file = read_container(container({{"meta.yml",
                                                 "surfaces:\n- name: s\n  topographies:\n  - name: t\n    instrument:\n"
                                                 "      name: D\n      parameters:\n        tip_radius: 10 ± 2 nm\n"
                                                 "        lateral_calibration: 1.00 ± 0.01\n"}}));
    EXPECT_TRUE(file.alerts.empty());
    const auto& parameters = *file.container.surfaces.at(0).topographies.at(0).instrument->parameters;
    EXPECT_DOUBLE_EQ(parameters.tip_radius->estimate()->standard_error, 2e-9);
    EXPECT_EQ(parameters.lateral_calibration, "1.00 ± 0.01");
    const TemporaryFolder folder;
    write_container(folder.path("c.zip"), file.container, {});
    EXPECT_EQ(read_container(bytes::file_source(folder.path("c.zip"))).container.surfaces, file.container.surfaces);
}

TEST(ContainerIndex, PropertyWithoutValueRemainsWithoutValue) {
    const auto without = container(
        {{"index.json",
          R"({"surfaces": [{"name": "s", "properties": [{"name": "batch"}, {"name": "odd", "value": [1]}]}]})"}});
    EXPECT_EQ(read_container(without).container.surfaces.at(0).properties.at(0).value, std::nullopt);
    const TemporaryFolder folder;
    write_container(folder.path("c.zip"), read_container(without).container, {});
    EXPECT_TRUE(container_differences(without, bytes::file_source(folder.path("c.zip"))).empty());
}

TEST(ContainerIndex, IndexJsonIsPreferredToMetaYml) {
    const auto file =
        read_container(container({{"meta.yml", old_yaml_index()}, {"index.json", skeleton_json_index()}}));
    EXPECT_EQ(file.container.surfaces.at(0).name, "surface0");
}

TEST(ContainerIndex, FieldsOfTheWrongKindAreKeptAndNotUsed) {
    const auto source = one_line(R"("datafile": {"original": "line.txt"}, "size": "wide", "unit": "um")");
    const auto file = read_container(source);
    EXPECT_EQ(file.alerts.at(0).code, "MALFORMED_FIELD");
    EXPECT_EQ(file.container.surfaces[0].topographies[0].extra, R"({"size":"wide"})");
    const auto channels = open(source, {});
    EXPECT_EQ(channels.at(0).info.alerts.at(0).code, "UNREADABLE_MEMBER");
    EXPECT_NE(channels[0].info.alerts[0].message.find("size"), std::string::npos);
}

TEST(ContainerIndex, FindsMeasurementsOfTheNewestTopoBank) {
    const auto source = container(
        {{"index.json",
          R"({"surfaces": [{"name": "s", "measurements": [{"name": "l", "kind": "height", "datafile": {"original": "line.txt"},
"channel": {"name": "Default"}, "metadata": {"kind": "height", "size_x": 4.0, "unit": "um", "height_scale": 2.0, "detrend_mode": "height",
"instrument": {"name": "P"}}}, {"name": "i", "datafile": {"original": "i.spm"}, "channel": {"name": "Height", "occurrence": 0}}]}]})"},
         {"line.txt", line_text},
         {"i.spm", nanoscope_file(4, 3, 2)}});
    const auto topography = read_container(source).container.surfaces.at(0).topographies.at(0);
    EXPECT_EQ(topography.size, std::vector<double>{4.0});
    EXPECT_EQ(topography.extra, R"({"kind":"height","metadata":{"kind":"height"}})");
    const auto channels = open(source, {});
    EXPECT_EQ(channels.at(0).info.recommended_trend, topography::Trend::tilt);
    EXPECT_EQ(channels[0].info.metadata.instrument.name, "P");
    EXPECT_DOUBLE_EQ(std::get<LineScan>(channels[0].read()).heights[3], 10e-6) << "the only channel of heights, scaled";
    EXPECT_EQ(channels.at(1).info.shape, (std::vector<Index>{4, 3}));
}

TEST(ContainerIndex, YamlObjectsAreNotExecuted) {
    const TemporaryFolder folder;
    const auto trace = folder.path("trace");
    const auto yaml = "surfaces:\n- name: !!python/object/apply:os.system ['touch " + trace +
                      "']\n  topographies: !!python/object:os.x {a: b}\n";
    const auto file = read_container(container({{"meta.yml", yaml}}));
    EXPECT_EQ(file.container.surfaces.at(0).name, "");
    EXPECT_EQ(file.alerts.size(), 2u);
    EXPECT_FALSE(std::filesystem::exists(trace));
}

TEST(ContainerIndex, MultiplyingAliasesAreRefused) {
    std::string yaml = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
    for (int level = 1; level < 9; ++level) {
        yaml += fmt::format("a{}: &a{} [", level, level);
        for (int i = 0; i < 10; ++i) yaml += fmt::format("{}*a{}", i ? ", " : "", level - 1);
        yaml += "]\n";
    }
    const std::string text(2000, 'x');
    std::string long_texts = "surfaces:\n- &t " + text + "\n";
    for (int i = 0; i < 200; ++i) long_texts += "- *t\n";
    for (const auto& bomb : {yaml + "surfaces: []\n", long_texts}) {
        try {
            (void)read_container(container({{"meta.yml", bomb}}));
            FAIL() << "opened";
        } catch (const FormatError& error) {
            EXPECT_NE(std::string(error.what()).find("its aliases repeat too much"), std::string::npos) << error.what();
        }
    }
}

TEST(ContainerIndex, DeepNestingIsRefused) {
    const std::string deep(100000, '[');
    for (const auto* name : {"index.json", "meta.yml"})
        EXPECT_THROW((void)read_container(container({{name, "{\"surfaces\": " + deep}})), FormatError) << name;
    const auto closed = std::string(100, '[') + std::string(100, ']');
    EXPECT_THROW((void)read_container(container({{"index.json", R"({"surfaces": [], "x": )" + closed + "}"}})),
                 FormatError);
}

TEST(ContainerMember, OutsideTheArchiveIsRefused) {
    EXPECT_THROW((void)read_container(container({{"index.json", R"({"surfaces": []})"}, {"../evil", "x"}})),
                 FormatError);
}

TEST(ContainerMember, MissingDoesNotAffectOthers) {
    const auto source = container({{"index.json", R"({"surfaces": [{"name": "s", "topographies": [
{"name": "gone", "datafile": {"original": "../line.txt"}, "unit": "um"},
{"name": "here", "datafile": {"original": "line.txt"}, "unit": "um", "size": [4]}]}]})"},
                                   {"line.txt", line_text}});
    const auto channels = open(source, {});
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.alerts.at(0).code, "UNREADABLE_MEMBER");
    EXPECT_DOUBLE_EQ(std::get<LineScan>(channels[1].read()).heights[3], 5e-6);
}

TEST(ContainerMember, WithProcessedCopyOnlyGivesAWarning) {
    const auto map = netcdf_content(HeightMap{Array2D::Random(4, 3), {2.0, 1.0}, false, {}}, "um");
    const auto source = container({{"index.json", R"({"surfaces": [{"topographies": [{"name": "m", "height_scale": 7,
"datafile": {"original": "lost.spm", "squeezed-netcdf": "m.nc"}, "size": [2e6, 1e6], "unit": "um"}]}]})"},
                                   {"m.nc", map}});
    const auto channel = open(source, {}).at(0);
    EXPECT_EQ(channel.info.alerts.at(0).code, "ORIGINAL_MISSING");
    EXPECT_LE(std::get<HeightMap>(channel.read()).heights.abs().maxCoeff(), 1.0)
        << "a processed copy is scaled already";
}

TEST(ContainerMember, CompressedByGzipIsRead) {
    const std::string packed{
        "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\xff\x33\x50\x30\xe4\x32\x54\x30\xe6\x32\x52\x30\xe2\x32\x56\x30\xe5\x02\x00\x49\x5c\x7a\x15\x10\x00\x00\x00",
        36};
    const auto source = container(
        {{"index.json",
          R"({"surfaces": [{"topographies": [{"name": "l", "datafile": {"original": "line.txt.gz"}, "unit": "um",
"size": [4]}]}]})"},
         {"line.txt.gz", packed}});
    EXPECT_DOUBLE_EQ(std::get<LineScan>(open(source, {}).at(0).read()).heights[3], 5e-6);
}

TEST(ContainerMember, BeingAContainerIsRefused) {
    const auto inner = zip_archive({{"index.json", R"({"surfaces": [{"topographies": [{"name": "l"}]}]})"}});
    const auto source = container(
        {{"index.json", R"({"surfaces": [{"topographies": [{"name": "l", "datafile": {"original": "c.zip"}}]}]})"},
         {"c.zip", inner}});
    EXPECT_NE(open(source, {}).at(0).info.alerts.at(0).message.find("container within a container"), std::string::npos);
}

TEST(ContainerMember, UnitOtherThanThatOfTheFileGivesAWarning) {
    const auto map = netcdf_content(HeightMap{Array2D::Random(4, 3), {2.0, 1.0}, false, {}}, "m");
    const auto source = container(
        {{"index.json",
          R"({"surfaces": [{"topographies": [{"name": "m", "datafile": {"squeezed-netcdf": "m.nc"}, "size": [2e6, 1e6],
"unit": "um"}]}]})"},
         {"m.nc", map}});
    const auto info = open(source, {}).at(0).info;
    ASSERT_EQ(info.alerts.size(), 1u);
    EXPECT_EQ(info.alerts[0].code, "UNIT_MISMATCH");
    EXPECT_EQ(info.unit, "m");
}

/// Bytes this process has read.
std::uint64_t bytes_read() {
    std::ifstream counters("/proc/self/io");
    std::string word;
    std::uint64_t count = 0;
    counters >> word >> count;
    return count;
}

TEST(ContainerMember, IsOpenedWithoutItsHeights) {
    const TemporaryFolder folder;
    constexpr Index points = 1 << 22;
    write_npy(folder.path("h.npy"), Array1D(Array1D::LinSpaced(points, 0.0, 1.0)));
    Container large;
    large.surfaces.emplace_back().topographies.emplace_back();
    auto& topography = large.surfaces[0].topographies[0];
    topography.datafile.original = "h.npy";
    topography.size = {1.0};
    topography.unit = "mm";
    write_container(folder.path("c.zip"), large, {{"h.npy", [&] { return bytes::file_source(folder.path("h.npy")); }}});
    const auto before = bytes_read();
    const auto channels = open(folder.path("c.zip"));
    EXPECT_LT(bytes_read() - before, 1u << 20);
    EXPECT_EQ(channels.at(0).info.shape, std::vector<Index>{points});
    EXPECT_DOUBLE_EQ(topography::all_heights(channels[0].read())[points - 1], 1e-3);
}

TEST(WrittenContainer, HasTheSameContentInEveryGeneration) {
    const TemporaryFolder folder;
    const std::pair<const char*, std::string> indices[] = {{"meta.yml", old_yaml_index()},
                                                           {"index.json", transitional_json_index()},
                                                           {"index.json", json_index_text()},
                                                           {"index.json", skeleton_json_index()}};
    for (const auto& [name, index] : indices) {
        const auto source = container({{name, index}, {"line.txt", line_text}, {"LICENSE-cc0-1.0.txt", "free"}});
        const auto before = read_container(source);
        write_container(folder.path("w.zip"), before.container, members_of(source));
        const auto written = bytes::file_source(folder.path("w.zip"));
        const auto after = read_container(written);
        EXPECT_EQ(after.container, before.container) << index;
        const auto differences = container_differences(source, written);
        EXPECT_TRUE(differences.empty()) << index << differences.at(0);
        EXPECT_NE(after.generation, ContainerGeneration::yaml);
    }
}

TEST(WrittenContainer, HasTheSameContentInBothIndices) {
    const TemporaryFolder folder;
    auto file = read_container(container({{"index.json", json_index_text()}}));
    file.container.surfaces[0].description =
        "line\nbreak \"quoted\" \\ \x7f\xc2\x85\xe2\x80\xa8\xef\xbb\xbf é 😀: - # 1e-9";
    file.container.surfaces[0].topographies[0].size = {1e-9};
    file.container.surfaces[0].tags = {"1", "true", "null", "1e-09", "2016-02-15", ""};
    write_container(folder.path("w.zip"), file.container, {});
    const auto written = bytes::file_source(folder.path("w.zip"));
    const auto yaml = container_member(written, "meta.yml").all();
    const auto from_yaml = read_container(container({{"meta.yml", yaml}}));
    EXPECT_EQ(from_yaml.container, file.container);
    EXPECT_EQ(read_container(container({{"index.json", container_member(written, "index.json").all()}})).container,
              file.container);
    EXPECT_NE(yaml.find("1.0e-09"), std::string::npos) << "YAML 1.1 takes 1e-09 for a text";
}

TEST(WrittenContainer, IsReproducibleByteByByte) {
    const TemporaryFolder folder;
    const auto source = container({{"meta.yml", old_yaml_index()}, {"line.txt", line_text}});
    for (const auto* name : {"a.zip", "b.zip"})
        write_container(folder.path(name), read_container(source).container, members_of(source));
    EXPECT_EQ(bytes::read_file(folder.path("a.zip")), bytes::read_file(folder.path("b.zip")));
}

TEST(WrittenContainer, CanReplaceItsSource) {
    const TemporaryFolder folder;
    const auto path = folder.write("c.zip", zip_archive({{"meta.yml", old_yaml_index()}, {"line.txt", line_text}}));
    const auto before = read_container(bytes::file_source(path));
    write_container(path, before.container, members_of(bytes::file_source(path)));
    EXPECT_EQ(read_container(bytes::file_source(path)).container, before.container);
    EXPECT_EQ(container_member(bytes::file_source(path), "line.txt").all(), line_text);
}

TEST(WrittenContainer, FailureOfAMemberKeepsTheOldFile) {
    const TemporaryFolder folder;
    const auto path = folder.write("c.zip", "old");
    const std::vector<ContainerMember> members{
        {"a", []() -> bytes::Source { throw FormatError("a", {}, "is damaged"); }}};
    EXPECT_THROW(write_container(path, {}, members), FormatError);
    EXPECT_EQ(bytes::read_file(path), "old");
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(path).parent_path()))
        ++files;
    EXPECT_EQ(files, 1u) << "no temporary file is left";
}

TEST(WrittenContainer, RefusesDuplicateNamesAndPathsOutside) {
    const TemporaryFolder folder;
    const auto content = [] { return bytes::memory_source("x", "x"); };
    EXPECT_THROW(write_container(folder.path("c.zip"), {}, {{"a", content}, {"a", content}}), InvalidArgument);
    EXPECT_THROW(write_container(folder.path("c.zip"), {}, {{"../a", content}}), InvalidArgument);
    EXPECT_THROW(write_container(folder.path("c.zip"), {}, {{"index.json", content}}), InvalidArgument);
    EXPECT_THROW(write_container(folder.path("none/c.zip"), {}, {}), FileError);
}

TEST(ContainerDifferences, NameFieldsAndMembersThatDiffer) {
    const auto before =
        container({{"index.json", R"({"surfaces": [{"name": "s", "tags": []}]})"}, {"a", "1"}, {"b", "1"}});
    const auto after = container({{"index.json", R"({"surfaces": [{"name": "t"}]})"}, {"a", "2"}});
    EXPECT_EQ(container_differences(before, after),
              (std::vector<std::string>{"surfaces/0/name: \"s\" became \"t\"", "member a: differs",
                                        "member b: became absent"}));
}

TEST(ContainerSchema, ListsViolationsOfTheContactEngineeringSchema) {
    EXPECT_TRUE(schema_violations(read_container(container({{"index.json", json_index_text()}})).container).empty());
    const auto bad = read_container(container(
        {{"index.json", R"({"surfaces": [{"name": "", "topographies": [{"name": "l", "datafile": {}, "unit": 3,
"measurement_date": "yesterday", "size": [1]}]}]})"}}));
    std::vector<std::string> places;
    for (const auto& alert : schema_violations(bad.container)) places.push_back(alert.subject);
    EXPECT_EQ(places, (std::vector<std::string>{"surfaces/0/name", "surfaces/0/topographies/0/datafile",
                                                "surfaces/0/topographies/0/measurement_date",
                                                "surfaces/0/topographies/0/unit"}));
}

}  // namespace
}  // namespace setae::formats::tests::container_test
