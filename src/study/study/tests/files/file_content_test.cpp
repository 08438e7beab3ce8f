// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/file_content.hpp"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "error_message.hpp"
#include "reference_data.hpp"
#include "sample_files.hpp"

namespace setae::study::file_content_test {
namespace {

namespace fs = std::filesystem;
using setae::tests::message_of;
using setae::tests::TemporaryFolder;

constexpr const char* line_scan = "x [um],h [nm]\n0,1\n1,2\n2,1\n3,2\n";
constexpr const char* loop = "force [mN],displacement [um]\n0,0\n1,1\n2,2\n1,1\n";

TEST(FileContent, RecognisesFilesByContent) {
    const TemporaryFolder folder;
    const auto kind = [&](const char* file, const char* text) { return file_content(folder.write(file, text)).kind; };
    EXPECT_EQ(kind("line.csv", line_scan), FileKind::topography);
    EXPECT_EQ(kind("map.txt", "1 2 3 4\n2 3 4 5\n3 4 5 6\n5 6 7 8\n"), FileKind::topography);
    EXPECT_EQ(kind("loop.csv", loop), FileKind::loop);
    EXPECT_EQ(kind("own.csv",
                   "# format: setae loop\n# version: 1\n# sphere_radius: 1 mm\nforce [N],displacement [m]\n0,0\n1,1\n"),
              FileKind::loop);
    EXPECT_EQ(kind("camera.txt", "time [s],load [mN],contact radius [um]\n0,0,0\n1,1,2\n2,2,3\n"), FileKind::loop);
    EXPECT_EQ(kind("spectrum.csv", "q [1/um],C1D [nm3]\n1,2\n2,1\n"), FileKind::spectrum);
    EXPECT_EQ(kind("study.toml", "title = \"t\"\n[surfaces.A]\nmeasurements = [{ file = \"a.txt\" }]\n"),
              FileKind::study);
    EXPECT_EQ(kind("recipe.toml", "seed = 7\n[protocols.short]\n[surfaces.A]\n"), FileKind::recipe);
    EXPECT_EQ(kind("map.toml",
                   "[columns.load]\nposition = 1\nunit = \"mN\"\n[columns.way]\nposition = 2\nunit = \"um\"\n"
                   "[table]\nforce = \"load\"\ndisplacement = \"way\"\n"),
              FileKind::mapping);
    EXPECT_EQ(kind("steps.toml", "[[steps]]\nstep = \"level_plane\"\n"), FileKind::pipeline);
    EXPECT_EQ(kind("steps.yml", "steps:\n  - step: level_plane\n"), FileKind::pipeline);
}

TEST(FileContent, LoopListsMissingInputOfAFit) {
    const TemporaryFolder folder;
    const auto plain = file_content(folder.write("loop.csv", loop));
    EXPECT_EQ(plain.missing, std::vector<std::string>{"sphere_radius"});
    EXPECT_EQ(plain.table->rows(), 4);
    EXPECT_DOUBLE_EQ(plain.table->at("force")[2], 2e-3);
    const auto own = file_content(folder.write(
        "own.csv",
        "# format: setae loop\n# version: 1\n# sphere_radius: 1 mm\nforce [N],displacement [m]\n0,0\n1,1\n"));
    EXPECT_TRUE(own.missing.empty());
}

TEST(FileContent, RecordWithoutForceIsALoopThatRequiresAMapping) {
    const TemporaryFolder folder;
    const auto content = file_content(folder.write(
        "record.txt", "Piezo position [nm]\tMEMS displacement [nm]\tTime [ms]\n1\t0\t1\n2\t0\t2\n3\t1\t3\n4\t1\t4\n"));
    EXPECT_EQ(content.kind, FileKind::loop);
    EXPECT_EQ(content.missing, std::vector<std::string>{"columns"});
    EXPECT_NE(content.note.find("force"), std::string::npos);
}

TEST(FileContent, ThreeColumnsWithoutHeaderAreACurveByDefault) {
    const TemporaryFolder folder;
    const auto file = folder.write("curve.txt", "1 0.1 0.2\n2 0.1 0.2\n3 0.2 0.3\n4 0.5 0.6\n5 0.9 0.9\n6 1.2 1.1\n");
    const auto curve = file_content(file);
    EXPECT_EQ(curve.kind, FileKind::force_curve);
    EXPECT_EQ(curve.format, "nt-mdt");
    EXPECT_EQ(curve.channels.size(), 1u) << "for those who take it for a map";
    EXPECT_EQ(file_content(file, {.heights = {.size = {}, .unit = "um"}}).kind, FileKind::topography);
}

TEST(FileContent, SpectrumStatesTheMeaningOfItsFirstColumn) {
    const TemporaryFolder folder;
    const auto content = file_content(folder.write("f.csv", "frequency [1/um],C_iso [nm4]\n1,2\n2,1\n"));
    EXPECT_EQ(content.table->metadata.at("quantity"), "frequency");
    EXPECT_EQ(content.table->metadata.at("units_of_file"), "1/um, nm4");
    EXPECT_NE(content.note.find("q = 2π f"), std::string::npos);
    const auto bare = folder.write("bare.txt", "1 2\n2 1\n4 0.5\n");
    const auto asked = file_content(
        bare, {.heights = {}, .is_spectrum = true, .spectrum = tables::SpectrumUnits::from_text("wavelength um, nm3")});
    EXPECT_EQ(asked.kind, FileKind::spectrum);
    EXPECT_EQ(asked.table->metadata.at("quantity"), "wavelength");
    EXPECT_EQ(file_content(bare).kind, FileKind::topography);
}

TEST(FileContent, UnknownContentIsRefusedWithTheReason) {
    const TemporaryFolder folder;
    EXPECT_NE(message_of([&] {
                  (void)file_content(folder.write("notes.md", "# Notes\nnone\n"));
              }).find("text without a row of numbers"),
              std::string::npos);
    EXPECT_NE(
        message_of([&] { (void)file_content(folder.write("other.toml", "a = 1\n")); }).find("TOML without a known key"),
        std::string::npos);
    EXPECT_NE(message_of([&] {
                  (void)file_content(folder.write("study.toml", "[surfaces.A]\nmeasurments = []\n"));
              }).find("measurements"),
              std::string::npos);
    EXPECT_NE(message_of([&] { (void)file_content(folder.path("none.csv")); }).find("none.csv"), std::string::npos);
}

TEST(FileContent, EveryKindHasANameAndACommand) {
    for (int kind = 0; kind <= static_cast<int>(FileKind::pipeline); ++kind) {
        EXPECT_FALSE(name(static_cast<FileKind>(kind)).empty());
        EXPECT_TRUE(commands_for(static_cast<FileKind>(kind)).front().starts_with("setae "));
    }
}

TEST(FileContent, RecognisesRealFiles) {
    SETAE_REQUIRE_REFERENCE_DATA(data, "");
    const auto kind = [&, data = data](const char* file) { return file_content((data / file).string()).kind; };
    EXPECT_EQ(kind("topography/surfacetopography/di-1.di"), FileKind::topography);
    EXPECT_EQ(kind("topography/surfacetopography/container-2.zip"), FileKind::container);
    EXPECT_EQ(kind("topography/surfacetopography/example_ps.tiff"), FileKind::topography);
    EXPECT_EQ(kind("tem/olympus_SIS.tif"), FileKind::micrograph);
    EXPECT_EQ(kind("tem/test-7.dm4"), FileKind::micrograph);
    EXPECT_EQ(kind("force_curves/fmt-jpk-fd_spot3-0192.jpk-force"), FileKind::force_curve);
    EXPECT_EQ(kind("force_curves/fmt-afm-workshop-fd_single_2020-02-14_13.41.25.csv"), FileKind::force_curve);
    EXPECT_EQ(kind("jkr/pdms_a.txt"), FileKind::loop);
}

TEST(FoundFiles, OfFoldersAreOrderedWithoutHiddenAndLinkedOnes) {
    const TemporaryFolder folder, elsewhere;
    (void)elsewhere.write("far.txt", "1");
    for (const char* name : {"b.txt", "a.txt", ".hidden"}) (void)folder.write(name, "1");
    fs::create_directories(folder.path("inner/deeper"));
    fs::create_directories(folder.path(".git"));
    (void)folder.write("inner/c.txt", "1");
    (void)folder.write("inner/deeper/d.txt", "1");
    (void)folder.write(".git/config", "1");
    fs::create_directory_symlink(fs::path(elsewhere.path("far.txt")).parent_path(), folder.path("linked"));
    fs::create_symlink(elsewhere.path("far.txt"), folder.path("z.txt"));
    const auto root = fs::path(folder.path("a.txt")).parent_path().string();
    const auto found = found_files({root, "single.csv"});
    EXPECT_EQ(found.files,
              (std::vector<std::string>{folder.path("a.txt"), folder.path("b.txt"), folder.path("z.txt"),
                                        folder.path("inner/c.txt"), folder.path("inner/deeper/d.txt"), "single.csv"}));
    EXPECT_TRUE(found.unreadable.empty());
}

TEST(FoundFiles, ReportFoldersWithoutFiles) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path("empty"));
    (void)folder.write("empty/.hidden", "1");
    const auto found = found_files({folder.path("empty")});
    EXPECT_TRUE(found.files.empty());
    ASSERT_EQ(found.unreadable.size(), 1u);
    EXPECT_NE(found.unreadable[0].reason.find("the folder contains no files"), std::string::npos);
}

}  // namespace
}  // namespace setae::study::file_content_test
