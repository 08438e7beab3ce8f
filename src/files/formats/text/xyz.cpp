// SPDX-License-Identifier: GPL-3.0-or-later
#include "format_list.hpp"
#include "text_channels.hpp"

namespace setae::formats {
namespace {

Match detect_xyz(std::string_view head, const bytes::Source& source) {
    const auto guess = guess_text(head, source);
    if (guess.content != TextContent::points) return Match::no;
    return guess.certain ? Match::yes : Match::maybe;
}

}  // namespace

Format xyz_format() {
    return {
        .identifier = "xyz",
        .name = "points x, y, z in text",
        .extensions = ".xyz .txt .csv",
        .description =
            "three columns x, y, z on a complete or incomplete regular grid, in any order, with any separator, decimal point or comma; units in the header or given",
        .heights =
            "values in the unit stated or given; nodes without a point, empty cells and words such as nan and N/A are undefined",
        .orientation = "smallest x at the left, smallest y at the top",
        .not_read = "scattered points are refused",
        .reference = "no standard; Gwyddion module xyzexport for the header 'Lateral units', 'Value units'",
        .tested_on_real_files = true,
        .carries_scale = false,
        .read_elsewhere = false,
        .detect = detect_xyz,
        .open = open_text};
}

}  // namespace setae::formats
