// SPDX-License-Identifier: GPL-3.0-or-later
#include "format_list.hpp"
#include "text_channels.hpp"

namespace setae::formats {
namespace {

Match detect_matrix_text(std::string_view head, const bytes::Source& source) {
    const auto guess = guess_text(head, source);
    if (guess.content != TextContent::matrix) return Match::no;
    return guess.certain ? Match::yes : Match::maybe;
}

}  // namespace

Format matrix_text_format() {
    return {
        .identifier = "matrix",
        .name = "text matrix",
        .extensions = ".txt .asc",
        .description =
            "numbers only, a row of the map a line, any separator, decimal point or comma: Gwyddion's export in its languages, also several maps in one file, SPIP, Wyko Vision, Nova, "
            "'h=305 w=75', tables of confocal microscopes with 'XY calibration', and maps without header, whose size and unit are given; a first row and column of positions or of numbers of rows are no heights, positions give the size; one column or row is a line",
        .heights =
            "values in the unit stated or given, times the header's conversion factor; Wyko: times wavelength over multiplier; words such as nan, N/A, bad, inf, *** and SPIP's void points are undefined",
        .orientation =
            "first line at the top; with positions the smallest y; Wyko: a line holds one x, y from the bottom",
        .not_read = "channels that are no lengths, Wyko's intensities and other blocks are listed only",
        .reference =
            "Gwyddion user guide, export as ASCII data matrix; Gwyddion modules asciiexport, spip-asc and opdfile; SurfaceTopography 1.27.1, IO/Text.py",
        .tested_on_real_files = true,
        .carries_scale = false,
        .read_elsewhere = false,
        .detect = detect_matrix_text,
        .open = open_text,
        .write = write_text_matrix};
}

}  // namespace setae::formats
