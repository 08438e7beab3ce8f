// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <limits>

#include <fmt/format.h>

#include "filtered.hpp"
#include "profile_lines.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/texture/height_parameters.hpp"

namespace setae::texture {
namespace {

struct Row {
    double largest_Ra;
    ProfileSetting setting;
};

constexpr std::array<Row, 5> rows{{{0.02e-6, {0.08e-3, 2.5e-6}},
                                   {0.1e-6, {0.25e-3, 2.5e-6}},
                                   {2e-6, {0.8e-3, 2.5e-6}},
                                   {10e-6, {2.5e-3, 8e-6}},
                                   {std::numeric_limits<double>::infinity(), {8e-3, 25e-6}}}};

}  // namespace

ProfileSetting default_setting(double Ra) {
    if (!(Ra >= 0.0)) throw InvalidArgument(fmt::format("Ra is {} m, expected a number >= 0", Ra));
    auto row = rows.begin();
    while (Ra > row->largest_Ra) ++row;
    return row->setting;
}

ProfileSetting default_setting(const MeasurementView& line, parallel::Threads threads) {
    require_line(line);
    const auto name = topography::label(line.metadata());
    const auto* scan = line.as<topography::LineScan>();
    if (!scan)
        throw InvalidArgument(
            name +
            ": filters need equal steps, and this is a polyline; resample it, or compute parameters without "
            "filters");
    std::optional<ProfileSetting> last;
    for (const auto& row : rows) {
        if (row.setting.section_length > scan->size * 1.01) break;
        last = row.setting;
        const auto roughness =
            filtered(line, {.l_filter = row.setting.section_length}, ProfileKind::roughness, threads);
        if (height_parameters(*roughness, threads).Sa <= row.largest_Ra) break;
    }
    if (!last)
        throw InvalidArgument(
            fmt::format("{}: its {} are shorter than the smallest section of the standards, {}; give filters and the "
                        "length of a section",
                        name, format_value(scan->size, "m"), format_value(rows.front().setting.section_length, "m")));
    return *last;
}

}  // namespace setae::texture
