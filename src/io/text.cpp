// SPDX-License-Identifier: GPL-3.0-or-later
#include "text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <map>

#include "setae/core/constants.hpp"
#include "setae/core/text.hpp"
#include "setae/io/format.hpp"

namespace setae::io {
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
        const std::size_t length = lead < 0x80 ? 1 : lead >= 0xc2 && lead < 0xe0 ? 2 : (lead & 0xf0) == 0xe0 ? 3 : lead >= 0xf0 && lead < 0xf5 ? 4 : 0;
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
    else if (encoding == Encoding::utf16)
        text = from_utf16(bytes, false);
    else if (bytes.starts_with(utf8_mark))
        text = bytes.substr(3);
    else if (encoding == Encoding::latin1 || (encoding == Encoding::detect && !is_utf8(bytes)))
        text = from_latin1(bytes);
    else
        text = std::move(bytes);
    if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
    return text;
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

bool parse_cell(std::string_view cell, char decimal_point, double& value) {
    while (!cell.empty() && is_blank(cell.front())) cell.remove_prefix(1);
    while (!cell.empty() && is_blank(cell.back())) cell.remove_suffix(1);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    value = undefined;
    if (cell.empty()) return true;
    std::array<char, 64> copy{};
    if (decimal_point == ',') {
        if (cell.size() >= copy.size() || cell.find('.') != std::string_view::npos) return false;
        std::replace_copy(cell.begin(), cell.end(), copy.begin(), ',', '.');
        cell = {copy.data(), cell.size()};
    }
    auto digits = cell;
    if (digits.front() == '+') digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = end == digits.data() + digits.size();
    if (error == std::errc{} && whole) return true;
    if (error == std::errc::result_out_of_range && whole) {  // 1e-400 is 0, 1e400 infinite
        value = std::strtod(std::string(digits).c_str(), nullptr);
        return true;
    }
    value = undefined;
    if (cell.find_first_not_of('*') == std::string_view::npos) return true;  // a field too narrow for its number
    static constexpr std::array<std::string_view, 11> undefined_words{"nan",      "bad",       "-",         "--",       "---",      "infinite",
                                                                       "1.#qnan",  "-1.#ind",   "1.#ind",    "1.#inf",   "-1.#inf"};
    return std::find(undefined_words.begin(), undefined_words.end(), lowered(cell)) != undefined_words.end();
}

bool is_grouped(std::string_view cell, char group_sign, bool whole) {
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    if (!cell.empty() && (cell.front() == '-' || cell.front() == '+')) cell.remove_prefix(1);
    const auto digits = [&](std::size_t from) {
        std::size_t count = 0;
        while (from + count < cell.size() && cell[from + count] >= '0' && cell[from + count] <= '9') ++count;
        return count;
    };
    auto at = digits(0);
    if (at < 1 || at > 3 || cell.front() == '0') return false;
    std::size_t groups = 0;
    for (; at < cell.size() && cell[at] == group_sign; at += 4, ++groups)
        if (digits(at + 1) != 3) return false;
    return groups > 0 && (at == cell.size() || !whole);
}

bool parse_cell(std::string_view cell, const Dialect& dialect, double& value) {
    const char sign = dialect.decimal_point == '.' ? ',' : '.';
    cell = trimmed(cell);
    if (!dialect.grouped || !is_grouped(cell, sign, false)) return parse_cell(cell, dialect.decimal_point, value);
    std::string plain(cell);
    std::erase(plain, sign);
    return parse_cell(plain, dialect.decimal_point, value);
}

void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    cells.clear();
    if (separator == ' ') {
        for (std::size_t i = 0; i < line.size();) {
            while (i < line.size() && is_blank(line[i])) ++i;
            const auto first = i;
            while (i < line.size() && !is_blank(line[i])) ++i;
            if (i > first) cells.push_back(line.substr(first, i - first));
        }
        return;
    }
    for (;;) {
        const auto end = line.find(separator);
        cells.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos) return;
        line.remove_prefix(end + 1);
    }
}

namespace {

/// Number of cells where a line is a row of numbers, else 0.
std::size_t row_cells(std::string_view line, const Dialect& dialect, std::vector<std::string_view>& cells) {
    split_cells(line, dialect.separator, cells);
    bool any_number = false;
    for (const auto cell : cells) {
        double value = 0.0;
        if (!parse_cell(cell, dialect, value)) return 0;
        any_number |= value == value;
    }
    return any_number ? cells.size() : 0;
}

/// Rows of the most frequent number of cells, and that number.
struct Score {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::size_t filled = 0;  ///< of all rows, columns up to the last that holds anything
};

Score score(const std::vector<std::string_view>& lines, const Dialect& dialect) {
    constexpr std::size_t sample = 100;
    std::map<std::size_t, std::size_t> counts;
    std::vector<std::string_view> cells;
    std::size_t seen = 0, filled = 0;
    for (auto line = lines.rbegin(); line != lines.rend() && seen < sample; ++line) {
        if (trimmed(*line).empty()) continue;
        ++seen;
        const auto columns = row_cells(*line, dialect, cells);
        if (columns == 0) continue;
        ++counts[columns];
        while (cells.back().empty()) cells.pop_back();
        filled = std::max(filled, cells.size());
    }
    Score best;
    for (const auto& [columns, rows] : counts)
        if (rows > best.rows || (rows == best.rows && columns > best.columns)) best = {rows, columns, std::min(filled, columns)};
    return best;
}

/// Better: more rows, where several columns count twice: a short row among integers at commas makes no decimal commas.
bool better(const Score& a, const Score& b) {
    const auto weight = [](const Score& score) { return score.rows * (score.columns > 1 ? 2 : 1); };
    return weight(a) > weight(b);
}

constexpr std::array<Dialect, 13> dialects{{{'\t', '.'}, {';', '.'}, {',', '.'}, {' ', '.'}, {'\t', ','}, {';', ','}, {' ', ','},
                                            {'\t', '.', true}, {';', '.', true}, {' ', '.', true}, {'\t', ',', true}, {';', ',', true}, {' ', ',', true}}};

bool allowed(const Dialect& dialect, const TableOptions& options) {
    return (!options.separator || *options.separator == dialect.separator) &&
           (!options.decimal_point || *options.decimal_point == dialect.decimal_point);
}

/// Rows of equal length with numbers in the same columns.
struct WordScore {
    std::size_t rows = 0, columns = 0, numeric = 0;
    std::vector<bool> text;
};

bool is_defined_number(std::string_view cell, const Dialect& dialect) {
    double value = undefined;
    return parse_cell(cell, dialect, value) && value == value;
}

bool numbers_fit(const std::vector<std::string_view>& cells, const WordScore& score, const Dialect& dialect) {
    double value = 0.0;
    bool any = false;
    if (cells.size() != score.columns) return false;
    for (std::size_t k = 0; k < cells.size(); ++k)
        if (!score.text[k]) {
            if (!parse_cell(cells[k], dialect, value)) return false;
            any |= value == value;
        }
    return any;
}

WordScore score_with_words(const std::vector<std::string_view>& lines, const Dialect& dialect) {
    constexpr std::size_t sample = 100;
    std::map<std::size_t, std::vector<std::size_t>> numbers;  // by number of cells: numbers in each column, then rows
    std::vector<std::vector<std::string_view>> seen;
    for (auto line = lines.rbegin(); line != lines.rend() && seen.size() < sample; ++line) {
        if (trimmed(*line).empty()) continue;
        auto& cells = seen.emplace_back();
        split_cells(*line, dialect.separator, cells);
        auto& counts = numbers.try_emplace(cells.size(), cells.size() + 1, 0).first->second;
        for (std::size_t k = 0; k < cells.size(); ++k) counts[k] += is_defined_number(cells[k], dialect) ? 1 : 0;
        ++counts.back();
    }
    WordScore best;
    for (const auto& [columns, counts] : numbers) {
        WordScore score{0, columns, 0, std::vector<bool>(columns)};
        for (std::size_t k = 0; k < columns; ++k) {
            score.text[k] = 2 * counts[k] < counts.back();
            score.numeric += score.text[k] ? 0 : 1;
        }
        if (columns < 2 || score.numeric == 0) continue;
        for (const auto& cells : seen) score.rows += numbers_fit(cells, score, dialect) ? 1 : 0;
        if (score.rows > best.rows) best = score;
    }
    return best;
}

}  // namespace

std::optional<Layout> find_layout_with_words(const std::vector<std::string_view>& lines, const TableOptions& options) {
    WordScore best;
    Layout layout;
    for (const auto& dialect : dialects) {
        if (!allowed(dialect, options)) continue;
        auto candidate = score_with_words(lines, dialect);
        // words hold blanks and commas themselves: among equals the separator tried first, and its decimal sign that gives more numbers
        const bool more_numbers = candidate.numeric > best.numeric && (best.rows == 0 || dialect.separator == layout.dialect.separator);
        if (candidate.rows < best.rows || (candidate.rows == best.rows && !more_numbers)) continue;
        best = std::move(candidate);
        layout.dialect = dialect;
    }
    if (best.rows < 2) return std::nullopt;
    layout.columns = layout.filled = best.columns;
    layout.text = best.text;
    std::vector<std::string_view> cells;
    for (;; ++layout.first_row) {
        split_cells(lines[layout.first_row], layout.dialect.separator, cells);
        if (numbers_fit(cells, best, layout.dialect)) return layout;
    }
}

std::optional<Layout> find_layout(const std::vector<std::string_view>& lines, const TableOptions& options) {
    Layout layout;
    Score best;
    for (const auto& dialect : dialects) {
        if (!allowed(dialect, options)) continue;
        const auto candidate = score(lines, dialect);
        if (candidate.rows == 0 || !better(candidate, best)) continue;
        best = candidate;
        layout.dialect = dialect;
    }
    if (best.rows == 0) return std::nullopt;
    layout.columns = best.columns;
    layout.filled = best.filled;
    std::vector<std::string_view> cells;
    while (row_cells(lines[layout.first_row], layout.dialect, cells) != layout.columns) ++layout.first_row;
    return layout;
}

std::size_t numeric_columns(std::string_view head) {
    if (!looks_like_text(head)) return 0;
    auto text = decoded(std::string(head), Encoding::detect);
    if (head.size() == detection_bytes) text.resize(std::max<std::size_t>(text.rfind('\n') + 1, 1));
    const auto layout = find_layout(split_lines(text), {});
    return layout ? layout->filled : 0;
}

std::vector<std::string> header_cells(std::string_view line, char separator, std::size_t least, std::size_t most) {
    line = trimmed(line);
    while (!line.empty() && (line.front() == '#' || line.front() == '%')) line = trimmed(line.substr(1));
    std::vector<std::string_view> cells;
    for (const char candidate : {separator, '\t', ';', ',', ' '}) {
        split_cells(line, candidate, cells);
        std::vector<std::string> named;
        for (auto cell : cells) {
            if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
            const bool unit_of_previous = candidate == ' ' && !named.empty() && (cell.starts_with('[') || cell.starts_with('('));
            if (unit_of_previous && named.back().back() != ']' && named.back().back() != ')')
                named.back() += " " + std::string(cell);
            else
                named.emplace_back(cell);
        }
        while (named.size() > least && named.back().empty()) named.pop_back();
        if (named.size() >= least && named.size() <= most && !named.front().empty()) return named;
    }
    return {};
}

}  // namespace setae::io
