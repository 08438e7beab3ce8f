// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/dialect.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "setae/bytes/source.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/text.hpp"

namespace setae::tables {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view without_quotes(std::string_view cell) {
    return cell.size() >= 2 && cell.front() == '"' && cell.back() == '"' ? trimmed(cell.substr(1, cell.size() - 2))
                                                                         : cell;
}

/// Groups of three digits at the beginning of a number.
struct Groups {
    std::size_t count = 0;
    std::size_t length = 0;  ///< of the text, sign included
};

Groups groups_of(std::string_view number, std::string_view sign) {
    std::size_t at = !number.empty() && (number.front() == '-' || number.front() == '+') ? 1 : 0;
    const auto digits = [&](std::size_t from) {
        std::size_t count = 0;
        while (from + count < number.size() && number[from + count] >= '0' && number[from + count] <= '9') ++count;
        return count;
    };
    const auto first = digits(at);
    if (first < 1 || first > 3 || number[at] == '0') return {};
    at += first;
    Groups groups;
    for (; number.substr(at).starts_with(sign); at += sign.size() + 3, ++groups.count)
        if (digits(at + sign.size()) != 3) return {};
    groups.length = at;
    return groups;
}

/// Signs that group thousands and are no decimal mark: a blank in its three widths, the Swiss apostrophes.
constexpr std::array<std::string_view, 6> plain_group_signs{{" ", "\u00a0", "\u202f", "\u2009", "'", "\u2019"}};

/// A number, without quotes and without the signs between its groups; empty if there are none, or they may be decimal
/// marks.
std::optional<std::string> without_groups(std::string_view cell, const Dialect& dialect) {
    const char other = dialect.decimal_point == '.' ? ',' : '.';
    const auto remove = [&](std::string_view sign, const Groups& groups) {
        std::string plain(cell);
        for (auto at = plain.find(sign); at != std::string::npos && at < groups.length; at = plain.find(sign, at))
            plain.erase(at, sign.size());
        return plain;
    };
    for (const auto sign : plain_group_signs)
        if (const auto groups = groups_of(cell, sign); groups.count > 0) return remove(sign, groups);
    const auto groups = groups_of(cell, {&other, 1});
    const bool decimals = groups.length < cell.size() && cell[groups.length] == dialect.decimal_point;
    if (groups.count > 1 || (groups.count == 1 && (decimals || dialect.grouped))) return remove({&other, 1}, groups);
    return std::nullopt;
}

/// End of the first cell of a text: its separator or the end of the text. Separators in quotes belong to the cell.
std::size_t cell_end(std::string_view text, char separator) {
    std::size_t at = 0;
    while (at < text.size() && text[at] == ' ' && separator != ' ') ++at;
    if (at < text.size() && text[at] == '"') {
        for (auto quote = text.find('"', at + 1); quote != std::string_view::npos; quote = text.find('"', quote + 1)) {
            auto after = quote + 1;
            if (after < text.size() && text[after] == '"') {  // a quote within
                quote = after;
                continue;
            }
            while (after < text.size() && is_blank(text[after]) && text[after] != separator) ++after;
            if (after == text.size() || text[after] == separator || (separator == ' ' && is_blank(text[after])))
                return after;
        }
    }
    at = 0;
    while (at < text.size() && text[at] != separator && !(separator == ' ' && is_blank(text[at]))) ++at;
    return at;
}

}  // namespace

bool is_grouped(std::string_view cell, char group_sign) {
    cell = without_quotes(cell);
    const auto groups = groups_of(cell, {&group_sign, 1});
    return groups.count > 0 && groups.length == cell.size();
}

bool parse_cell(std::string_view cell, const Dialect& dialect, double& value) {
    cell = without_quotes(trimmed(cell));
    const auto plain = dialect.grouped ? without_groups(cell, dialect) : std::nullopt;
    if (parse_cell(plain ? *plain : cell, dialect.decimal_point, value)) return true;
    if (dialect.grouped) return false;
    const auto ungrouped = without_groups(cell, dialect);
    return ungrouped && parse_cell(*ungrouped, dialect.decimal_point, value);
}

bool is_comment(std::string_view line) {
    if (line.empty() || (line.front() != '#' && line.front() != '%')) return false;
    double value = 0.0;
    return line.front() == '%' || line.size() == 1 ||
           !bytes::parse_cell(line.substr(0, line.find_first_of(" \t,;")), '.', value);
}

void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    cells.clear();
    if (separator == ' ') {
        for (std::size_t i = 0; i < line.size();) {
            while (i < line.size() && is_blank(line[i])) ++i;
            if (i == line.size()) return;
            const auto length = cell_end(line.substr(i), ' ');
            cells.push_back(trimmed(line.substr(i, length)));
            i += length;
        }
        return;
    }
    for (;;) {
        const auto end = cell_end(line, separator);
        cells.push_back(trimmed(line.substr(0, end)));
        if (end == line.size()) return;
        line.remove_prefix(end + 1);
    }
}

namespace {

/// Number of cells if a line is a row of numbers, otherwise 0.
std::size_t row_cells(std::string_view line, const Dialect& dialect, std::vector<std::string_view>& cells) {
    split_cells(line, dialect.separator, cells);
    bool any_number = false;
    for (const auto cell : cells) {
        double value = 0.0;
        if (!parse_cell(cell, dialect, value)) return 0;
        any_number |= !std::isnan(value);
    }
    return any_number ? cells.size() : 0;
}

/// Rows of the most frequent number of cells, and that number.
struct Score {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::size_t filled = 0;  ///< of all rows, columns up to the last nonempty one
    std::size_t seen = 0;    ///< examined lines

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

/// Better: more rows, with several columns counted twice: a short row among integers separated by commas is no evidence
/// of decimal commas.
bool better(const Score& a, const Score& b) {
    const auto weight = [](const Score& score) { return score.rows * (score.columns > 1 ? 2 : 1); };
    return weight(a) > weight(b);
}

/// Decimal commas between commas must be in quotes.
constexpr std::array<Dialect, 16> dialects{{{'\t', '.'},
                                            {';', '.'},
                                            {',', '.'},
                                            {' ', '.'},
                                            {'\t', ','},
                                            {';', ','},
                                            {' ', ','},
                                            {',', ','},
                                            {'\t', '.', true},
                                            {';', '.', true},
                                            {',', '.', true},
                                            {' ', '.', true},
                                            {'\t', ',', true},
                                            {';', ',', true},
                                            {',', ',', true},
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
    return parse_cell(cell, dialect, value) && !std::isnan(value);
}

bool numbers_fit(const std::vector<std::string_view>& cells, const WordScore& score, const Dialect& dialect) {
    double value = 0.0;
    bool any = false;
    if (cells.size() != score.columns) return false;
    for (std::size_t k = 0; k < cells.size(); ++k)
        if (!score.text[k]) {
            if (!parse_cell(cells[k], dialect, value)) return false;
            any |= !std::isnan(value);
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

/// Whether a cell of the last lines has decimals that cannot be a group of thousands: the other sign is then the
/// thousands separator.
bool shows_decimals(const std::vector<std::string_view>& lines, const Dialect& dialect) {
    constexpr std::size_t sample = 100;
    std::vector<std::string_view> cells;
    std::size_t seen = 0;
    for (auto line = lines.rbegin(); line != lines.rend() && seen < sample; ++line, ++seen) {
        if (row_cells(*line, dialect, cells) == 0) continue;
        for (const auto cell : cells)
            if (cell.find(dialect.decimal_point) != std::string_view::npos && !is_grouped(cell, dialect.decimal_point))
                return true;
    }
    return false;
}

}  // namespace

std::optional<Layout> find_layout_with_words(const std::vector<std::string_view>& lines, const TableOptions& options) {
    WordScore best;
    Layout layout;
    for (const auto& dialect : dialects) {
        if (!allowed(dialect, options)) continue;
        auto candidate = score_with_words(lines, dialect);
        // words can contain blanks and commas: if equal, the separator tried first, and its decimal sign with more
        // numbers
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
    layout.dialect.grouped |= shows_decimals(lines, layout.dialect);
    std::vector<std::string_view> cells;
    while (row_cells(lines[layout.first_row], layout.dialect, cells) != layout.columns) ++layout.first_row;
    return layout;
}

namespace {

/// The first cell of a line that is no number, if the line begins with a number and two thirds of its cells are
/// numbers, or one of two.
std::optional<BrokenCell> broken_cell(std::string_view line, const Dialect& dialect,
                                      std::vector<std::string_view>& cells) {
    if (is_comment(trimmed(line))) return std::nullopt;
    split_cells(line, dialect.separator, cells);
    std::size_t numbers = 0;
    std::optional<BrokenCell> broken;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        double value = 0.0;
        if (parse_cell(cells[k], dialect, value)) numbers += std::isnan(value) ? 0 : 1;
        else if (!broken) broken = BrokenCell{std::string(cells[k]), 0, k + 1};
    }
    const bool most = cells.size() == 2 ? numbers == 1 : 3 * numbers >= 2 * cells.size();
    return broken && broken->column > 1 && most ? broken : std::nullopt;
}

}  // namespace

std::optional<BrokenCell> broken_row_above(const std::vector<std::string_view>& lines, const Layout& layout) {
    std::optional<BrokenCell> found;
    std::vector<std::string_view> cells;
    for (auto i = layout.first_row; i-- > 0;) {
        if (trimmed(lines[i]).empty()) continue;
        auto broken = broken_cell(lines[i], layout.dialect, cells);
        if (!broken || cells.size() != layout.columns) break;
        broken->line = i + 1;
        found = std::move(broken);
    }
    return found;
}

std::optional<BrokenCell> broken_row_of(const std::vector<std::string_view>& lines) {
    constexpr std::size_t min_lines = 3;
    std::optional<BrokenCell> found;
    std::size_t most = min_lines - 1;
    std::vector<std::string_view> cells;
    for (const auto& dialect : dialects) {
        std::map<std::size_t, std::pair<std::size_t, BrokenCell>>
            by_cells;  // lines of so many cells, the first of them
        for (std::size_t i = 0; i < lines.size(); ++i) {
            auto broken = broken_cell(lines[i], dialect, cells);
            if (!broken) continue;
            broken->line = i + 1;
            ++by_cells.try_emplace(cells.size(), 0, std::move(*broken)).first->second.first;
        }
        for (const auto& [columns, seen] : by_cells)
            if (seen.first > most) std::tie(most, found) = std::pair(seen.first, std::optional(seen.second));
    }
    return found;
}

std::string described(const BrokenCell& broken) {
    return fmt::format(
        "'{:.40}' in column {} is not a number; expected a number, or nothing, NaN, N/A or another word "
        "for a missing value",
        broken.cell, broken.column);
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
        // a table written with an index has no name above it
        const bool index = candidate == separator && candidate != ' ' && named.size() > 2 && named.size() == least &&
                           std::none_of(named.begin() + 1, named.end(), [](const auto& cell) { return cell.empty(); });
        if (named.size() >= least && named.size() <= most && (index || !named.front().empty())) return named;
    }
    return {};
}

}  // namespace setae::tables
