// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/nesting.hpp"

#include <algorithm>
#include <cctype>

namespace setae::bytes {
namespace {

bool opens(char c) { return c == '[' || c == '{'; }
bool closes(char c) { return c == ']' || c == '}'; }

/// Place after the quoted text that begins at `at`; the end if it is not closed.
std::size_t end_of_quotes(std::string_view text, std::size_t at, bool escapes) {
    const char quote = text[at];
    for (++at; at < text.size() && text[at] != quote && text[at] != '\n'; ++at)
        if (escapes && text[at] == '\\') ++at;
    return std::min(at + 1, text.size());
}

/// Place after the part that begins at `at` with `first` and ends with `last`.
std::size_t end_of(std::string_view text, std::size_t at, std::string_view last) {
    const auto end = text.find(last, at);
    return end == std::string_view::npos ? text.size() : end + last.size();
}

bool in_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '"' || c == '\'';
}

}  // namespace

std::optional<std::uint64_t> json_too_deep(std::string_view text) {
    std::size_t depth = 0;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '"') {
            at = end_of_quotes(text, at, true);
            continue;
        }
        if (opens(c) && ++depth > max_levels) return at;
        if (closes(c) && depth > 0) --depth;
        ++at;
    }
    return std::nullopt;
}

std::optional<std::uint64_t> xml_too_deep(std::string_view text) {
    std::size_t depth = 0;
    for (auto at = text.find('<'); at != std::string_view::npos && at + 1 < text.size(); at = text.find('<', at)) {
        const auto rest = text.substr(at);
        if (rest.starts_with("<!--")) at = end_of(text, at, "-->");
        else if (rest.starts_with("<![CDATA[")) at = end_of(text, at, "]]>");
        else if (rest[1] == '?' || rest[1] == '!') at = end_of(text, at, ">");
        else {
            const auto end = end_of(text, at, ">");
            const bool empty = end >= 2 && text[end - 1] == '>' && text[end - 2] == '/';
            if (rest[1] == '/') depth -= depth > 0 ? 1 : 0;
            else if (!empty && ++depth > max_levels) return at;
            at = end;
        }
    }
    return std::nullopt;
}

std::optional<std::uint64_t> toml_too_deep(std::string_view text) {
    std::size_t depth = 0, dots = 0;
    char last = ' ';  // before blanks
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '#') {
            at = std::min(text.find('\n', at), text.size());
        } else if (text.substr(at).starts_with("\"\"\"") || text.substr(at).starts_with("'''")) {
            at = end_of(text, at + 3, text.substr(at, 3));
        } else if (c == '"' || c == '\'') {
            at = end_of_quotes(text, at, c == '"');
            last = c;
        } else {
            const bool parts_name = c == '.' && in_name(last);
            if (parts_name && ++dots > max_levels) return at;
            if (!parts_name && !in_name(c) && c != ' ' && c != '\t') dots = 0;
            if (opens(c) && ++depth > max_levels) return at;
            if (closes(c) && depth > 0) --depth;
            if (c != ' ' && c != '\t') last = c;
            ++at;
        }
    }
    return std::nullopt;
}

}  // namespace setae::bytes
