// SPDX-License-Identifier: GPL-3.0-or-later
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "format_list.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "text/curve_channel.hpp"

namespace setae::formats {
namespace {

constexpr std::string_view hfm_magic = "X;Y;valid";

Match detect_hfm(std::string_view head, const bytes::Source&) {
    if (head.starts_with("\xef\xbb\xbf")) head.remove_prefix(3);
    return head.starts_with(hfm_magic) ? Match::yes : Match::no;
}

std::vector<Channel> open_hfm(const bytes::Source& source, const ReadOptions& options) {
    const auto table = tables::read_raw_table(source, {.separator = ';'});
    if (table.columns.size() != 3)
        throw FormatError(source.name, {.line = 1},
                          fmt::format("HFM: {} columns, expected X, Y and valid", table.columns.size()));
    HeightCurve curve{table.columns[0], table.columns[1]};
    curve.heights.values = (table.columns[2].values != 0.0).select(curve.heights.values, undefined);
    ChannelInfo info;
    info.name = curve.heights.name;
    info.format = "hfm";
    return curve_channels(std::move(info), curve, options, source);
}

}  // namespace

Format hfm_format() {
    return {.identifier = "hfm",
            .name = "HFM profile",
            .extensions = ".hfm",
            .description = "profiles as text with the columns X, Y and valid and their units below the names",
            .heights = "values in the unit of their column; undefined where valid is 0",
            .orientation = "",
            .reference = "SurfaceTopography 1.27.1, IO/XYZ.py",
            .tested_on_real_files = true,
            .read_elsewhere = false,
            .detect = detect_hfm,
            .open = open_hfm};
}

}  // namespace setae::formats
