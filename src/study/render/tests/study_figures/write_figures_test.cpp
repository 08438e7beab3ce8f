// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study_figures/write_figures.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

#include "setae/core/errors.hpp"
#include "small_studies.hpp"

namespace setae::study_figures::write_figures_test {
namespace {

struct Folder {
    std::filesystem::path path =
        std::filesystem::path(testing::TempDir()) /
        ("setae_gallery_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    Folder() {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::string operator/(const char* name) const { return (path / name).string(); }
};

std::map<std::string, std::string> files_in(const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ifstream file(entry.path(), std::ios::binary);
        files[entry.path().filename().string()] = {std::istreambuf_iterator<char>(file), {}};
    }
    return files;
}

bool there_is_gnuplot() { return !figures::drawing_program().empty(); }

std::vector<StudyFigure> two_figures() {
    return {study_figure(study_of_pairs(), "1"), study_figure(study_of_pairs(), "4")};
}

TEST(WriteFigures, GivesTheSameBytesForAnyNumberOfThreadsAndFromTheStore) {
    if (!there_is_gnuplot()) GTEST_SKIP() << "no gnuplot";
    const Folder folder;
    const cache::Store store(folder / "store", "1");
    const std::vector<StudyFigure> figures{two_figures()[0]};
    const auto one = write_figures(figures, {.folder = folder / "one", .study = "a.toml", .threads = {1}});
    (void)write_figures(figures, {.folder = folder / "two", .study = "a.toml", .threads = {2}, .store = &store});
    EXPECT_EQ(store.traffic().kept, 3u);
    (void)write_figures(figures, {.folder = folder / "warm", .study = "a.toml", .threads = {2}, .store = &store});
    EXPECT_EQ(store.traffic().found, 3u);
    EXPECT_EQ(store.traffic().kept, 3u);
    const auto cold = files_in(folder / "one");
    EXPECT_EQ(cold.size(), 4u);
    EXPECT_EQ(files_in(folder / "two"), cold);
    EXPECT_EQ(files_in(folder / "warm"), cold);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].files, (std::vector<std::string>{"figure_1.svg", "figure_1.pdf", "figure_1.png", "figure_1.csv"}));
    EXPECT_EQ(one[0].error, "");
}

TEST(WriteFigures, OneFailureDoesNotAffectOthers) {
    const Folder folder;
    auto figures = two_figures();
    figures[0].figure.panels[0].series[0].y = Array1D::Ones(1);
    figures.push_back({.identifier = "2", .name = "figure_2", .reason = "no loops"});
    std::vector<std::string> told;
    const auto written = write_figures(figures, {.folder = folder / "out",
                                                 .study = "a.toml",
                                                 .endings = {"csv"},
                                                 .threads = {2},
                                                 .progress = [&](const std::string& name) { told.push_back(name); }});
    ASSERT_EQ(written.size(), 2u);
    EXPECT_NE(written[0].error.find("expected as many"), std::string::npos) << written[0].error;
    EXPECT_TRUE(written[0].files.empty());
    EXPECT_EQ(written[1].files, std::vector<std::string>{"figure_4.csv"});
    std::sort(told.begin(), told.end());
    EXPECT_EQ(told, (std::vector<std::string>{"figure_1", "figure_4"}));
    EXPECT_EQ(files_in(folder / "out").size(), 1u);
}

TEST(WriteFigures, WithoutGnuplotWriteTheNumbers) {
    const Folder folder;
    const std::string path = std::getenv("PATH");
    setenv("PATH", folder.path.c_str(), 1);
    const auto written = write_figures(two_figures(), {.folder = folder / "out", .study = "a.toml"});
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(written[0].files, std::vector<std::string>{"figure_1.csv"});
    EXPECT_NE(written[0].error.find("apt-get install gnuplot-nox"), std::string::npos);
    // said once for three endings
    EXPECT_EQ(written[0].error.find("gnuplot-nox"), written[0].error.rfind("gnuplot-nox"));
}

TEST(WriteFigures, RefuseAnImpossibleFolder) {
    const Folder folder;
    std::ofstream(folder / "file") << "x";
    EXPECT_THROW((void)write_figures(two_figures(), {.folder = folder / "file/below", .study = "a.toml"}), FileError);
}

TEST(FigureNumbers, ContainTheCommandToReproduceThem) {
    const auto figure = study_figure(study_of_pairs(), "4");
    const auto text = data_of(figure, "my study.toml", FigureWidth::single_column);
    EXPECT_EQ(
        text.rfind("# title: Measured and predicted work of adhesion, and energy loss\n# figure: 4\n# caption: ", 0),
        0u)
        << text.substr(0, 200);
    EXPECT_NE(text.find("\n# written by: setae "), std::string::npos);
    EXPECT_NE(
        text.find(
            "\n# command: setae plot 'my study.toml' --figure 4 --width single -o figure_4.svg\npanel,series,name,"),
        std::string::npos);
    EXPECT_NE(
        text.find("\nA,smooth on soft,smooth on soft,predicted W_app,mJ/m2,30,measured W_app,mJ/m2,33,31,35,28,32\n"),
        std::string::npos)
        << text;
}

}  // namespace
}  // namespace setae::study_figures::write_figures_test
