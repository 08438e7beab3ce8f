// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "container_samples.hpp"
#include "sample_files.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/container_draft.hpp"
#include "setae/formats/format.hpp"
#include "setae/formats/netcdf.hpp"
#include "setae/formats/npy.hpp"

using namespace setae::tests;

namespace setae::formats::tests::container_draft_test {
namespace {

using topography::HeightMap;
using topography::LineScan;

bool has_code(const std::vector<Alert>& alerts, const std::string& code) {
    for (const auto& alert : alerts)
        if (alert.code == code) return true;
    return false;
}

bytes::Source written(const TemporaryFolder& folder, const ContainerDraft& draft) {
    write_container(folder.path("out.zip"), draft.container, draft.members);
    return bytes::file_source(folder.path("out.zip"));
}

/// A container of one measured file.
bytes::Source one_file(const TemporaryFolder& folder, const StoredMeasurement& measurement) {
    ContainerDraft draft;
    ContainerSurface surface{.name = "wafer"};
    add_measurement(draft, surface, measurement);
    draft.container.surfaces.push_back(surface);
    return written(folder, draft);
}

const std::string two_lines = "x [um],h [nm]\n0,1\n1,3\n2,2\n3,6\n";

TEST(ContainerDraft, ContainsTheFileUnchangedAndAProcessedCopy) {
    const TemporaryFolder folder;
    const auto bytes = nanoscope_file(4, 3, 2);
    const auto container = one_file(folder, {.path = folder.write("a b.spm", bytes)});
    const auto topography = read_container(container).container.surfaces.at(0).topographies.at(0);
    EXPECT_EQ(topography.datafile.original, "0-a-b.spm");
    EXPECT_EQ(topography.datafile.squeezed, "0-a-b-squeezed.nc");
    EXPECT_EQ(container_member(container, topography.datafile.original).all(), bytes);
    EXPECT_EQ(topography.unit, "nm");
    EXPECT_EQ(topography.size, (std::vector<double>{500.0, 250.0}));
    EXPECT_EQ(topography.height_scale, std::nullopt) << "the file carries its own";
    EXPECT_EQ(topography.measurement_date, "2016-01-12");
    EXPECT_EQ(topography.instrument->name, "Dimension V");
    EXPECT_TRUE(schema_violations(read_container(container).container).empty());
}

const std::string traced =
    "# format: setae profile\n# version: 1\n# instrument: tem\nx [m],h [m],standard_error [m]\n"
    "0,1.2e-09,6e-11\n5.1e-11,1.3e-09,6.2e-11\n1.1e-10,1.5e-09,7e-11\n";

TEST(ContainerDraft, TracedContourIsAlsoWrittenAsTwoColumns) {
    const TemporaryFolder folder;
    const auto container = one_file(folder, {.path = folder.write("soot.csv", traced)});
    const auto topography = read_container(container).container.surfaces.at(0).topographies.at(0);
    EXPECT_EQ(topography.datafile.original, "0-soot-heights.txt");
    EXPECT_EQ(container_member(container, topography.datafile.original).all(), "0\t1.2\n0.051\t1.3\n0.11\t1.5\n");
    EXPECT_EQ(topography.unit, "nm");
    EXPECT_EQ(container_member(container, topography.datafile.source).all(), traced);
    const auto profile = std::get<topography::Profile>(open(container, {}).at(0).read());
    EXPECT_EQ(profile.standard_error[2], 7e-11);
    EXPECT_EQ(profile.positions[1], 5.1e-11);
}

TEST(ContainerDraft, KeepsSourceFilesOfAContainer) {
    const TemporaryFolder folder;
    ContainerDraft draft;
    add_container(draft, one_file(folder, {.path = folder.write("soot.csv", traced)}));
    write_container(folder.path("again.zip"), draft.container, draft.members);
    const auto again = bytes::file_source(folder.path("again.zip"));
    EXPECT_EQ(std::get<topography::Profile>(open(again, {}).at(0).read()).standard_error[2], 7e-11);
    ContainerDraft other;
    ContainerSurface surface{.name = "wafer"};
    add_measurements_of(other, surface, {.path = folder.path("again.zip")});
    other.container.surfaces.push_back(surface);
    EXPECT_EQ(std::get<topography::Profile>(open(written(folder, other), {}).at(0).read()).standard_error[2], 7e-11);
}

// Other programs read value and unit of the radius; the ± is next to them.
TEST(ContainerDraft, KeepsStandardErrorsOfInstrumentParameters) {
    const TemporaryFolder folder;
    const auto container = one_file(
        folder, {.path = folder.write("l.csv", two_lines),
                 .instrument = {.name = "D", .type = "afm", .tip_radius = 1e-8, .tip_radius_standard_error = 2e-9},
                 .height_calibration = "1.01 ± 0.02"});
    EXPECT_TRUE(schema_violations(read_container(container).container).empty());
    const auto metadata = open(container, {}).at(0).info.metadata;
    EXPECT_DOUBLE_EQ(*metadata.instrument.tip_radius, 1e-8);
    EXPECT_DOUBLE_EQ(*metadata.instrument.tip_radius_standard_error, 2e-9);
    EXPECT_EQ(metadata.attributes.at("height_calibration"), "1.01 ± 0.02");
}

TEST(ContainerDraft, UnusualTextsAreConvertedToPlainColumns) {
    const TemporaryFolder folder;
    const auto container =
        one_file(folder, {.path = folder.write("scan.csv", "x [um];h [nm]\n0;1,5\n1;3\n2;2\n3;6\n")});
    const auto topography = read_container(container).container.surfaces.at(0).topographies.at(0);
    EXPECT_EQ(container_member(container, topography.datafile.original).all(), "0\t1.5\n1000\t3\n2000\t2\n3000\t6\n");
    EXPECT_EQ(topography.unit, "nm");
    EXPECT_TRUE(open(container, {}).at(0).info.alerts.empty());
}

TEST(ContainerDraft, ProcessedCopyIsTheDetrendedOriginal) {
    const TemporaryFolder folder;
    const auto path = folder.write("a.spm", nanoscope_file(4, 3, 2));
    for (const auto trend : {topography::Trend::mean, topography::Trend::tilt, topography::Trend::parabola}) {
        const auto container = one_file(folder, {.path = path, .trend = trend});
        const auto copy = open(container_member(container, "0-a-squeezed.nc"), {}).at(0);
        EXPECT_EQ(copy.info.unit, "nm");
        const auto expected = topography::detrended(std::get<HeightMap>(read(path)), trend);
        EXPECT_LT((std::get<HeightMap>(copy.read()).heights - expected.heights).abs().maxCoeff(), 1e-15 * 1e-6);
    }
    EXPECT_THROW((void)one_file(folder, {.path = path, .trend = topography::Trend::none}), InvalidArgument);
}

TEST(ContainerDraft, UndefinedPointsAreCountedAndRemainUndefined) {
    const TemporaryFolder folder;
    Array2D heights = Array2D::Random(5, 4) * 1e-6;
    heights(1, 2) = undefined;
    write_netcdf(folder.path("m.nc"), HeightMap{heights, {5e-6, 4e-6}, true, {}});
    const auto container = one_file(folder, {.path = folder.path("m.nc")});
    const auto topography = read_container(container).container.surfaces.at(0).topographies.at(0);
    EXPECT_EQ(topography.has_undefined_data, true);
    EXPECT_DOUBLE_EQ(topography.undefined_data_fraction.value(), 0.05);
    EXPECT_EQ(topography.is_periodic, true);
    const auto copy =
        std::get<HeightMap>(open(container_member(container, topography.datafile.squeezed), {}).at(0).read());
    EXPECT_TRUE((copy.heights.isNaN() == heights.isNaN()).all());
}

TEST(ContainerDraft, ReportsMissingMetadata) {
    const TemporaryFolder folder;
    write_npy(folder.path("m.npy"), Array2D(Array2D::Random(5, 4)));
    EXPECT_THROW((void)one_file(folder, {.path = folder.path("m.npy")}), InvalidArgument);
    const auto container = one_file(folder, {.path = folder.path("m.npy"),
                                             .options = {{{2e-3, 1e-3}}, "um"},
                                             .instrument = {.type = "stylus", .tip_radius = 2e-6}});
    const auto file = read_container(container);
    const auto& topography = file.container.surfaces.at(0).topographies.at(0);
    EXPECT_EQ(topography.unit, "µm");
    EXPECT_DOUBLE_EQ(topography.size.at(0), 2000.0);
    EXPECT_EQ(topography.instrument->type, "contact-based");
    EXPECT_DOUBLE_EQ(topography.instrument->parameters->tip_radius->metres().value(), 2e-6);
    const auto channel = open(container, {}).at(0);
    EXPECT_EQ(channel.info.unit, "µm");
    const auto alone = std::get<HeightMap>(read(folder.path("m.npy"), 0, {{{2e-3, 1e-3}}, "um"}));
    EXPECT_TRUE((std::get<HeightMap>(channel.read()).heights == alone.heights).all());
    EXPECT_THROW((void)one_file(folder, {.path = folder.path("m.npy"), .options = {{{2e-3, 1e-3}}, "cm"}}),
                 InvalidArgument);
}

TEST(ContainerDraft, UsesOnlyUnambiguousDates) {
    const TemporaryFolder folder;
    const std::pair<const char*, const char*> dates[] = {{"09:57:48 AM Tue Jan 12 2016", "2016-01-12"},
                                                         {"2016-02-15T10:00:00", "2016-02-15"},
                                                         {"15.02.2016", "2016-02-15"},
                                                         {"Fri Mar 04 23:01:02 2011", "2011-03-04"},
                                                         {"02/03/2016", ""},
                                                         {"yesterday", ""}};
    for (const auto& [time, expected] : dates) {
        auto bytes = nanoscope_file(4, 3, 2);
        const std::string old = "09:57:48 AM Tue Jan 12 2016";
        auto text = std::string(time);
        text.resize(old.size(), ' ');
        bytes.replace(bytes.find(old), old.size(), text);
        const auto container = one_file(folder, {.path = folder.write("a.spm", bytes)});
        EXPECT_EQ(read_container(container).container.surfaces[0].topographies[0].measurement_date, expected) << time;
    }
}

TEST(ContainerDraft, UpgradeRemovesARepeatedScale) {
    const TemporaryFolder folder;
    ContainerDraft draft;
    add_container(draft, bytes::memory_source("old.zip", container_file()));
    EXPECT_TRUE(has_code(draft.alerts, "SCALE_TWICE"));
    EXPECT_TRUE(has_code(draft.alerts, "UNREADABLE_MEMBER"));
    const auto& topographies = draft.container.surfaces.at(0).topographies;
    EXPECT_EQ(topographies.at(0).height_scale, 2.0) << "text carries no scale";
    EXPECT_EQ(topographies.at(2).height_scale, std::nullopt);
    const auto old_channels = open(bytes::memory_source("old.zip", container_file()), {});
    const auto channels = open(written(folder, draft), {});
    ASSERT_EQ(channels.size(), 3u);
    for (const std::size_t i : {0, 2}) {
        EXPECT_TRUE(
            (topography::all_heights(channels[i].read()) == topography::all_heights(old_channels[i].read())).all());
        const auto copy =
            open(container_member(bytes::file_source(folder.path("out.zip")), topographies[i].datafile.squeezed), {})
                .at(0);
        const auto levelled =
            topography::detrended(old_channels[i].read(), old_channels[i].info.recommended_trend.value());
        EXPECT_LT((topography::all_heights(copy.read()) - topography::all_heights(levelled)).abs().maxCoeff(), 1e-20);
    }
}

TEST(ContainerDraft, RenamesEqualMembersOfTwoContainers) {
    const TemporaryFolder folder;
    ContainerDraft draft;
    for (int i = 0; i < 2; ++i) add_container(draft, bytes::memory_source("old.zip", container_file()));
    const auto channels = open(written(folder, draft), {});
    ASSERT_EQ(channels.size(), 6u);
    EXPECT_EQ(draft.container.surfaces[1].topographies[0].datafile.original, "1-line.txt");
    EXPECT_TRUE((topography::all_heights(channels[3].read()) == topography::all_heights(channels[0].read())).all());
}

TEST(ContainerDraft, TakesOneMeasurementOfAContainerWithGivenMetadata) {
    const TemporaryFolder folder;
    const auto old = folder.write("old.zip", container_file());
    ContainerDraft draft;
    ContainerSurface surface{.name = "s"};
    add_measurements_of(draft, surface,
                        {.path = old,
                         .channel = "2",
                         .trend = topography::Trend::parabola,
                         .instrument = {.type = "afm", .tip_radius = 1e-8}});
    ASSERT_EQ(surface.topographies.size(), 1u);
    EXPECT_EQ(surface.topographies[0].name, "image");
    EXPECT_EQ(surface.topographies[0].detrend_mode, "curvature");
    EXPECT_DOUBLE_EQ(surface.topographies[0].instrument->parameters->tip_radius->metres().value(), 1e-8);
    EXPECT_EQ(draft.members.size(), 2u) << "the image and its copy";
    EXPECT_THROW(add_measurements_of(draft, surface, {.path = old, .channel = "3"}), InvalidArgument);
}

TEST(ContainerCheck, FindsNoProblemInAWrittenContainer) {
    const TemporaryFolder folder;
    const auto report =
        check_container(one_file(folder, {.path = folder.write("l.csv", two_lines), .trend = topography::Trend::tilt}));
    EXPECT_TRUE(report.alerts.empty()) << report.alerts.at(0).message;
    EXPECT_TRUE(report.differences.empty());
    EXPECT_EQ(report.channels.size(), 1u);
}

TEST(ContainerCheck, ReportsACopyThatDiffersFromItsOriginal) {
    const auto container = [](double factor) {
        const Array1D heights = factor * Array1D{{-2e-6, 0.0, -1e-6, 3e-6}};
        const auto copy = netcdf_content(LineScan{heights, 4e-6, false, {}}, "um");
        return bytes::memory_source(
            "c.zip",
            zip_archive(
                {{"index.json",
                  R"({"surfaces": [{"name": "s", "topographies": [{"name": "l", "unit": "um", "size": [4], "detrend_mode":
"center", "datafile": {"original": "l.txt", "squeezed-netcdf": "l.nc"}}]}]})"},
                 {"l.txt", "0 1\n1 3\n2 2\n3 6\n"},
                 {"l.nc", copy}}));
    };
    EXPECT_FALSE(has_code(check_container(container(1.0)).alerts, "COPY_DIFFERS"));
    EXPECT_TRUE(has_code(check_container(container(0.112)).alerts, "COPY_DIFFERS"));
}

TEST(ContainerCheck, NamesRepeatedScalesBadMembersAndUnknownFields) {
    const auto report = check_container(bytes::memory_source("c.zip", container_file()));
    EXPECT_TRUE(has_code(report.alerts, "SCALE_TWICE"));
    EXPECT_TRUE(has_code(report.alerts, "UNREADABLE_MEMBER"));
    EXPECT_TRUE(report.differences.empty());
    const auto newest =
        check_container(bytes::memory_source("c.zip", zip_archive({{"index.json", json_index_text()}})));
    EXPECT_TRUE(has_code(newest.alerts, "UNKNOWN_FIELD"));
    EXPECT_TRUE(newest.differences.empty()) << newest.differences.at(0);
}

TEST(ContainerDraft, OmitsACopyThatRequiresFilling) {
    const TemporaryFolder folder;
    const auto container = bytes::memory_source(
        "c.zip", zip_archive({{"index.json", R"({"surfaces": [{"name": "s", "topographies": [{"name": "l", "unit": "um",
"size": [4], "fill_undefined_data_mode": "harmonic", "datafile": {"original": "l.txt"}}]}]})"},
                              {"l.txt", "0 1\n1 3\n2 2\n3 6\n"}}));
    ContainerDraft draft;
    add_container(draft, container);
    EXPECT_TRUE(has_code(draft.alerts, "NO_PROCESSED_COPY"));
    EXPECT_TRUE(
        read_container(written(folder, draft)).container.surfaces.at(0).topographies.at(0).datafile.squeezed.empty());
}

}  // namespace
}  // namespace setae::formats::tests::container_draft_test
