// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/channel_lines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/units.hpp"

namespace setae::cli {

std::string channel_line(const formats::ChannelInfo& info) {
    const auto name = info.name.empty() ? "(no name)" : info.name;
    if (info.shape.empty()) return fmt::format("{}: {}", info.format.empty() ? "unreadable" : info.format, name);
    std::vector<std::string> sizes;
    for (const double size : info.size) sizes.push_back(format_value(size, "m"));
    return fmt::format("{}: {}, {} points{}{}", info.format, name, fmt::join(info.shape, " × "),
                       sizes.empty() ? "" : fmt::format(", {}", fmt::join(sizes, " × ")),
                       info.unit.empty() ? "" : ", in " + info.unit);
}

std::string percent(double share) {
    if (share > 0.0 && share < 1e-4) return "< 0.01 %";
    return fmt::format("{:.2g} %", 100.0 * share);
}

}  // namespace setae::cli
