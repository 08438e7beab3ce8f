// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/figures/figure.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace figure_test {

using namespace setae;
using namespace setae::figures;

std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t found = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++found;
    return found;
}

/// A folder for one test.
struct Folder {
    std::filesystem::path path =
        std::filesystem::path(testing::TempDir()) /
        ("setae_figures_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    Folder() {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::string operator/(const char* name) const { return (path / name).string(); }
};

/// PATH replaced for a while.
class SearchPath {
public:
    explicit SearchPath(const std::string& path) : before_(std::getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
    ~SearchPath() { setenv("PATH", before_.c_str(), 1); }
    SearchPath(const SearchPath&) = delete;
    SearchPath& operator=(const SearchPath&) = delete;

private:
    std::string before_;
};

bool there_is_gnuplot() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

Series rising(const std::string& label) {
    return {.label = label, .x = Array1D{{1.0, 10.0, 100.0}}, .y = Array1D{{1.0, 3.0, 9.0}}};
}

Figure figure_of(const Series& series) {
    return {.panels = {{.x = {"wavevector *q*", "1/m", true}, .y = {"*C*_{1D}", "m3", true}, .series = {series}}}};
}

std::string script_of(const Figure& figure) { return gnuplot_script(figure, "svg", "out.svg"); }

TEST(GnuplotScript, SetsQuantitiesItalicAndUnitsUpright) {
    const auto script = script_of(figure_of(rising("a")));
    EXPECT_NE(script.find("set label 'wavevector {/:Italic q} (m^{−1})'"), std::string::npos) << script;
    EXPECT_NE(script.find("set label '{/:Italic C}_{1D} (m^{3})'"), std::string::npos);
    EXPECT_NE(script_of(figure_of(rising("'5'' wafer"))).find("title '{}''5''{}'' wafer"), std::string::npos);
    // a character that no font has
    EXPECT_NE(script_of(figure_of(rising("x\U0010FFFDy"))).find("title 'x□y"), std::string::npos);
    auto figure = figure_of(rising("a"));
    figure.panels[0].x = {"slope h'_rms_ \\*x", "1"};
    figure.panels[0].y = {"*W", "mJ/m2"};
    EXPECT_NE(script_of(figure).find("set label 'slope h''_{rms}_{} *x' at screen"), std::string::npos)
        << script_of(figure);
    EXPECT_NE(script_of(figure).find("set label '{/:Italic W} (mJ m^{−2})'"), std::string::npos);
    figure.panels[0].y.unit = "N m^-1 um2/kg";
    EXPECT_NE(script_of(figure).find("(N m^{−1} µm^{2} kg^{−1})"), std::string::npos) << script_of(figure);
}

TEST(GnuplotScript, EscapesLabels) {
    auto series = rising("it's {1}_2^3 @ & ~ \\ \"q\" α\nset output 'gone'\x01\xff\xc3");
    const auto script = script_of(figure_of(series));
    EXPECT_NE(script.find("title 'it''s \\{1\\}\\_2\\^3 \\@ \\& \\~ \\\\ \"q\" α set output ''gone''   '"),
              std::string::npos)
        << script;
    auto figure = figure_of(rising("a"));
    figure.panels[0].title = "5_%";
    figure.panels[0].x = {.quantity = "instrument", .tick_labels = {"AFM_1", "5 %"}};
    EXPECT_NE(script_of(figure).find("{/:Bold 5\\_%}"), std::string::npos);
    EXPECT_NE(script_of(figure).find("set xtics ('AFM\\_1' 0, '5 %%' 1)"), std::string::npos) << script_of(figure);
    EXPECT_NE(script_of(figure).find("set xrange [-0.5:1.5]"), std::string::npos);
    EXPECT_NE(gnuplot_script(figure, "svg", "it's.svg").find("set output 'it''s.svg'"), std::string::npos);
}

TEST(GnuplotScript, InterruptsALineAtUndefinedValues) {
    Series series{
        .label = "a", .x = Array1D{{1.0, 2.0, 3.0, 4.0, 5.0}}, .y = Array1D{{1.0, undefined, undefined, 4.0, -5.0}}};
    EXPECT_NE(script_of(figure_of(series)).find("<< END_OF_DATA\n1 1 1 1 1 1\n\n4 4 4 4 4 4\n\nEND_OF_DATA"),
              std::string::npos)
        << script_of(figure_of(series));
    series.y = Array1D::Constant(5, undefined);
    EXPECT_NE(script_of(figure_of(series)).find("plot NaN notitle"), std::string::npos);
    EXPECT_NE(script_of(figure_of({})).find("plot NaN notitle"), std::string::npos);
    EXPECT_NE(script_of({.panels = {{}}}).find("plot NaN notitle"), std::string::npos);
}

TEST(GnuplotScript, ClipsErrorBarsAtALogarithmicAxis) {
    auto series = rising("a");
    series.lower = Array1D{{-1.0, 2.0, undefined}};
    series.upper = Array1D{{2.0, 4.0, 12.0}};
    auto figure = figure_of(series);
    figure.panels[0].y.from = 0.5;
    EXPECT_NE(script_of(figure).find("\n1 1 0.5 2 1 1\n10 3 2 4 10 10\n100 9 9 12 100 100\n"), std::string::npos)
        << script_of(figure);
}

TEST(GnuplotScript, ClipsBandsAtThePanel) {
    // x from 0 to 4, upper from 1e-3 by five decades to 100: the panel shows x from 1 to 3 and y up to 1
    Series band{.label = "band",
                .x = Array1D{{0.0, 4.0}},
                .y = {},
                .lower = Array1D{{-1.0, 1e-3}},
                .upper = Array1D{{1e-3, 100.0}},
                .mark = Mark::band};
    auto figure = figure_of(band);
    figure.panels[0].x = {.quantity = "x", .from = 1.0, .to = 3.0};
    figure.panels[0].y.from = 1e-4;
    figure.panels[0].y.to = 1.0;
    const auto script = script_of(figure);
    const auto begin = script.find("<< END_OF_DATA\n") + 15, end = script.find("\nEND_OF_DATA");
    std::istringstream lines(script.substr(begin, end - begin));
    int points = 0;
    double x = 0.0, middle = 0.0, lower = 0.0, upper = 0.0, left = 0.0, right = 0.0;
    for (; lines >> x >> middle >> lower >> upper >> left >> right; ++points) {
        EXPECT_TRUE(x >= 1.0 && x <= 3.0) << x;
        EXPECT_NEAR(std::log10(upper), std::min(-3.0 + 1.25 * x, 0.0), 1e-4) << x;
        EXPECT_NEAR(std::log10(lower), -4.0 + 0.25 * x, 1e-4) << x;
    }
    EXPECT_EQ(points, 33);
}

TEST(GnuplotScript, LeavesAMarginAroundTheData) {
    auto figure = figure_of(rising("a"));
    figure.panels[0].x.logarithmic = false;
    figure.panels[0].horizontal_lines = {0.1};
    // 1 … 100 and 5 % of it; in decades 0.1 … 9
    EXPECT_NE(script_of(figure).find("set xrange [-3.95:104.95]"), std::string::npos) << script_of(figure);
    const auto at = script_of(figure).find("set yrange [");
    EXPECT_NEAR(std::log10(std::stod(script_of(figure).substr(at + 12))), -1.0 - 0.05 * std::log10(90.0), 1e-12);
    EXPECT_NE(script_of(figure).find("first 0.1 to graph 1"), std::string::npos);
}

TEST(GnuplotScript, PutsTheLegendWhereDataAreFewest) {
    EXPECT_NE(script_of(figure_of(rising("a"))).find("set key inside top left"), std::string::npos);
    auto falling = rising("a");
    falling.y.reverseInPlace();
    EXPECT_NE(script_of(figure_of(falling)).find("set key inside top right"), std::string::npos);
    auto figure = figure_of(falling);
    figure.panels[0].legend_corner = Corner::bottom_left;
    EXPECT_NE(script_of(figure).find("set key inside bottom left"), std::string::npos);
    figure.panels[0].legend = false;
    EXPECT_NE(script_of(figure).find("unset key"), std::string::npos);
}

TEST(GnuplotScript, DistinguishesSeriesByColourSymbolAndDash) {
    auto figure = figure_of(rising("a"));
    figure.panels[0].series = {rising("a"), rising("b"), rising("c")};
    figure.panels[0].series[0].mark = figure.panels[0].series[1].mark = Mark::line;
    figure.panels[0].series[2].colour = 0;
    figure.panels[0].series[2].symbol = 1;
    const auto script = script_of(figure);
    EXPECT_NE(script.find("with lines lc rgb '#0072B2' lw 1.3 dt solid title 'a'"), std::string::npos) << script;
    EXPECT_NE(script.find("with lines lc rgb '#D55E00' lw 1.3 dt (9,5) title 'b'"), std::string::npos);
    EXPECT_NE(script.find("with linespoints pt 5 ps 0.51 lc rgb '#0072B2'"), std::string::npos);
}

TEST(GnuplotScript, RefusesWhatCannotBeDrawn) {
    EXPECT_THROW((void)script_of({}), InvalidArgument);
    auto figure = figure_of(rising("a"));
    EXPECT_THROW((void)gnuplot_script(figure, "eps", "a.eps"), InvalidArgument);
    figure.panels[0].y.from = 0.0;
    EXPECT_THROW((void)script_of(figure), InvalidArgument);
    figure = figure_of(rising("a"));
    figure.panels[0].x.from = 5.0;
    figure.panels[0].x.to = 4.0;
    EXPECT_THROW((void)script_of(figure), InvalidArgument);
    figure = figure_of(rising("a"));
    figure.width_mm = 10.0;
    EXPECT_THROW((void)script_of(figure), InvalidArgument);
    figure.width_mm = undefined;
    EXPECT_THROW((void)script_of(figure), InvalidArgument);
    auto series = rising("short");
    series.lower = series.y;
    EXPECT_THROW((void)script_of(figure_of(series)), InvalidArgument);
    series = rising("short");
    series.y = Array1D::Ones(2);
    try {
        (void)script_of(figure_of(series));
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("series 'short': 3 values of x and 2 of y"), std::string::npos)
            << error.what();
    }
    series = rising("band without ends");
    series.mark = Mark::band;
    EXPECT_THROW((void)script_of(figure_of(series)), InvalidArgument);
}

/// Three panels with every mark.
Figure everything() {
    Figure figure{.columns = 3, .width_mm = 178.0};
    for (const auto mark : {Mark::points, Mark::line, Mark::band}) {
        auto series = rising("_{} <b> & α");
        series.mark = mark;
        series.lower = 0.5 * series.y;
        series.upper = 2.0 * series.y;
        auto other = rising("hollow");
        other.hollow = true;
        other.left = 0.5 * other.x;
        other.right = 2.0 * other.x;
        auto panel = figure_of(series).panels[0];
        panel.title = "A & B";
        panel.series.push_back(other);
        panel.horizontal_lines = {2.0};
        figure.panels.push_back(panel);
    }
    return figure;
}

TEST(Draw, MakesTheSameFileEachTime) {
    if (!there_is_gnuplot()) GTEST_SKIP() << "no gnuplot";
    const Folder folder;
    for (const char* name : {"a.svg", "a.png", "a.pdf"}) {
        draw(everything(), folder / name);
        const auto first = content_of(folder / name);
        draw(everything(), folder / name);
        EXPECT_EQ(content_of(folder / name), first) << name;
        EXPECT_GT(first.size(), 5000u) << name;
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path), {}), 3);
}

TEST(Draw, DrawsItsData) {
    if (!there_is_gnuplot()) GTEST_SKIP() << "no gnuplot";
    const Folder folder;
    draw(everything(), folder / "full.svg");
    draw(everything(), folder / "full.png");
    auto empty = everything();
    for (auto& panel : empty.panels) panel.series = {{}};
    draw(empty, folder / "empty.svg");
    draw(empty, folder / "empty.png");
    const auto full = content_of(folder / "full.svg"), bare = content_of(folder / "empty.svg");
    // three series of three symbols each beside the legends, white ones below the hollow
    EXPECT_GE(count(full, "<use xlink:href"), count(bare, "<use xlink:href") + 3 * 6);
    EXPECT_NE(full.find(">_{} &lt;b> &amp; α"), std::string::npos);
    EXPECT_EQ(bare.find("hollow"), std::string::npos);
    EXPECT_NE(bare.find("wavevector"), std::string::npos);
    const auto image = content_of(folder / "full.png");
    ASSERT_EQ(image.substr(0, 8), "\x89PNG\r\n\x1a\n");
    const auto number = [&](std::size_t at) {
        return static_cast<unsigned char>(image[at + 2]) * 256 + static_cast<unsigned char>(image[at + 3]);
    };
    EXPECT_NEAR(number(16), 178.0 / 25.4 * 300.0, 1.0);
    EXPECT_NEAR(number(20), 65.0 / 25.4 * 300.0, 1.0);
    EXPECT_GT(image.size(), content_of(folder / "empty.png").size() + 5000);
}

TEST(Draw, NamesThePackageToInstallWithoutGnuplot) {
    const Folder folder;
    const SearchPath nowhere(folder.path.string());
    try {
        draw(everything(), folder / "a.svg");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("apt-get install gnuplot-nox"), std::string::npos) << error.what();
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path));
}

TEST(Draw, ReportsTheMessageOfAFailingGnuplot) {
    const Folder folder;
    std::filesystem::create_directory(folder / "bin");
    std::ofstream(folder / "bin/gnuplot") << "#!/bin/sh\necho 'line 7: undefined terminal' >&2\nexit 1\n";
    std::filesystem::permissions(folder / "bin/gnuplot", std::filesystem::perms::owner_all);
    const SearchPath search(folder / "bin");
    try {
        draw(everything(), folder / "a.svg");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("a.svg: gnuplot failed: line 7: undefined terminal"),
                  std::string::npos)
            << error.what();
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "a.svg"));
}

TEST(Draw, RefusesMissingFoldersAndUnknownEndings) {
    if (!there_is_gnuplot()) GTEST_SKIP() << "no gnuplot";
    const Folder folder;
    EXPECT_THROW(draw(everything(), folder / "none/a.svg"), FileError);
    EXPECT_THROW(draw(everything(), folder / "a"), InvalidArgument);
    EXPECT_THROW(draw(everything(), folder / "a.jpg"), InvalidArgument);
}

TEST(GnuplotScript, DrawsSeriesThatAreInTheLegendOnly) {
    auto figure = figure_of(rising("data"));
    figure.panels[0].series[0].in_legend = false;
    figure.panels[0].series.push_back({.label = "meaning", .mark = Mark::points, .colour = 4, .legend_only = true});
    const auto script = script_of(figure);
    EXPECT_NE(script.find("keyentry with points pt 11"), std::string::npos) << script;
    EXPECT_NE(script.find("title 'meaning'"), std::string::npos);
    EXPECT_EQ(script.find("title 'data'"), std::string::npos);
    figure.panels[0].series.erase(figure.panels[0].series.begin());
    EXPECT_NE(script_of(figure).find("plot NaN notitle, \\\n     keyentry"), std::string::npos) << script_of(figure);
}

TEST(GnuplotScript, UsesDashAndOpacityOfASeries) {
    auto series = rising("a");
    series.mark = Mark::line;
    series.colour = 1;
    series.dash = 2;
    series.opacity = 0.5;
    series.line_width = 0.7;
    EXPECT_NE(script_of(figure_of(series)).find("with lines lc rgb '#80D55E00' lw 0.7 dt (2,4) title 'a'"),
              std::string::npos)
        << script_of(figure_of(series));
}

TEST(GnuplotScript, FillsTheAreaInsideALoop) {
    auto series = rising("loop");
    series.mark = Mark::area;
    EXPECT_NE(
        script_of(figure_of(series))
            .find(
                "using 1:2 with filledcurves closed fs transparent solid 0.25 noborder lc rgb '#0072B2' title 'loop'"),
        std::string::npos)
        << script_of(figure_of(series));
}

TEST(GnuplotScript, PutsNotesNextToTheirPositions) {
    auto figure = figure_of(rising("a"));
    figure.panels[0].notes = {{.text = "it's 5 %", .x = 10.0, .y = 3.0, .side = Note::Side::right}};
    EXPECT_NE(script_of(figure).find("set label 'it''s 5 %' at first 10,3 left offset 0.6,0"), std::string::npos)
        << script_of(figure);
}

TEST(GnuplotScript, OmitsNumbersOfBareAxes) {
    auto figure = figure_of(rising("a"));
    figure.panels[0].x.bare = true;
    EXPECT_NE(script_of(figure).find("set format x ''\n"), std::string::npos);
    EXPECT_EQ(script_of(figure).find("wavevector"), std::string::npos);
}

TEST(GnuplotScript, ReservesSpaceForNumbersAtLinearAxes) {
    auto figure = figure_of(rising("a"));
    figure.panels[0].x = {.quantity = "x", .from = 0.0, .to = 0.08};
    // a number such as 0.02 wants 8.3 mm: eight of them do not fit along 66 mm
    EXPECT_NE(script_of(figure).find("set xtics 0.02 "), std::string::npos) << script_of(figure);
    figure.width_mm = 35.0;
    EXPECT_NE(script_of(figure).find("set xtics 0.05 "), std::string::npos) << script_of(figure);
}

/// A map with one undefined cell.
Figure map_figure() {
    Figure figure{.panels = {{.x = {"*x*", "um"}, .y = {"*y*", "um"}}}};
    Array2D values = Array2D::Zero(4, 2);
    values(3, 1) = 5.0;
    values(0, 0) = undefined;
    figure.panels[0].map = HeatMap{values, 2.0, 1.0, {"height *h*", "nm"}};
    return figure;
}

TEST(GnuplotScript, DrawsMapsInOneScaleAlongBothAxes) {
    const auto script = script_of(map_figure());
    EXPECT_NE(script.find("set xrange [0:2]"), std::string::npos);
    EXPECT_NE(script.find("set cbrange [0:5]"), std::string::npos);
    EXPECT_NE(script.find("\n1.75 0.75 5\n"), std::string::npos) << script;
    const auto margin = [&](const char* name) {
        return std::stod(script.substr(script.find(std::string("set ") + name + "margin at screen ") + 21));
    };
    EXPECT_NEAR((margin("r") - margin("l")) * 85.0, 2.0 * (margin("t") - margin("b")) * 65.0, 1e-2);
    auto figure = map_figure();
    figure.panels[0].map->width = 0.0;
    EXPECT_THROW((void)script_of(figure), InvalidArgument);
}

TEST(GnuplotScript, PutsPanelsAtGivenPositions) {
    auto figure = figure_of(rising("a"));
    figure.panels[0].place = Place{0.5, 0.25, 0.5, 0.75};
    const auto script = script_of(figure);
    const auto margin = [&](const char* name) {
        return std::stod(script.substr(script.find(std::string("set ") + name + "margin at screen ") + 21));
    };
    EXPECT_GT(margin("l"), 0.5);
    EXPECT_LT(margin("t"), 0.75);
    EXPECT_GT(margin("t"), 0.68);
}

TEST(GnuplotScript, ReservesSpaceForALegendNextToTheAxes) {
    auto figure = figure_of(rising("a label of some length"));
    const auto right = [&] {
        return std::stod(script_of(figure).substr(script_of(figure).find("set rmargin at screen ") + 22));
    };
    const double before = right();
    figure.panels[0].legend_right = true;
    EXPECT_LT(right() * 85.0, before * 85.0 - 30.0);
    EXPECT_NE(script_of(figure).find("set key at screen "), std::string::npos);
}

TEST(Draw, EscapesTheEndOfXmlSections) {
    if (!there_is_gnuplot()) GTEST_SKIP() << "no gnuplot";
    auto figure = figure_of(rising("a]]>b"));
    figure.panels[0].title = "c]]>d";
    const auto content = drawn(figure, "svg");
    EXPECT_EQ(content.find("]]>"), std::string::npos);
    EXPECT_NE(content.find("]]&gt;"), std::string::npos);
}

TEST(Draw, EmbedsMapsInTheFile) {
    if (!there_is_gnuplot()) GTEST_SKIP() << "no gnuplot";
    const auto content = drawn(map_figure(), "svg");
    EXPECT_NE(content.find("xlink:href='data:image/png;base64,"), std::string::npos);
    // nothing else is referred to
    for (auto at = content.find("href="); at != std::string::npos; at = content.find("href=", at + 1))
        EXPECT_TRUE(content[at + 6] == '#' || content.compare(at + 6, 5, "data:") == 0) << content.substr(at, 60);
    EXPECT_EQ(drawn(map_figure(), "svg"), content);
}

TEST(Draw, UsesTheGnuplotOnThePath) {
    if (!there_is_gnuplot()) GTEST_SKIP() << "no gnuplot";
    EXPECT_NE(drawing_program().find("gnuplot"), std::string::npos);
    const Folder folder;
    const SearchPath nowhere(folder.path.string());
    EXPECT_EQ(drawing_program(), "");
}

TEST(FigureData, HaveOneRowPerPoint) {
    const Folder folder;
    auto series = rising("say \"a, b\"");
    series.lower = Array1D{{0.5, undefined, 8.0}};
    series.upper = Array1D{{1.5, 4.0, 10.0}};
    auto figure = figure_of(series);
    figure.panels.push_back(figure.panels[0]);
    figure.panels[1].title = "B";
    figure.panels[1].x.unit = "";
    figure.panels[1].series[0].names = {"first", "second", "third"};
    write_data(figure, folder / "a.csv");
    const auto text = content_of(folder / "a.csv");
    EXPECT_EQ(text.substr(0, text.find('\n')),
              "panel,series,name,x quantity,x unit,x,y quantity,y unit,y,lower,upper,left,right");
    EXPECT_NE(text.find("\n1,\"say \"\"a, b\"\"\",,wavevector q,1/m,10,C_1D,m3,3,,4,,\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nB,\"say \"\"a, b\"\"\",third,wavevector q,1,100,C_1D,m3,9,8,10,,\n"), std::string::npos)
        << text;
    figure.panels[1].title = "=1+1";
    figure.panels[1].series[0].label = "＝2";
    write_data(figure, folder / "a.csv");
    EXPECT_NE(content_of(folder / "a.csv").find("\n'=1+1,'＝2,third,"), std::string::npos);
    EXPECT_EQ(count(text, "\n"), 7u);
}

TEST(FigureData, ContainTheCellsOfMaps) {
    const auto text = data_text(map_figure());
    EXPECT_EQ(
        text.substr(0, text.find('\n')),
        "panel,series,name,x quantity,x unit,x,y quantity,y unit,y,lower,upper,left,right,value quantity,value unit,value");
    EXPECT_NE(text.find("\n1,map,,x,um,1.75,y,um,0.75,,,,,height h,nm,5\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\n1,map,,x,um,0.25,y,um,0.25,,,,,height h,nm,\n"), std::string::npos) << text;
    EXPECT_EQ(count(text, "\n"), 9u);
}

TEST(FigureData, RequireANamePerPointOrNone) {
    auto series = rising("a");
    series.names = {"one"};
    EXPECT_THROW((void)data_text(figure_of(series)), InvalidArgument);
}

}  // namespace figure_test
