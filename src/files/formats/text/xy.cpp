// SPDX-License-Identifier: GPL-3.0-or-later
#include "format_list.hpp"
#include "text_channels.hpp"

namespace setae::formats {
namespace {

Match detect_xy(std::string_view head, const bytes::Source& source) {
    const auto guess = guess_text(head, source);
    if (guess.content != TextContent::curve) return Match::no;
    return guess.certain ? Match::yes : Match::maybe;
}

}  // namespace

Format xy_format() {
    return {
        .identifier = "xy",
        .name = "two-column text",
        .extensions = ".csv .txt .asc .dat",
        .description =
            "x and height, or x and the heights of several profiles, with any separator, decimal point or "
            "comma, header and units in it or given; equal steps give a line scan, missing rows undefined "
            "heights in it, others a profile as traced; passes back and forth are separate channels; also "
            "after an index column, before a third column 'valid' or 'standard_error', setae's own profiles "
            "with the response of their trace, and exports of profilers without header, such as "
            "KLA-Tencor's Alpha-Step and Apex",
        .heights =
            "values in the unit stated or given; empty cells and words such as nan and N/A are undefined; heights at the same position are averaged",
        .orientation = "",
        .not_read =
            "columns of other quantities are listed only; units of exports without a header, such as those "
            "of KLA-Tencor's P and Alpha-Step profilers, x in mm and heights in um, are given in `unit`: "
            "\"mm, um\"",
        .reference = "no standard; setae/tables/table_file.hpp lists the dialects",
        .tested_on_real_files = true,
        .carries_scale = false,
        .read_elsewhere = false,
        .detect = detect_xy,
        .open = open_text,
        .write = write_text_curve};
}

}  // namespace setae::formats
