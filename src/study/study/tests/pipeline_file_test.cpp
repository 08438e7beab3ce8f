// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/pipeline_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "setae/core/errors.hpp"
#include "setae/processing/step_text.hpp"

namespace setae::study::pipeline_file_test {
namespace {

namespace fs = std::filesystem;
using processing::Pipeline;

class PipelineFile : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() /
                 ("setae_pipeline_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name) << text;
        return (folder / name).string();
    }
    /// The error of reading, without the folder.
    [[nodiscard]] std::string complaint(const std::string& name, const std::string& text) const {
        try {
            (void)read_pipeline(write(name, text));
        } catch (const Error& error) {
            const std::string message = error.what();
            return message.substr(std::min(message.size(), folder.string().size() + 1));
        }
        return "accepted";
    }
    fs::path folder;
};

void expect_same(const Pipeline& one, const Pipeline& other) {
    ASSERT_EQ(one.entries.size(), other.entries.size());
    for (std::size_t k = 0; k < one.entries.size(); ++k) {
        EXPECT_EQ(one.entries[k].on, other.entries[k].on);
        EXPECT_EQ(one.entries[k].step.index(), other.entries[k].step.index());
        EXPECT_EQ(processing::parameters(one.entries[k].step), processing::parameters(other.entries[k].step));
    }
}

/// Every step there is, then some with parameters of every kind.
Pipeline everything() {
    Pipeline pipeline;
    for (const auto& description : processing::step_descriptions())
        pipeline.entries.push_back({processing::step_named(description.name), pipeline.entries.size() % 2 == 0});
    for (
        const char* line :
        {"align_rows method=polynomial degree=3 direction=y region=\"include rectangle 1 um to 2 um; exclude heights above 20 nm grow 2\"",
         "despike threshold=5.25 replace_by=undefined", "crop x_from=\"1.25 um\" cut_last=3"})
        pipeline.entries.push_back({processing::step_from_text(line)});
    return pipeline;
}

TEST_F(PipelineFile, IsUnchangedAfterWritingAndReadingInEitherFormat) {
    for (const std::string name : {"p.yml", "p.yaml", "p.toml"}) {
        const auto path = (folder / name).string();
        write_pipeline(path, everything());
        expect_same(read_pipeline(path), everything());
        write_pipeline(path, {});
        EXPECT_TRUE(read_pipeline(path).entries.empty());
    }
}

TEST_F(PipelineFile, SupportsUnitsSwitchesListsAndSingleLines) {
    const auto yaml = read_pipeline(write(
        "p.yml",
        "# levels\nsteps:\n  - despike threshold=5\n  - step: crop\n    x_to: 8 um\n    enabled: false\n  - step: level_plane\n    region:\n"
        "      - exclude heights above 20 nm\n      - exclude rectangle 1 um to 2 um\n  - level_mean\n"));
    const auto toml = read_pipeline(write(
        "p.toml",
        "steps = [\"despike threshold=5\", {step = \"crop\", x_to = \"8 um\", enabled = false}, {step = \"level_plane\", region = [\"exclude heights above 20 nm\", "
        "\"exclude rectangle 1 um to 2 um\"]}, \"level_mean\"]\n"));
    expect_same(yaml, toml);
    ASSERT_EQ(yaml.entries.size(), 4u);
    EXPECT_EQ(std::get<processing::Crop>(yaml.entries[1].step).x_to, 8e-6);
    EXPECT_FALSE(yaml.entries[1].on);
    EXPECT_EQ(std::get<processing::LevelPlane>(yaml.entries[2].step).region.exclude.size(), 2u);
}

TEST_F(PipelineFile, NamesTheLineOfAnError) {
    EXPECT_EQ(complaint("p.yml", "steps:\n  - step: level_plane\n  - step: dispike\n    threshold: 5\n"),
              "p.yml:3: unknown step 'dispike'; did you mean 'despike'?; setae level --explain lists them");
    EXPECT_EQ(
        complaint("p.yml", "steps:\n  - step: despike\n    treshold: 5\n"),
        "p.yml:3: unknown parameter 'treshold' of despike; did you mean 'threshold'?; expected one of threshold, reach, replace_by");
    EXPECT_EQ(complaint("p.yml", "steps:\n  - step: despike\n    threshold: many\n"),
              "p.yml:3: threshold: 'many' is not a number");
    EXPECT_EQ(complaint("p.yml", "steps:\n  - step: despike\n    enabled: maybe\n"),
              "p.yml:3: enabled: 'maybe'; expected true or false");
    EXPECT_EQ(complaint("p.yml", "steps:\n  - step: despike\n    reach: 3\n    reach: 4\n"),
              "p.yml:4: key 'reach' is given twice in a step");
    EXPECT_EQ(complaint("p.yml", "steps:\n  - threshold: 5\n"),
              "p.yml:2: a step without a name; expected a key 'step', such as step: level_plane");
    EXPECT_EQ(complaint("p.yml", "step:\n  - level_plane\n"), "p.yml:1: unknown key 'step'; did you mean 'steps'?");
    EXPECT_EQ(complaint("p.yml", "- level_plane\n"), "p.yml:1: expected a key 'steps' with a list of steps");
    EXPECT_EQ(complaint("p.yml", "steps: level_plane\n"),
              "p.yml:1: steps: expected a list, with a dash before each step");
    EXPECT_NE(complaint("p.yml", "steps:\n  - step: crop\n    x_to: 8\n").find("p.yml:3: x_to: "), std::string::npos);
    EXPECT_NE(complaint("p.yml", "steps: [\n").find("YAML: "), std::string::npos);
    EXPECT_NE(complaint("p.yml", "steps:\n  - step: crop\n    x_to: {a: 1}\n").find("p.yml:3: x_to: expected a value"),
              std::string::npos);
    EXPECT_EQ(complaint("p.toml", "[[steps]]\nstep = \"despike\"\n\n[[steps]]\nstep = \"levelplane\"\n"),
              "p.toml:5: unknown step 'levelplane'; did you mean 'level_plane'?; setae level --explain lists them");
    EXPECT_EQ(
        complaint("p.toml", "[[steps]]\nstep = \"despike\"\nthresold = 5\n"),
        "p.toml:3: unknown parameter 'thresold' of despike; did you mean 'threshold'?; expected one of threshold, reach, replace_by");
    EXPECT_EQ(complaint("p.toml", "[[step]]\nstep = \"despike\"\n"),
              "p.toml:1: unknown key 'step'; did you mean 'steps'?");
    EXPECT_NE(complaint("p.toml", "[[steps]\n").find("p.toml:1: TOML: "), std::string::npos);
    std::ofstream(folder / "p.json") << "{}";
    EXPECT_THROW((void)read_pipeline((folder / "p.json").string()), InvalidArgument);
    EXPECT_THROW((void)read_pipeline((folder / "none.yml").string()), FileError);
}

TEST_F(PipelineFile, NamesFilesRelativeToItsFolder) {
    fs::create_directories(folder / "sub");
    const auto path = write("sub/p.yml", "steps:\n  - step: subtract_map\n    file: ../reference.nc\n");
    const auto pipeline = read_pipeline(path);
    EXPECT_EQ(std::get<processing::SubtractMap>(pipeline.entries[0].step).file, (folder / "reference.nc").string());
    EXPECT_EQ(files_of_steps(step_lines(pipeline)), std::vector<std::string>{(folder / "reference.nc").string()});
    // relative to the working folder it is written relative to the pipeline's
    const auto before = fs::current_path();
    fs::current_path(folder);
    write_pipeline("sub/q.toml", {{{processing::SubtractMap{.file = "reference.nc"}}}});
    const auto read = read_pipeline("sub/q.toml");
    fs::current_path(before);
    EXPECT_EQ(std::get<processing::SubtractMap>(read.entries[0].step).file, "reference.nc");
}

TEST_F(PipelineFile, LargerThanOneMegabyteIsRefused) {
    EXPECT_NE(complaint("p.yml", std::string((1 << 20) + 1, '#')).find("are too many for a pipeline"),
              std::string::npos);
}

TEST_F(PipelineFile, ResolvesAliasesAndRefusesUnknownKeys) {
    std::string bomb = "a: &a [x, x]\n";
    EXPECT_NE(complaint("p.yml", bomb + "steps: []\n").find("unknown key 'a'"), std::string::npos);
    expect_same(read_pipeline(write("p.yml", "steps:\n  - &level level_plane\n  - *level\n")),
                {{{processing::LevelPlane{}}, {processing::LevelPlane{}}}});
}

}  // namespace
}  // namespace setae::study::pipeline_file_test
