// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "figures/layout.hpp"
#include "figures/ticks.hpp"
#include "setae/figures/figure.hpp"
#include "setae/figures/instrument_look.hpp"
#include "setae/figures/notes.hpp"

namespace setae::figures::appearance_test {
namespace {

using Colour = std::array<double, 3>;

/// Red, green and blue of a colour of the palette, linear in light.
Colour light_of(const std::string& hexadecimal) {
    Colour light{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double shown = std::stoi(hexadecimal.substr(2 * i, 2), nullptr, 16) / 255.0;
        light[i] = shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
    }
    return light;
}

using Matrix = std::array<Colour, 3>;

/// Machado, Oliveira, Fernandes, IEEE Trans. Vis. Comput. Graph. 15 (2009) 1291, severity 1, and full sight.
constexpr std::array<Matrix, 4> eyes{{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}},
}};

Colour times(const Matrix& matrix, const Colour& colour) {
    Colour result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = matrix[i][0] * colour[0] + matrix[i][1] * colour[1] + matrix[i][2] * colour[2];
    return result;
}

/// CIE L*a*b* of linear light, white D65.
Colour lab_of(const Colour& light) {
    constexpr Matrix to_xyz{{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
    constexpr Colour white{0.9505, 1.0, 1.089};
    const auto xyz = times(to_xyz, light);
    Colour f{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double share = xyz[i] / white[i];
        f[i] = share > 0.008856 ? std::cbrt(share) : 7.787 * share + 16.0 / 116.0;
    }
    return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

double distance(int a, int b, const Matrix& eye) {
    const auto seen = [&](int index) {
        auto light = times(eye, light_of(palette[static_cast<std::size_t>(index)]));
        for (auto& part : light) part = std::clamp(part, 0.0, 1.0);
        return lab_of(light);
    };
    const auto first = seen(a), second = seen(b);
    return std::sqrt(std::pow(first[0] - second[0], 2) + std::pow(first[1] - second[1], 2) +
                     std::pow(first[2] - second[2], 2));
}

TEST(InstrumentStyle, IsUniquePerKindOfInstrument) {
    EXPECT_EQ(instrument_look("afm").colour, instrument_look("AFM").colour);
    EXPECT_EQ(instrument_look("confocal").colour, instrument_look("optical").colour);
    EXPECT_EQ(instrument_look("unknown instrument").colour, instrument_look("scanner").colour);
    std::set<int> colours, symbols;
    for (const char* type : {"stylus", "afm", "tem", "optical", "other"}) {
        colours.insert(instrument_look(type).colour);
        symbols.insert(instrument_look(type).symbol);
    }
    EXPECT_EQ(colours.size(), 5u);
    EXPECT_EQ(symbols.size(), 5u);
    // what belongs to an instrument is given to nothing else
    EXPECT_GE(*colours.begin(), general_colours);
    EXPECT_LT(*colours.rbegin(), static_cast<int>(palette.size()));
}

TEST(InstrumentStyle, IsDistinguishableWithColourBlindness) {
    // CIE 1976: 2.3 is just noticeable; Okabe and Ito's own closest pair is 16 apart
    constexpr double least = 16.0;
    for (std::size_t eye = 0; eye < eyes.size(); ++eye)
        for (int a = general_colours; a < static_cast<int>(palette.size()); ++a)
            for (int b = a + 1; b < static_cast<int>(palette.size()); ++b)
                EXPECT_GT(distance(a, b, eyes[eye]), least) << eye << ": " << a << " and " << b;
}

TEST(LinearTicks, OfAShortAxisAreAtLeastThree) {
    // residuals from -3.9 to 5 along 17 mm: steps of 5 would leave 0 and 5 at the frame
    const auto ticks = linear_ticks({-3.9, 4.9}, 17.0, Direction::along_y);
    EXPECT_DOUBLE_EQ(ticks.step, 2.0);
    EXPECT_EQ(ticks.labels, (std::vector<std::string>{"-2", "0", "2", "4"}));
}

TEST(LinearTicks, CountTheLettersOfTheirLabels) {
    // steps of 0.5 between two whole numbers: four letters, "37.5"
    EXPECT_EQ(linear_ticks({33.7, 40.3}, 90.0, Direction::along_y).letters, 4u);
    EXPECT_EQ(linear_ticks({0.0, 80.0}, 90.0, Direction::along_y).letters, 2u);
    // numbers that hold more digits than a double does not hang
    EXPECT_LE(linear_ticks({1e18, 1e18 + 1024.0}, 60.0, Direction::along_x).places.size(), 201u);
}

/// A figure whose one series runs to a value.
Figure up_to(double value, bool logarithmic) {
    Panel panel{.x = {.quantity = "*x*", .logarithmic = logarithmic}, .y = {.quantity = "*y*"}};
    panel.series = {{.label = "a", .x = Array1D{{0.2 * value, value}}, .y = Array1D{{0.0, value}}}};
    return {.panels = {panel}};
}

TEST(GnuplotScript, WritesPowersOfTenInsteadOfE) {
    const auto script = gnuplot_script(up_to(4e9, false), "svg", "a.svg");
    EXPECT_NE(script.find("'2·10⁹' 2e+09"), std::string::npos) << script;
    EXPECT_NE(gnuplot_script(up_to(4e9, true), "svg", "a.svg").find("set format x '%.0t·10^{%T}'"), std::string::npos);
}

TEST(GnuplotScript, ShortensTitlesThatAreLongerThanTheirAxis) {
    Figure figure{.panels = {{.y = {.quantity = "work of adhesion *W*_app", .unit = "mJ/m2"}}}};
    EXPECT_NE(gnuplot_script(figure, "svg", "a.svg").find("'work of adhesion {/:Italic W}_{app}"), std::string::npos);
    figure.height_mm = 30.0;
    EXPECT_EQ(gnuplot_script(figure, "svg", "a.svg").find("work of adhesion"), std::string::npos);
    EXPECT_NE(gnuplot_script(figure, "svg", "a.svg").find("'{/:Italic W}_{app} (mJ m^{−2})'"), std::string::npos);
}

TEST(Headings, ContainALetterAndTheContentOfThePanel) {
    Figure figure{
        .panels = {{.title = "A", .shows = "force"}, {.title = "rough"}, {}, {.title = "smooth", .shows = "all"}}};
    EXPECT_EQ(heading_of(figure, 0).letter + "|" + heading_of(figure, 0).words, "A|force");
    EXPECT_EQ(heading_of(figure, 1).letter + "|" + heading_of(figure, 1).words, "B|rough");
    EXPECT_EQ(heading_of(figure, 2).letter + "|" + heading_of(figure, 2).words, "|");
    EXPECT_EQ(heading_of(figure, 3).letter + "|" + heading_of(figure, 3).words, "C|smooth, all");
    figure.panels = {{.title = "alone"}};
    EXPECT_EQ(heading_of(figure, 0).letter + "|" + heading_of(figure, 0).words, "|alone");
    figure.panels = {{.title = "A", .shows = "force"}, {.title = "B"}};
    figure.width_mm = 178.0;
    const auto script = gnuplot_script(figure, "svg", "a.svg");
    EXPECT_NE(script.find("'{/:Bold A}  force'"), std::string::npos) << script;
    EXPECT_NE(script.find("'{/:Bold B}'"), std::string::npos);
}

TEST(ExtendForNotes, EndsEveryNoteWithinTheAxes) {
    for (const double width_mm : {75.0, 85.0, 178.0}) {
        Panel panel{.x = {.quantity = "share", .unit = "%", .from = 0.0, .to = 50.0},
                    .y = {.from = 0.0, .to = 2.0, .tick_labels = {"a long name of an input", "b"}}};
        panel.notes = {{"± 81 µJ/m²", 48.0, 1.0, Note::Side::right}, {"left", 50.0, 0.0, Note::Side::left}};
        Figure figure{.panels = {panel}, .width_mm = width_mm, .height_mm = 40.0};
        extend_for_notes(figure);
        const auto axes = layout_of(figure, 0).axes;
        const double end = figure.panels[0].x.to.value(), per_mm = end / (axes.right - axes.left);
        EXPECT_NEAR(48.0 + (10.0 * letters_mm + 1.0) * per_mm, end, 1e-9) << width_mm;
    }
    Panel none{.x = {.from = 0.0, .to = 50.0}, .y = {.from = 0.0, .to = 1.0}};
    Figure figure{.panels = {none}};
    extend_for_notes(figure);
    EXPECT_EQ(figure.panels[0].x.to.value(), 50.0);
}

TEST(PutLegendAbove, MovesPanelsBelowTheLegend) {
    Figure figure{.columns = 2, .width_mm = 85.0, .height_mm = 60.0};
    Panel panel;
    for (const char* name : {"one", "two", "three"})
        panel.series.push_back({.label = name, .x = Array1D::Ones(1), .y = Array1D::Ones(1)});
    figure.panels = {panel, panel};
    EXPECT_GT(legend_strip_mm(figure), 3.0);
    put_legend_above(figure);
    ASSERT_TRUE(figure.panels[0].legend_place && figure.panels[1].place);
    EXPECT_NEAR(figure.panels[0].legend_place->height * 60.0, legend_strip_mm(figure), 1e-12);
    EXPECT_NEAR(figure.panels[1].place->top, figure.panels[0].legend_place->height, 1e-12);
    EXPECT_NEAR(figure.panels[1].place->top + figure.panels[1].place->height, 1.0, 1e-12);
    EXPECT_NEAR(figure.panels[1].place->left, 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(figure.height_mm, 60.0);
    Figure none{.panels = {{}}};
    put_legend_above(none);
    EXPECT_FALSE(none.panels[0].legend_place);
}

}  // namespace
}  // namespace setae::figures::appearance_test
