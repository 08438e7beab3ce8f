// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "format_samples.hpp"
#include "setae/core/constants.hpp"

/// Text formats: matrices, points, curves.
namespace setae::formats::tests {
namespace {

constexpr Index nx = 7, ny = 4;

/// Lines of a map, from the top; NaN as `undefined_word`.
std::string rows(const Array2D& map, const char* separator, char decimal = '.', const char* undefined_word = "nan") {
    std::string text;
    for (Index j = 0; j < map.cols(); ++j)
        for (Index i = 0; i < map.rows(); ++i) {
            auto cell = std::isnan(map(i, j)) ? std::string(undefined_word) : fmt::format("{:.3f}", map(i, j));
            std::replace(cell.begin(), cell.end(), '.', decimal);
            text += cell + (i + 1 < map.rows() ? separator : "\n");
        }
    return text;
}

/// A map with an undefined point in its last line.
Array2D holed(double unit) {
    Array2D map = lopsided_heights(nx, ny, unit);
    map(2, 3) = undefined;
    return map;
}

FormatSample matrix(const std::string& name, const std::string& header, const std::string& numbers, double unit,
                    std::vector<double> size) {
    return {.format = "matrix",
            .name = name,
            .content = header + numbers,
            .shape = {nx, ny},
            .size = std::move(size),
            .heights = holed(unit),
            .may_lose_its_end = true};
}

FormatSample wyko() {
    const auto map = holed(1.0);
    std::string text =
        "Wyko ASCII Data File Format 0\t0\t1\nX Size\t7\nY Size\t4\nBlock Name\tType\tLength\tValue\nWavelength\t7\t4\t600\nMult\t6\t2\t2\n"
        "Pixel_size\t7\t4\t0.001\nAspect\t7\t4\t1.5\nTitle\t5\t20\tstep\nRAW_DATA\t3\t112\t\n";
    for (Index i = 0; i < nx; ++i)
        for (Index j = ny - 1; j >= 0; --j)
            text += (std::isnan(map(i, j)) ? std::string("Bad") : fmt::format("{}", map(i, j))) + (j > 0 ? "\t" : "\n");
    auto sample = matrix("Wyko", text, "", 300 * units::nm, {7 * units::um, 6 * units::um});
    sample.may_lose_its_end = false;
    return sample;
}

FormatSample spip() {
    auto sample = matrix(
        "SPIP with void points",
        "# File Format = ASCII\r\n# Created by SPIP 4.5\r\n# x-pixels = 7\r\n# y-pixels = 4\r\n# x-length = 700\r\n# y-length = 400\r\n# Bit2nm = 0.5\r\n# voidpixels = 1\r\n# Start of Data:\r\n",
        rows(lopsided_heights(nx, ny, 1.0), " ") + "0 0 0 0 0 0 0\n0 0 0 0 0 0 0\n0 0 0 0 0 0 0\n0 0 1 0 0 0 0\n",
        0.5 * units::nm, {700 * units::nm, 400 * units::nm});
    sample.may_lose_its_end = false;
    return sample;
}

FormatSample second_of_two() {
    const auto first = rows(lopsided_heights(3, 2, 1.0), "\t");
    auto sample = matrix("second of two maps in one file",
                         "# Channel: A\n# Width: 3 nm\n# Height: 2 nm\n# Value units: V\n" + first +
                             "# Channel: B\n# Width: 7 µm\n# Height: 4 µm\n# Value units: nm\n",
                         rows(holed(1.0), "\t"), units::nm, {7 * units::um, 4 * units::um});
    sample.channel = 1;
    return sample;
}

FormatSample plain(const std::string& name, const std::string& numbers) {
    auto sample = matrix(name, "", numbers, units::nm, {7 * units::um, 4 * units::um});
    sample.options = {{{7 * units::um, 4 * units::um}}, "nm"};
    return sample;
}

FormatSample counted() {
    return matrix("h= w=", "h=4 w=7\npixel size=2e-007 m\ndata unit=rad\nheight conversion factor (-> m)=3e-008\n",
                  rows(holed(1.0), " ", '.', "inf"), 3e-8, {1.4 * units::um, 0.8 * units::um});
}

FormatSample single_column() {
    return {.format = "matrix",
            .name = "one column",
            .content = "1\n2.5\n4\n-3\n",
            .options = {{{4 * units::um}}, "um"},
            .shape = {4},
            .size = {4 * units::um},
            .heights = (Array2D(4, 1) << 1, 2.5, 4, -3).finished() * units::um,
            .may_lose_its_end = true};
}

std::string utf16(const std::string& ascii) {
    std::string text = "\xff\xfe";
    for (const char c : ascii) {
        text += c;
        text += '\0';
    }
    return text;
}

/// x, y, z of every node that is defined, columns first.
std::string points(const Array2D& map, bool backwards) {
    std::string text;
    for (Index n = 0; n < map.size(); ++n) {
        const Index k = backwards ? map.size() - 1 - n : n, i = k / map.cols(), j = k % map.cols();
        if (!std::isnan(map(i, j)))
            text += fmt::format("{:.3f}\t{:.3f}\t{:.3f}\n", 0.5 * static_cast<double>(i) - 1.0,
                                0.25 * static_cast<double>(j) + 3.0, map(i, j));
    }
    return text;
}

FormatSample grid(const std::string& name, const std::string& content, const Array2D& heights) {
    return {.format = "xyz",
            .name = name,
            .content = content,
            .shape = {nx, ny},
            .size = {3.5 * units::um, 1.0 * units::um},
            .heights = heights,
            .may_lose_its_end = true};
}

Array2D line_heights(double unit) {
    return (Array2D(6, 1) << 1.5, -2.25, 3.0, 4.125, undefined, 6.5).finished() * unit;
}

/// Lines of x and h at steps of `step`, with an ending.
std::string curve(double step, const char* separator, const char* end, const char* undefined_word) {
    const auto heights = line_heights(1.0);
    std::string text;
    for (Index i = 0; i < heights.rows(); ++i)
        text += fmt::format("{:.2f}{}{}{}\n", step * static_cast<double>(i), separator,
                            std::isnan(heights(i, 0)) ? undefined_word : fmt::format("{:.3f}", heights(i, 0)), end);
    return text;
}

FormatSample line(const std::string& format, const std::string& name, const std::string& content, double unit,
                  double size) {
    return {.format = format,
            .name = name,
            .content = content,
            .shape = {6},
            .size = {size},
            .heights = line_heights(unit),
            .may_lose_its_end = true};
}

}  // namespace

std::vector<FormatSample> matrix_text_samples() {
    const std::string english = "# Channel: Z (Forward)\n# Width: 7 µm\n# Height: 4000 nm\n# Value units: nm\n",
                      german = "# Kanal: Z\n# Breite: 7,0 µm\n# Höhe: 4,0 µm\n# Einheiten: nm\n";
    const std::vector<double> size{7 * units::um, 4 * units::um};
    return {matrix("Gwyddion", english, rows(holed(1.0), "\t"), units::nm, size),
            matrix("Gwyddion, German with decimal commas", german, rows(holed(1.0), "\t", ','), units::nm, size),
            wyko(),
            spip(),
            second_of_two(),
            counted(),
            matrix("Nova", "NX = 7\nNY = 4\nScale X = 0.5\nScale Y = 0.25\nUnit X = um\nUnit Data = nm\n",
                   rows(holed(1.0), "\t"), units::nm, {3.5 * units::um, 1 * units::um}),
            plain("blanks", rows(holed(1.0), "  ")),
            plain("semicolons and decimal commas", rows(holed(1.0), ";", ',', "bad")),
            plain("commas", rows(holed(1.0), ",", '.', "***")),
            plain("UTF-16", utf16(rows(holed(1.0), "\t"))),
            single_column()};
}

std::vector<FormatSample> xyz_samples() {
    const std::string header = "x [um]\ty [um]\tz [nm]\n";
    auto given =
        grid("backwards, unit given", points(lopsided_heights(nx, ny, 1.0), true), lopsided_heights(nx, ny, units::um));
    given.options = {{}, "um"};
    return {
        grid("incomplete, units in the header", header + points(holed(1.0), false), holed(units::nm)),
        grid("Gwyddion",
             "# Channel: Z\n# Lateral units: µm\n# Value units: nm\n" + points(lopsided_heights(nx, ny, 1.0), false),
             lopsided_heights(nx, ny, units::nm)),
        given};
}

std::vector<FormatSample> xy_samples() {
    auto given = line("xy", "without header", curve(0.5, " ", "", "nan"), units::um, 3 * units::um);
    given.options = {{}, "um"};
    return {line("xy", "units in the header", "x [um],h [nm]\n" + curve(0.5, ",", "", ""), units::nm, 3 * units::um),
            given};
}

std::vector<FormatSample> dektak_csv_samples() {
    return {line(
        "dektak-csv", "scan",
        "Scan Parameters\r\r\nScan Type,Standard Scan\r\nStylus,Radius: 2.5 \xb5m\r\nForce,3.00 mg\r\n\r\r\nAnalytical Results\r\r\n"
        "Function,R.Cur Pos,R.Cur Width,M.Cur Pos,M.Cur Width,Result\r\nRa,1.0 um,0.0 um,2.0 um,0.0 um,0.125 um\r\n\r\r\nScan Data\r\r\nLateral um,Raw Nanometer,\r\n" +
            curve(0.5, ",", ",,\r", ""),
        units::nm, 3 * units::um)};
}

std::vector<FormatSample> hfm_samples() {
    return {line(
        "hfm", "scan",
        "X;Y;valid\r\n[mm];[um];[1/0]\r\n0.00;1.5;1\r\n0.01;-2.25;1\r\n0.02;3;1\r\n0.03;4.125;1\r\n0.04;99;0\r\n0.05;6.5;1\r\n",
        units::um, 60 * units::um)};
}

std::vector<FormatSample> dabam_samples() {
    const std::string names = "X(mm)\tMeasured heigth (nm)\tSlope (micror-rad)\n";
    FormatSample slopes{.format = "dabam",
                        .name = "slopes",
                        .content = "x(mm)\tslope error (urad)\n0\t1\n1\t3\n2\t-1\n3\t0\n",
                        .shape = {4},
                        .size = {4 * units::mm},
                        .may_lose_its_end = true};
    slopes.heights = (Array2D(4, 1) << 0.0, 2.0, 3.0, 2.5).finished() * units::nm;
    return {line("dabam", "heights and slopes", names + curve(0.5, "\t", "\t0.25", "nan"), units::nm, 3 * units::mm),
            slopes};
}

}  // namespace setae::formats::tests
