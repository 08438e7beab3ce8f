// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/dialect.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "setae/bytes/source.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/text.hpp"

namespace setae::tables {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

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
    std::size_t seen = 0;    ///< lines looked at

    /// No other reading of the same lines is better.
    [[nodiscard]] bool perfect() const { return columns > 1 && rows == seen; }
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
        if (rows > best.rows || (rows == best.rows && columns > best.columns))
            best = {rows, columns, std::min(filled, columns), seen};
    return best;
}

/// Better: more rows, where several columns count twice: a short row among integers at commas makes no decimal commas.
bool better(const Score& a, const Score& b) {
    const auto weight = [](const Score& score) { return score.rows * (score.columns > 1 ? 2 : 1); };
    return weight(a) > weight(b);
}

constexpr std::array<Dialect, 13> dialects{{{'\t', '.'},
                                            {';', '.'},
                                            {',', '.'},
                                            {' ', '.'},
                                            {'\t', ','},
                                            {';', ','},
                                            {' ', ','},
                                            {'\t', '.', true},
                                            {';', '.', true},
                                            {' ', '.', true},
                                            {'\t', ',', true},
                                            {';', ',', true},
                                            {' ', ',', true}}};

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
        // words hold blanks and commas themselves: among equals the separator tried first, and its decimal sign that
        // gives more numbers
        const bool more_numbers =
            candidate.numeric > best.numeric && (best.rows == 0 || dialect.separator == layout.dialect.separator);
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
        if (best.perfect()) break;
    }
    if (best.rows == 0) return std::nullopt;
    layout.columns = best.columns;
    layout.filled = best.filled;
    std::vector<std::string_view> cells;
    while (row_cells(lines[layout.first_row], layout.dialect, cells) != layout.columns) ++layout.first_row;
    return layout;
}

std::size_t numeric_columns(std::string_view head) {
    if (!bytes::looks_like_text(head)) return 0;
    auto text = bytes::decoded(std::string(head), bytes::Encoding::detect);
    if (head.size() == bytes::detection_bytes) text.resize(std::max<std::size_t>(text.rfind('\n') + 1, 1));
    const auto layout = find_layout(bytes::split_lines(text), {});
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
            const bool unit_of_previous =
                candidate == ' ' && !named.empty() && (cell.starts_with('[') || cell.starts_with('('));
            if (unit_of_previous && !named.back().ends_with(']') && !named.back().ends_with(')'))
                named.back() += " " + std::string(cell);
            else named.emplace_back(cell);
        }
        while (named.size() > least && named.back().empty()) named.pop_back();
        if (named.size() >= least && named.size() <= most && !named.front().empty()) return named;
    }
    return {};
}

}  // namespace setae::tables
