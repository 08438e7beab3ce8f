// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/channel_lines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/units.hpp"

namespace setae::cli {
namespace {

bool is_needed(const std::string& what) { return what == "size" || what == "unit"; }

std::string missing_words(const formats::ChannelInfo& info) {
    const auto names = formats::missing(info);
    std::vector<std::string> options;
    for (const auto& name : names)
        if (is_needed(name)) options.push_back("--" + name);
    if (names.empty()) return {};
    return fmt::format("MISSING {}{}", fmt::join(names, ", "),
                       options.empty() ? "" : fmt::format(" (give {})", fmt::join(options, ", ")));
}

}  // namespace

std::string channel_line(const formats::ChannelInfo& info) {
    const auto name = info.name.empty() ? "(no name)" : info.name;
    if (info.shape.empty()) return fmt::format("{}: {}", info.format.empty() ? "unreadable" : info.format, name);
    std::vector<std::string> sizes;
    for (const double size : info.size) sizes.push_back(format_value(size, "m"));
    return fmt::format("{}: {}, {} points{}{}", info.format, name, fmt::join(info.shape, " × "),
                       sizes.empty() ? "" : fmt::format(", {}", fmt::join(sizes, " × ")),
                       info.unit.empty() ? "" : ", in " + info.unit);
}

std::string channel_remarks(const formats::ChannelInfo& info) {
    std::string line;
    const auto& instrument = info.metadata.instrument;
    for (const auto& text : {info.orientation, instrument.name.empty() ? instrument.type : instrument.name,
                             info.metadata.acquisition_time})
        if (!text.empty()) line += ", " + text;
    if (const auto words = missing_words(info); info.is_height && !words.empty()) line += ", " + words;
    return line;
}

std::string percent(double share) {
    if (share > 0.0 && share < 1e-4) return "< 0.01 %";
    return fmt::format("{:.2g} %", 100.0 * share);
}

}  // namespace setae::cli
