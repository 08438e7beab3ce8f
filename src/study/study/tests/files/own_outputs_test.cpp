// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/own_outputs.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "sample_files.hpp"
#include "setae/bytes/png_mark.hpp"
#include "setae/study/file_content.hpp"

namespace setae::study::own_outputs_test {
namespace {

namespace fs = std::filesystem;
using setae::tests::TemporaryFolder;

class OwnOutputs : public testing::Test {
protected:
    std::string write(const std::string& name, std::string_view content) const {
        fs::create_directories(fs::path(folder_.path(name)).parent_path());
        return folder_.write(name, content);
    }
    TemporaryFolder folder_;
};

TEST_F(OwnOutputs, AreRecognisedByTheirContent) {
    const std::string png = std::string("\x89PNG\r\n\x1a\n", 8) + std::string(40, 'x');
    EXPECT_FALSE(is_own_output(write("a.png", png)));
    EXPECT_TRUE(is_own_output(write("b.png", bytes::with_png_mark(png))));
    EXPECT_TRUE(
        is_own_output(write("fits.csv", "file,surface,elastomer,lens,spot,contact,cycle,branch\na,,,,,1,1,x\n")));
    EXPECT_TRUE(is_own_output(write("f.csv", "# title: t\n# figure: 1\n# written by: setae 1\nx\n1\n")));
    EXPECT_TRUE(is_own_output(write("report.html", "<head><meta name=\"generator\" content=\"setae 1\">")));
    EXPECT_TRUE(is_own_output(write("p.json", "[\n  {\n    \"quantity\": \"rms_height\",\n    \"symbol\": \"Rq\"}]")));
    EXPECT_FALSE(is_own_output(write("q.json", "{\"quantity\": 1}")));
    EXPECT_FALSE(is_own_output(write("x.csv", "x [um],h [nm]\n0,1\n1,2\n")));
    EXPECT_FALSE(
        is_own_output(write("loop.csv", "# format: setae loop\n# version: 1\nforce [N],displacement [m]\n1,2\n")));
    EXPECT_FALSE(is_own_output(folder_.path("none.csv")));
}

TEST_F(OwnOutputs, AreIgnoredInFoldersAndUsedWhenNamed) {
    write("data/scan.csv", "x [um],h [nm]\n0,1\n1,2\n");
    const auto fits = write("data/fits.csv", "file,surface,elastomer,lens,spot,contact,cycle,branch\na,,,,,1,1,x\n");
    write("data/results/files.txt",
          std::string(result_list_heading) + "# study: ../study.toml\nfigures/a.csv\nnew.csv\n");
    write("data/results/figures/a.csv", "x,y\n1,2\n");
    write("data/results/new.csv", "x,y\n1,2\n");
    write("data/results/mine.csv", "x [um],h [nm]\n0,1\n1,2\n");
    write("data/old/study.json", "{}");
    write("data/old/report.html", "<html>");
    write("data/old/pairs.csv", "a,b\n1,2\n");
    const auto found = found_files({folder_.path("data")});
    ASSERT_EQ(found.files.size(), 2u);
    EXPECT_EQ(fs::path(found.files[0]).filename(), "scan.csv");
    EXPECT_EQ(fs::path(found.files[1]).filename(), "mine.csv");
    EXPECT_EQ(found.own.size(), 7u);
    EXPECT_EQ(found_files({fits}).files, std::vector<std::string>{fits});
    const auto results = found_files({folder_.path("data/old")});
    ASSERT_EQ(results.unreadable.size(), 1u);
    EXPECT_NE(results.unreadable[0].reason.find("only files that setae wrote"), std::string::npos);
}

}  // namespace
}  // namespace setae::study::own_outputs_test
