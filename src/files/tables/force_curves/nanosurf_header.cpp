// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/nanosurf_header.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/text_head.hpp"

namespace setae::tables {
namespace {

constexpr std::size_t max_channels_of_nanosurf = 1000;

std::optional<NanosurfChannel> channel_of_key(const std::string& key, const std::string& section) {
    if (!key.starts_with("Gr")) return std::nullopt;
    auto rest = std::string_view(key).substr(2);
    const auto group = leading<std::uint32_t>(rest);
    if (!group || !rest.starts_with("-Ch")) return std::nullopt;
    const auto channel = spelled<std::uint32_t>(rest.substr(3));
    return channel ? std::optional(NanosurfChannel{*group, *channel, section}) : std::nullopt;
}

}  // namespace

bool is_nanosurf(std::string_view head) {
    if (!head.starts_with(first_nanosurf_line)) return false;
    const auto rest = head.substr(first_nanosurf_line.size());
    return rest.starts_with('\r') || rest.starts_with('\n');
}

std::string text_entry(const TextSection& section, std::string_view key) {
    const auto found = section.find(key);
    return found == section.end() ? std::string() : found->second;
}

std::string nanosurf_head(const bytes::Source& source) { return head_until(source, last_nanosurf_line, "Nanosurf"); }

TextSections nanosurf_sections(const std::string& head) {
    TextSections sections;
    TextSection* current = nullptr;
    const auto text = bytes::decoded(head, bytes::Encoding::detect);
    for (const auto raw : bytes::split_lines(text)) {
        const auto line = trimmed(raw);
        const auto equals = line.find('=');
        if (line.starts_with('[') && line.ends_with(']'))
            current = &sections[std::string(line.substr(1, line.size() - 2))];
        else if (current && equals != std::string_view::npos && !line.starts_with("--"))
            current->insert_or_assign(std::string(trimmed(line.substr(0, equals))),
                                      std::string(trimmed(line.substr(equals + 1))));
    }
    return sections;
}

std::vector<NanosurfChannel> nanosurf_channels(const TextSections& sections, const bytes::Source& source) {
    std::vector<NanosurfChannel> found;
    const auto dataset = sections.find("DataSet");
    if (dataset == sections.end()) return found;
    for (const auto& [key, value] : dataset->second)
        if (const auto channel = channel_of_key(key, value)) found.push_back(*channel);
    if (found.size() > max_channels_of_nanosurf)
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("Nanosurf: {} channels, expected at most {}; it is damaged", found.size(),
                                      max_channels_of_nanosurf));
    std::sort(found.begin(), found.end(), [](const NanosurfChannel& a, const NanosurfChannel& b) {
        return std::pair{a.group, a.channel} < std::pair{b.group, b.channel};
    });
    return found;
}

NanosurfIntegers nanosurf_integers(const TextSection& section, const bytes::Source& source) {
    const auto refuse = [&](const std::string& what) {
        throw FormatError(source.name, {.offset = 0}, "Nanosurf: " + what);
    };
    if (const auto mode = text_entry(section, "SaveMode"); mode != "Binary")
        refuse(fmt::format("a channel saved as '{:.40}', expected 'Binary'", mode));
    const auto bits = text_entry(section, "SaveBits"), sign = text_entry(section, "SaveSign"),
               order = text_entry(section, "SaveOrder");
    if ((bits != "8" && bits != "16" && bits != "32") || (sign != "Signed" && sign != "Unsigned") ||
        (order != "Intel" && order != "Motorola"))
        refuse(fmt::format(
            "integers of '{:.10}' bits, '{:.10}', order '{:.10}', expected 8, 16 or 32, Signed or Unsigned, Intel or Motorola",
            bits, sign, order));
    NanosurfIntegers stored{.bits = bits == "8"    ? 8
                                    : bits == "16" ? 16
                                                   : 32,
                            .is_signed = sign == "Signed",
                            .big_endian = order == "Motorola",
                            .points = header_count(text_entry(section, "Points"), "Points", source, "Nanosurf"),
                            .lines = header_count(text_entry(section, "Lines"), "Lines", source, "Nanosurf")};
    const double range = header_number(text_entry(section, "Dim2Range"), "Dim2Range", source, "Nanosurf"),
                 least = header_number(text_entry(section, "Dim2Min"), "Dim2Min", source, "Nanosurf");
    stored.factor = std::ldexp(range, -stored.bits);
    stored.offset = least + (stored.is_signed ? 0.5 * range : 0.0);
    return stored;
}

}  // namespace setae::tables
