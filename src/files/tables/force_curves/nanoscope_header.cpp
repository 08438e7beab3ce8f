// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/nanoscope_header.hpp"

#include <fmt/format.h>

#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/text_head.hpp"

namespace setae::tables {
namespace {

constexpr std::string_view first_line_of_images = "\\*File list", first_line_of_curves = "\\*Force file list",
                           last_line_of_header = "\\*File list end";

std::string normalised_key(std::string_view key) {
    if (key.starts_with('@')) key.remove_prefix(1);
    if (key.size() > 2 && key[0] >= '0' && key[0] <= '9' && key[1] == ':') key.remove_prefix(2);
    return bytes::lowered(trimmed(key));
}

/// "@2:Z scale: V …" has its colon after the group number.
std::size_t colon_after_key(std::string_view line) {
    const bool grouped = line.size() > 2 && line[0] == '@' && line[2] == ':';
    return line.find(':', grouped ? 3 : 0);
}

}  // namespace

bool is_nanoscope(std::string_view head) {
    return head.starts_with(first_line_of_images) || head.starts_with(first_line_of_curves);
}

std::vector<NanoscopeSection> nanoscope_sections(const bytes::Source& source) {
    const auto text = bytes::decoded(head_until(source, last_line_of_header, "Nanoscope"), bytes::Encoding::latin1);
    std::vector<NanoscopeSection> sections;
    for (const auto raw : bytes::split_lines(text)) {
        auto line = trimmed(raw);
        if (line.starts_with("\\*")) {
            sections.push_back({bytes::lowered(line.substr(2)), {}});
        } else if (line.starts_with('\\') && !sections.empty()) {
            line.remove_prefix(1);
            const auto colon = colon_after_key(line);
            if (colon != std::string_view::npos)
                sections.back().entries.emplace_back(normalised_key(line.substr(0, colon)),
                                                     trimmed(line.substr(colon + 1)));
        }
    }
    return sections;
}

const std::string* find(const NanoscopeSection& section, std::string_view key) {
    for (const auto& [name, value] : section.entries)
        if (name == key) return &value;
    return nullptr;
}

const std::string* find(const std::vector<NanoscopeSection>& sections, std::string_view key) {
    for (const auto& section : sections) {
        if (section.name.ends_with("image list")) continue;
        if (const auto* value = find(section, key)) return value;
    }
    return nullptr;
}

const NanoscopeSection* section_named(const std::vector<NanoscopeSection>& sections, std::string_view name) {
    for (const auto& section : sections)
        if (section.name == name) return &section;
    return nullptr;
}

std::uint64_t nanoscope_integer(const NanoscopeSection& section, std::string_view key, const bytes::Source& source) {
    const auto* text = find(section, key);
    if (!text) throw FormatError(source.name, {}, fmt::format("Nanoscope: image without '{}' in the header", key));
    std::string_view digits = *text;
    const auto value = leading<std::uint64_t>(digits).value_or(0);
    if (value == 0 || value > (std::uint64_t{1} << 40))
        throw FormatError(source.name, {},
                          fmt::format("Nanoscope: '{}' is '{:.40}', expected a positive integer", key, *text));
    return value;
}

std::optional<NanoscopeValue> leading_value(std::string_view text) {
    text = trimmed(text);
    const auto number = leading<double>(text);
    if (!number) return std::nullopt;
    return NanoscopeValue{*number, std::string(trimmed(text))};
}

NanoscopeScale nanoscope_scale(const std::string& text) {
    NanoscopeScale scale;
    const std::string_view view = text;
    const auto open = view.find('['), shut = view.find(']');
    if (open != std::string_view::npos && shut != std::string_view::npos && shut > open + 1)
        scale.sensitivity = view.substr(open + 1, shut - open - 1);
    const auto begin = view.rfind('('), close = view.rfind(')');
    if (close == std::string_view::npos) return scale;
    scale.range = leading_value(view.substr(close + 1));
    if (begin != std::string_view::npos && begin < close)
        scale.step = leading_value(view.substr(begin + 1, close - begin - 1));
    return scale;
}

std::optional<NanoscopeValue> soft_sensitivity(const std::vector<NanoscopeSection>& sections, const std::string& name) {
    const auto* entry = find(sections, bytes::lowered(name));
    return entry && entry->starts_with("V ") ? leading_value(std::string_view(*entry).substr(2)) : std::nullopt;
}

std::string plain_unit(std::string_view unit) {
    const auto text = trimmed(unit);
    if (text == "°" || text == "º") return "deg";
    return text == "~m" ? "um" : std::string(text);
}

}  // namespace setae::tables
