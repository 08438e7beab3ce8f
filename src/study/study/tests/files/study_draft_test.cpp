// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/study_draft.hpp"

#include <filesystem>
#include <regex>

#include <gtest/gtest.h>

#include "reference_data.hpp"
#include "sample_files.hpp"
#include "setae/core/errors.hpp"
#include "setae/study/instrument_words.hpp"
#include "setae/study/study_gaps.hpp"

namespace setae::study::study_draft_test {
namespace {

namespace fs = std::filesystem;
using setae::tests::TemporaryFolder;

constexpr const char* line_scan = "x [um],h [nm]\n0,1\n1,2\n2,1\n3,2\n";
constexpr const char* loop = "force [mN],displacement [um]\n0,0\n1,1\n2,2\n1,1\n";

class StudyDrafts : public testing::Test {
protected:
    void write(const std::string& name, std::string_view content) const {
        fs::create_directories(fs::path(folder_.path(name)).parent_path());
        (void)folder_.write(name, content);
    }
    [[nodiscard]] std::string root() const { return fs::path(folder_.path("x")).parent_path().string(); }
    [[nodiscard]] StudyDraft draft() const { return draft_study({root()}, folder_.path("study.toml")); }
    /// The draft as a study, and its text with "# " taken from lines that answer.
    [[nodiscard]] Study read(const std::string& text) const { return read_study(folder_.write("study.toml", text)); }

    TemporaryFolder folder_;
};

TEST_F(StudyDrafts, GroupFilesIntoSurfacesByFolder) {
    write("A/afm_1.csv", line_scan);
    write("A/stylus/b.csv", line_scan);
    write("B/deep/c.csv", line_scan);
    const auto made = draft();
    EXPECT_EQ(made.surfaces, 2u);
    EXPECT_EQ(made.measurements, 3u);
    const auto study = read(made.text);
    ASSERT_EQ(study.surfaces.size(), 2u);
    EXPECT_EQ(study.surfaces[0].name, "A");
    EXPECT_EQ(study.surfaces[1].name, "B/deep");
    ASSERT_EQ(study.surfaces[0].measurements.size(), 2u);
    EXPECT_EQ(study.surfaces[0].measurements[0].instrument, "afm");
    EXPECT_EQ(study.surfaces[0].measurements[1].instrument, "stylus");
    EXPECT_EQ(study.surfaces[1].measurements[0].instrument, "");
    EXPECT_TRUE(fs::equivalent(study.surfaces[0].measurements[1].file, folder_.path("A/stylus/b.csv")));
}

TEST_F(StudyDrafts, MarkMissingMetadataWithAQuestionMark) {
    write("A/afm_1.csv", line_scan);
    write("A/plain.txt", "1 2 3 4\n2 3 4 5\n3 4 5 6\n5 6 7 8\n");
    const auto text = draft().text;
    EXPECT_TRUE(std::regex_search(
        text,
        std::regex(R"(\n# tip_radius = "\?" +# such as "10 ± 3 nm"; without it waves are used down to 2.00 µm\n)")))
        << text;
    EXPECT_NE(text.find("\n# instrument = \"?\""), std::string::npos);
    EXPECT_NE(text.find("\n# unit = \"?\""), std::string::npos);
    EXPECT_NE(text.find("\n# size = [\"?\", \"?\"]"), std::string::npos);
}

TEST_F(StudyDrafts, DeriveSurfaceAndElastomerOfLoopsFromNames) {
    write("rough/afm_1.csv", line_scan);
    write("loops/rough_soft.csv", loop);
    write("loops/reference_soft_before.csv", loop);
    const auto made = draft();
    EXPECT_EQ(made.loops, 2u);
    EXPECT_TRUE(read(made.text).experiments.empty());
    // the lines below the heading count once they are no comment and answered
    auto text = std::regex_replace(
        made.text, std::regex("(^|\n)# (\\[|youngs|poisson|surface|sphere|file|role|stage|elastomer)"), "$1$2");
    text = std::regex_replace(text, std::regex("(^|\n)# (\\[|youngs|poisson|surface|sphere|file|role|stage|elastomer)"),
                              "$1$2");
    text = std::regex_replace(text, std::regex("youngs_modulus = \"\\?\""), "youngs_modulus = \"1 GPa\"");
    text = std::regex_replace(text, std::regex("poisson_ratio = \"\\?\""), "poisson_ratio = \"0.06\"");
    text = std::regex_replace(text, std::regex("surface_energy = \"\\?\""), "surface_energy = \"25 ± 1 mJ/m2\"");
    text = std::regex_replace(text, std::regex("sphere_radius = \"\\?\""), "sphere_radius = \"1 mm\"");
    const auto study = read(text);
    ASSERT_EQ(study.experiments.size(), 2u) << text;
    EXPECT_TRUE(study.experiments[0].reference);
    EXPECT_EQ(study.experiments[0].stage, "before");
    EXPECT_EQ(study.experiments[0].elastomer, "soft");
    EXPECT_EQ(study.experiments[1].surface, "rough");
    EXPECT_EQ(study.experiments[1].elastomer, "soft");
}

TEST_F(StudyDrafts, UseASpectrumTableAsSurfaceOrAlternative) {
    write("measured/afm_1.csv", line_scan);
    write("measured/psd.csv", "q [1/um],C1D [nm3]\n1,2\n2,1\n");
    write("given/psd.csv", "q [1/um],C1D [nm3]\n1,2\n2,1\n");
    const auto study = read(draft().text);
    ASSERT_EQ(study.surfaces.size(), 2u);
    EXPECT_EQ(study.surfaces[0].name, "given");
    EXPECT_TRUE(study.surfaces[0].power_spectrum.has_value());
    EXPECT_EQ(study.surfaces[1].measurements.size(), 1u);
}

TEST_F(StudyDrafts, NameFilesRelativeToTheStudy) {
    write("A/afm_1.csv", line_scan);
    EXPECT_NE(draft().text.find("file = \"A/afm_1.csv\""), std::string::npos);
    const auto elsewhere = draft_study({root()}, "a_study_that_is_not_there.toml").text;
    EXPECT_EQ(elsewhere.find("file = \"/"), std::string::npos) << elsewhere;
    EXPECT_NE(elsewhere.find("/A/afm_1.csv\""), std::string::npos);
}

TEST_F(StudyDrafts, ExplainHowToTraceMicrographs) {
    std::string header("BM\x46\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x02\0\0\0\x02\0\0\0\x01\0\x18\0\0\0\0\0\x10\0\0\0",
                       38);
    header.resize(54, '\0');
    write("A/tem/picture.bmp", header + std::string("\0\0\0\xff\xff\xff\0\0\xff\xff\xff\0\0\0\0\0", 16));
    const auto made = draft();
    EXPECT_EQ(made.micrographs, 1u);
    EXPECT_NE(made.text.find("\n#   setae contour A/tem/picture.bmp -o A/tem/picture.csv --pixel \"?\"\n"),
              std::string::npos)
        << made.text;
    EXPECT_TRUE(read(made.text).surfaces.empty());
}

TEST_F(StudyDrafts, OmitResultsAndUnknownFiles) {
    write("A/afm_1.csv", line_scan);
    write("A/notes.md", "# notes\n");
    write("old_results/study.json", "{}");
    write("old_results/report.html", "<html>");
    write("old_results/psd_A.csv", "q [1/m],C1D [m3]\n1,2\n2,1\n");
    const auto made = draft();
    EXPECT_EQ(made.surfaces, 1u);
    ASSERT_EQ(made.left_out.size(), 1u);
    EXPECT_NE(made.left_out[0].path.find("notes.md"), std::string::npos);
    EXPECT_NE(made.text.find("# Left out:\n# "), std::string::npos);
}

TEST_F(StudyDrafts, SupportNamesOfAnyCharacters) {
    write("a \"b\" #c/afm 1.csv", line_scan);
    write("odd\nname/afm.csv", line_scan);
    const auto study = read(draft().text);
    ASSERT_EQ(study.surfaces.size(), 2u);
    EXPECT_EQ(study.surfaces[0].name, "a \"b\" #c");
    EXPECT_EQ(study.surfaces[1].name, "odd\nname");
    write("A/latin\xff.csv", line_scan);
    const auto made = draft();
    ASSERT_EQ(made.left_out.size(), 1u);
    EXPECT_NE(made.left_out[0].reason.find("its name is no UTF-8"), std::string::npos);
    EXPECT_EQ(read(made.text).surfaces.size(), 2u);
}

TEST_F(StudyDrafts, AreReproducible) {
    write("B/afm_1.csv", line_scan);
    write("A/afm_1.csv", line_scan);
    const auto first = draft().text;
    (void)read(first);
    EXPECT_EQ(draft().text, first);
}

TEST(InstrumentWords, AreTakenFromNames) {
    EXPECT_EQ(instrument_in_name("rougher_AFM12.spm"), "afm");
    EXPECT_EQ(instrument_in_name("uncd_stylus_300um.txt"), "stylus");
    EXPECT_EQ(instrument_in_name("confocal"), "optical");
    EXPECT_EQ(instrument_in_name("system.txt"), "");
}

class StudyGaps : public StudyDrafts {
protected:
    [[nodiscard]] std::vector<std::string> gaps(const std::string& text) const {
        std::vector<std::string> lines;
        for (const auto& gap : study_gaps(read(text)))
            lines.push_back(std::to_string(gap.line) + " " + gap.item + ": " + gap.message);
        return lines;
    }
};

TEST_F(StudyGaps, NameTheLineWithTheQuestionMark) {
    write("afm.csv", line_scan);
    EXPECT_EQ(
        gaps(
            "[[surfaces.A.measurements]]\nfile = \"afm.csv\"\ninstrument = \"afm\"\n# tip_radius = \"?\"  # such as\n"),
        std::vector<std::string>{"4 afm.csv: no tip_radius of the afm: waves are used down to 2.00 µm"});
    EXPECT_EQ(gaps("[[surfaces.A.measurements]]\nfile = \"afm.csv\"\ninstrument = \"afm\"\ntip_radius = \"10 nm\"\n"),
              std::vector<std::string>{});
    EXPECT_EQ(
        gaps(
            "[surfaces.A]\nmeasurements = [\n  { file = \"afm.csv\", instrument = \"tem\" },\n  { file = \"afm.csv\" },\n]\n"),
        std::vector<std::string>{"4 afm.csv: no instrument: waves are used down to 2.00 µm"});
}

TEST_F(StudyGaps, ReportUnreadableFiles) {
    write("plain.txt", "1 2 3 4\n2 3 4 5\n3 4 5 6\n5 6 7 8\n");
    const auto lines = gaps(
        "[surfaces.A]\nmeasurements = [\n  { file = \"plain.txt\", instrument = \"tem\" },\n  { file = \"none.csv\" },\n]\n"
        "[surfaces.B]\npower_spectrum = \"plain.txt\"\n");
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_EQ(lines[0], "3 plain.txt: no unit of heights, without which the file cannot be read");
    EXPECT_EQ(lines[1], "3 plain.txt: no size, without which the file cannot be read");
    EXPECT_TRUE(lines[2].starts_with("4 none.csv: no such file")) << lines[2];
    EXPECT_TRUE(lines[3].starts_with("7 plain.txt: 4 columns without units")) << lines[3];
}

TEST_F(StudyGaps, ReportMissingInputOfExperiments) {
    write("afm.csv", line_scan);
    write("loop.csv", loop);
    const std::string start =
        "[rough_solid]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.1\n[surfaces.A]\nmeasurements = [{ file = \"afm.csv\", instrument = \"tem\" }]\n";
    const auto lines =
        gaps(start +
             "[elastomers.soft]\nsurface_energy = \"25 mJ/m2\"\n[elastomers.hard]\nsurface_energy = \"25 mJ/m2\"\n"
             "[[experiments]]\nfile = \"loop.csv\"\nsurface = \"A\"\nelastomer = \"soft\"\n");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(
        lines[0],
        "8 elastomer hard: no modulus: neither youngs_modulus nor a loop is given, so that nothing can be predicted for this elastomer");
    EXPECT_EQ(
        lines[1],
        "11 loop.csv: no sphere_radius, neither for the experiment nor for elastomer 'soft': the loop cannot be fitted");
}

TEST_F(StudyGaps, ReportQuestionMarksInCommentedTables) {
    write("afm.csv", line_scan);
    EXPECT_EQ(
        gaps(
            "[[surfaces.A.measurements]]\nfile = \"afm.csv\"\ninstrument = \"tem\"\n# tip_radius = \"?\"\n\n"
            "# [elastomers.soft]\n# surface_energy = \"?\"   # such as \"25 mJ/m2\"\n# sphere_radius = \"1 mm\"  # or \"?\"\n"),
        std::vector<std::string>{"7 [elastomers.soft]: no surface_energy yet; the line is a comment"});
}

TEST(StudyDraft, OfRealContainersHasOneEntryPerMember) {
    SETAE_REQUIRE_REFERENCE_DATA(data, "topography/surfacetopography/container-2.zip");
    const TemporaryFolder folder;
    const auto file = folder.path("study.toml");
    const auto study = read_study(folder.write("study.toml", draft_study({data.string()}, file).text));
    ASSERT_EQ(study.surfaces.size(), 1u);
    ASSERT_EQ(study.surfaces[0].measurements.size(), 3u);
    EXPECT_EQ(study.surfaces[0].measurements[1].instrument, "afm");
    EXPECT_EQ(study.surfaces[0].measurements[2].instrument, "stylus");
    EXPECT_EQ(study.surfaces[0].measurements[2].channel, "2");
}

TEST_F(StudyDrafts, WriteTheMappingThatReadsALoop) {
    write("data/curve.txt", "Piezo [um]\tMEMS displ.[nm]\tTime [ms]\n0,1\t1,5\t0\n0,2\t2,5\t1\n0,3\t3,5\t2\n");
    write(
        "mappings/rig.toml",
        "[columns.p]\nheader = \"Piezo\"\n[columns.m]\nheader = \"MEMS displ.\"\n[constants]\nk = \"3 N/m\"\n[table]\nforce = \"k * "
        "m\"\ndisplacement = \"p - m\"\n");
    const auto data = folder_.path("data");
    EXPECT_NE(draft_study({data}, folder_.path("study.toml"), folder_.path("mappings")).text.find("mapping = \"rig\""),
              std::string::npos);
    EXPECT_NE(draft_study({data}, folder_.path("study.toml")).text.find("mapping = \"?\""), std::string::npos);
}

}  // namespace
}  // namespace setae::study::study_draft_test
