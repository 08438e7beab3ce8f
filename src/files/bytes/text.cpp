// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>

#include "setae/core/constants.hpp"

namespace setae::bytes {
namespace {

void append_utf8(std::string& text, std::uint32_t code) {
    const auto tail = [&](int shift) { text += static_cast<char>(0x80u | ((code >> shift) & 0x3fu)); };
    if (code < 0x80) {
        text += static_cast<char>(code);
    } else if (code < 0x800) {
        text += static_cast<char>(0xc0u | (code >> 6));
        tail(0);
    } else if (code < 0x10000) {
        text += static_cast<char>(0xe0u | (code >> 12));
        tail(6);
        tail(0);
    } else {
        text += static_cast<char>(0xf0u | (code >> 18));
        tail(12);
        tail(6);
        tail(0);
    }
}

std::string from_latin1(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 16);
    for (const char c : bytes) append_utf8(text, static_cast<unsigned char>(c));
    return text;
}

std::string from_utf16(std::string_view bytes, bool big_endian) {
    constexpr std::uint32_t replacement = 0xfffd;
    const auto unit = [&](std::size_t i) {
        const auto first = static_cast<unsigned char>(bytes[i]), second = static_cast<unsigned char>(bytes[i + 1]);
        return big_endian ? first * 256u + second : second * 256u + first;
    };
    std::string text;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        std::uint32_t code = unit(i);
        if (code >= 0xd800 && code < 0xdc00 && i + 3 < bytes.size()) {
            const std::uint32_t low = unit(i + 2);
            const bool pair = low >= 0xdc00 && low < 0xe000;
            code = pair ? 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00) : replacement;
            if (pair) i += 2;
        } else if (code >= 0xd800 && code < 0xe000) {
            code = replacement;
        }
        append_utf8(text, code);
    }
    return text;
}

bool is_utf8(std::string_view bytes) {
    for (std::size_t i = 0; i < bytes.size();) {
        const auto lead = static_cast<unsigned char>(bytes[i]);
        const std::size_t length = lead < 0x80                   ? 1
                                   : lead >= 0xc2 && lead < 0xe0 ? 2
                                   : (lead & 0xf0) == 0xe0       ? 3
                                   : lead >= 0xf0 && lead < 0xf5 ? 4
                                                                 : 0;
        if (length == 0 || i + length > bytes.size()) return false;
        for (std::size_t k = 1; k < length; ++k)
            if ((static_cast<unsigned char>(bytes[i + k]) & 0xc0) != 0x80) return false;
        i += length;
    }
    return true;
}

constexpr std::string_view utf8_mark = "\xef\xbb\xbf", utf16_little = "\xff\xfe", utf16_big = "\xfe\xff";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

std::string decoded(std::string bytes, Encoding encoding) {
    std::string text;
    if (bytes.starts_with(utf16_little) || bytes.starts_with(utf16_big))
        text = from_utf16(std::string_view(bytes).substr(2), bytes.starts_with(utf16_big));
    else if (encoding == Encoding::utf16) text = from_utf16(bytes, false);
    else if (bytes.starts_with(utf8_mark)) text = bytes.substr(3);
    else if (encoding == Encoding::latin1 || (encoding == Encoding::detect && !is_utf8(bytes)))
        text = from_latin1(bytes);
    else text = std::move(bytes);
    if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
    return text;
}

std::string field_text(std::string_view bytes) {
    return decoded(std::string(bytes.substr(0, bytes.find('\0'))), Encoding::detect);
}

std::string utf16_field_text(std::string_view bytes, bool big_endian) {
    std::size_t end = 0;
    while (end + 1 < bytes.size() && (bytes[end] != '\0' || bytes[end + 1] != '\0')) end += 2;
    return from_utf16(bytes.substr(0, end), big_endian);
}

bool looks_like_text(std::string_view bytes) {
    if (bytes.starts_with(utf16_little) || bytes.starts_with(utf16_big)) return true;
    return std::all_of(bytes.begin(), bytes.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 0x20 || byte == '\t' || byte == '\n' || byte == '\r' || byte == '\f' || byte == 0x1a;
    });
}

std::string lowered(std::string_view text) {
    std::string result(text);
    for (auto& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

std::vector<std::string_view> split_lines(std::string_view text) {
    std::vector<std::string_view> lines;
    lines.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1);
    while (!text.empty()) {
        const auto end = text.find('\n');
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

namespace {

std::string_view without_blanks(std::string_view cell) {
    while (!cell.empty() && is_blank(cell.front())) cell.remove_prefix(1);
    while (!cell.empty() && is_blank(cell.back())) cell.remove_suffix(1);
    return cell;
}

/// Whether a cell is a word for a missing value, including errors of spreadsheets.
bool is_undefined_word(std::string_view cell) {
    if (cell.find_first_not_of('*') == std::string_view::npos) return true;  // a field too narrow for its number
    static constexpr std::array<std::string_view, 30> words{
        "nan",    "bad",   "na",        "n/a",     "n.a.",  "null",   "nil",     "none",     "void",     "missing",
        "masked", "undef", "undefined", "invalid", "-",     "--",     "---",     "infinite", "qnan",     "snan",
        "#n/a",   "#na",   "#nv",       "#n/d",    "#num!", "#zahl!", "#value!", "#wert!",   "#valeur!", "#div/0!"};
    constexpr auto longest = std::ranges::max(words, {}, &std::string_view::size).size();
    // "1.#QNAN", "-1.#IND", with a decimal comma "1,#INF"
    static constexpr std::array<std::string_view, 5> kinds{"#qnan", "#snan", "#ind", "#inf", "#nan"};
    if (cell.size() > longest) return false;
    const auto word = lowered(cell);
    if (std::find(words.begin(), words.end(), word) != words.end()) return true;
    auto kind = std::string_view(word);
    if (kind.starts_with('-') || kind.starts_with('+')) kind.remove_prefix(1);
    return (kind.starts_with("1.") || kind.starts_with("1,")) &&
           std::find(kinds.begin(), kinds.end(), kind.substr(2)) != kinds.end();
}

/// The number of a cell with a decimal point.
bool parse_number(std::string_view cell, double& value) {
    auto digits = cell;
    if (digits.front() == '+') digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (end != digits.data() + digits.size()) return false;
    if (error == std::errc{}) return true;
    if (error != std::errc::result_out_of_range) return false;
    value = std::strtod(std::string(digits).c_str(), nullptr);  // 1e-400 is 0, 1e400 infinite
    return true;
}

}  // namespace

bool parse_cell(std::string_view cell, char decimal_point, double& value) {
    cell = without_blanks(cell);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
        cell = without_blanks(cell.substr(1, cell.size() - 2));
    value = undefined;
    if (cell.empty()) return true;
    std::array<char, 64> copy{};
    if (decimal_point == '.') {
        if (parse_number(cell, value)) return true;
    } else if (cell.size() < copy.size() && cell.find('.') == std::string_view::npos) {
        std::replace_copy(cell.begin(), cell.end(), copy.begin(), ',', '.');
        if (parse_number({copy.data(), cell.size()}, value)) return true;
    }
    value = undefined;
    return is_undefined_word(cell);
}

}  // namespace setae::bytes
