// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/text_head.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"

namespace setae::tables {

std::string head_until(const bytes::Source& source, std::string_view marker, const std::string& format) {
    constexpr std::uint64_t piece = 1 << 16;
    const auto most = std::min(source.size, longest_text_head);
    std::string head;
    while (head.size() < most) {
        const auto searched = head.size() - std::min(head.size(), marker.size());
        head += source.bytes(head.size(), std::min(piece, most - head.size()));
        if (const auto found = head.find(marker, searched); found != std::string::npos) return head.substr(0, found);
    }
    throw FormatError(source.name, {.offset = most},
                      fmt::format("{}: the header does not end with '{}' before this; the file is truncated or damaged",
                                  format, trimmed(marker)));
}

double header_number(std::string_view text, std::string_view key, const bytes::Source& source,
                     const std::string& format) {
    double value = 0.0;
    if (!bytes::parse_cell(trimmed(text), '.', value) || !std::isfinite(value))
        throw FormatError(
            source.name, {.offset = 0},
            fmt::format("{}: '{}' is '{:.40}' in the header that begins here, expected a number", format, key, text));
    return value;
}

std::uint64_t header_count(std::string_view text, std::string_view key, const bytes::Source& source,
                           const std::string& format) {
    auto digits = trimmed(text);
    const auto value = leading<std::uint32_t>(digits).value_or(0);
    if (value == 0 || value > (1u << 31))
        throw FormatError(
            source.name, {.offset = 0},
            fmt::format("{}: '{}' is '{:.40}' in the header that begins here, expected a positive integer", format, key,
                        text));
    return value;
}

}  // namespace setae::tables
