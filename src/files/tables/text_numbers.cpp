// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/text_numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::tables {
namespace {

constexpr std::uint64_t chunk_bytes = 1 << 20;
/// Lines are collected before they are written to their places, so adjacent places are written together.
constexpr Index max_gathered = 16;
constexpr std::size_t gathered_numbers = 1 << 17;
constexpr std::size_t max_breaks = 1 << 12;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Whether a line of letters may be one of numbers: it begins with a word for an undefined value.
bool begins_with_number_word(std::string_view line) {
    double value = 0.0;
    return parse_cell(line.substr(0, line.find_first_of(" \t,;")), '.', value);
}

/// Kinds of the lines that begin in a chunk of the text.
struct Chunk {
    std::optional<std::uint64_t> first;  ///< byte of the first line that begins in it
    std::uint64_t lines = 0;
    Index rows = 0;
    std::uint64_t last_row = 0;  ///< byte of the last line of numbers, if there is one
    std::uint64_t last_row_line = 0;
    std::vector<NumberLines::Break> breaks;
};

/// The line that begins at `text`; reading continues in the source if the chunk ends before its kind is known.
std::string_view line_at(std::string_view text, std::string& buffer, const bytes::Source& source, std::uint64_t offset,
                         std::uint64_t end) {
    constexpr std::uint64_t enough = 64;
    auto stop = text.find('\n');
    auto line = text.substr(0, stop);
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    if (stop != std::string_view::npos || line.size() >= enough || offset + text.size() >= end) return line;
    for (std::uint64_t ahead = text.size() + enough;; ahead *= 2) {
        buffer = source.bytes(offset, std::min(ahead, end - offset));
        line = buffer;
        stop = line.find('\n');
        line = line.substr(0, stop);
        while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
        if (stop != std::string_view::npos || line.size() >= enough || offset + buffer.size() >= end) return line;
    }
}

Chunk look_at(const bytes::Source& source, std::uint64_t begin, std::uint64_t chunk_begin, std::uint64_t chunk_end,
              std::uint64_t end) {
    Chunk chunk;
    const auto from =
        chunk_begin > begin ? chunk_begin - 1 : begin;  // the previous break shows whether a line begins here
    const auto size = static_cast<std::size_t>(chunk_end - from);
    const auto bytes = std::make_unique_for_overwrite<char[]>(size);
    source.read_into(from, size, bytes.get());
    const std::string_view text(bytes.get(), size);
    std::string buffer;
    std::size_t at = 0;
    if (from < chunk_begin) {
        const auto stop = text.find('\n');
        if (stop == std::string_view::npos) return chunk;
        at = stop + 1;
    }
    while (at < size) {
        const auto offset = from + at;
        if (!chunk.first) chunk.first = offset;
        const auto stop = static_cast<const char*>(std::memchr(text.data() + at, '\n', size - at));
        const char c = text[at];
        const bool plain = (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
        const auto line =
            plain ? std::string_view(text.data() + at, 1) : line_at(text.substr(at), buffer, source, offset, end);
        if (!line.empty()) {
            const bool word = is_letter(line.front()) && !begins_with_number_word(line);
            const bool comment = is_comment(line);
            if ((word || (comment && line.front() == '#')) && chunk.breaks.size() < max_breaks)
                chunk.breaks.push_back({offset, chunk.lines, chunk.rows});
            if (!comment) {
                ++chunk.rows;
                chunk.last_row = offset;
                chunk.last_row_line = chunk.lines;
            }
        }
        ++chunk.lines;
        if (!stop) break;
        at = static_cast<std::size_t>(stop - text.data()) + 1;
    }
    return chunk;
}

/// One line of plain numbers with decimal points and nothing else; otherwise false.
bool parse_plain(const char* at, const char* end, char separator, Index columns, double* values) {
    const auto skip = [&] {
        while (at < end && (*at == ' ' || *at == '\r' || (*at == '\t' && separator != '\t'))) ++at;
    };
    for (Index k = 0; k < columns; ++k) {
        skip();
        if (at < end && *at == '+') ++at;
        if (at == end || (*at != '-' && *at != '.' && (*at < '0' || *at > '9'))) return false;
        const auto [stop, error] = std::from_chars(at, end, values[k]);
        if (error != std::errc{}) return false;
        at = stop;
        const bool touching = at < end && *at != separator && !is_blank(*at);
        if (touching) return false;
        skip();
        if (separator == ' ' || k + 1 == columns) continue;
        if (at == end || *at != separator) return false;
        ++at;
    }
    while (at < end && *at == separator) {  // rows may end in separators
        ++at;
        skip();
    }
    return at == end;
}

/// Reads the lines of a block in sequence.
class LineParser {
public:
    LineParser(const NumberLines& lines, std::string_view text, std::uint64_t line)
        : lines_(lines), rest_(text), number_(line) {}

    /// The numbers of the next line of numbers; false at the end of the block.
    bool next(double* values) {
        while (!rest_.empty()) {
            const auto stop = rest_.find('\n');
            const auto line = rest_.substr(0, stop);
            rest_.remove_prefix(stop == std::string_view::npos ? rest_.size() : stop + 1);
            ++number_;
            if (plain(line, values)) return true;
            const auto content = trimmed(line);
            if (content.empty() || is_comment(content)) continue;
            parse_number_line(line, lines_.layout, number_, lines_.source.name, values);
            return true;
        }
        return false;
    }

private:
    bool plain(std::string_view line, double* values) {
        if (lines_.layout.dialect.decimal_point == '.')
            return parse_plain(line.data(), line.data() + line.size(), lines_.layout.dialect.separator, lines_.columns,
                               values);
        if (lines_.layout.dialect.separator == ',' || line.find('.') != std::string_view::npos) return false;
        pointed_.assign(line);
        std::replace(pointed_.begin(), pointed_.end(), ',', '.');
        return parse_plain(pointed_.data(), pointed_.data() + pointed_.size(), lines_.layout.dialect.separator,
                           lines_.columns, values);
    }

    const NumberLines& lines_;
    std::string_view rest_;
    std::uint64_t number_;
    std::string pointed_;
};

/// Lines collected until they are written to their places together.
class Gathering {
public:
    Gathering(const NumberPlaces& places, Index columns, Array2D& target)
        : places_(places), columns_(columns), target_(target) {
        const auto room = static_cast<Index>(gathered_numbers) / std::max<Index>(columns, 1);
        capacity_ = std::clamp<Index>(room, 1, max_gathered);
        values_ = std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(capacity_ * columns));
    }

    [[nodiscard]] double* place() { return values_.get() + count_ * columns_; }
    void keep(Index row) {
        if (count_ == 0) first_ = row;
        if (++count_ == capacity_) put();
    }
    void put() {
        if (places_.lines_are_columns) {
            for (Index j = 0; j < count_; ++j)
                for (Index k = 0; k < columns_; ++k)
                    target_(first_ + j, columns_ - 1 - k) =
                        places_.factor * values_[static_cast<std::size_t>(j * columns_ + k)];
        } else {
            for (Index k = 0; k < columns_; ++k)
                for (Index j = 0; j < count_; ++j)
                    target_(k, first_ + j) = places_.factor * values_[static_cast<std::size_t>(j * columns_ + k)];
        }
        count_ = 0;
    }

private:
    const NumberPlaces& places_;
    Index columns_, capacity_ = 1, count_ = 0, first_ = 0;
    Array2D& target_;
    std::unique_ptr<double[]> values_;
};

}  // namespace

std::string whole_line(const bytes::Source& source, std::uint64_t offset, std::uint64_t end) {
    for (std::uint64_t size = 1 << 16;; size *= 4) {
        auto text = source.bytes(offset, std::min(size, end - offset));
        const auto stop = text.find('\n');
        if (stop == std::string::npos && offset + size < end) continue;
        text.resize(std::min(stop, text.size()));
        return text;
    }
}

void parse_number_line(std::string_view line, const Layout& layout, std::uint64_t number, const std::string& name,
                       double* values) {
    std::vector<std::string_view> cells;
    split_cells(line, layout.dialect.separator, cells);
    while (cells.size() > layout.columns && cells.back().empty()) cells.pop_back();
    if (cells.size() != layout.columns)
        throw FormatError(name, {.line = number},
                          fmt::format("{} columns, expected {} as in the other lines; the file may be truncated here",
                                      cells.size(), layout.columns));
    for (std::size_t k = 0; k < cells.size(); ++k)
        if (!parse_cell(cells[k], layout.dialect, values[k]))
            throw FormatError(name, {.line = number},
                              described({.cell = std::string(cells[k]), .line = number, .column = k + 1}));
}

NumberLines find_number_lines(const TextStart& start, std::uint64_t begin, std::uint64_t end) {
    NumberLines lines{
        start.source, start.layout, static_cast<Index>(start.layout.columns), 0, {}, {}, start.line, end, {}};
    const auto count = static_cast<std::size_t>((end - begin + chunk_bytes - 1) / chunk_bytes);
    std::vector<Chunk> chunks(count);
    parallel::for_each_index(count, {}, [&](std::size_t i) {
        const auto chunk_begin = begin + i * chunk_bytes;
        chunks[i] = look_at(start.source, begin, chunk_begin, std::min(chunk_begin + chunk_bytes, end), end);
    });
    for (const auto& chunk : chunks) {
        if (!chunk.first) continue;
        if (!lines.blocks.empty()) lines.blocks.back().size = *chunk.first - lines.blocks.back().offset;
        lines.blocks.push_back({*chunk.first, 0, lines.lines, lines.rows});
        for (const auto& found : chunk.breaks)
            if (lines.breaks.size() < max_breaks)
                lines.breaks.push_back({found.offset, found.line + lines.lines, found.row + lines.rows});
        if (chunk.rows > 0)
            lines.last = {chunk.last_row, lines.lines + chunk.last_row_line, lines.rows + chunk.rows - 1};
        lines.lines += chunk.lines;
        lines.rows += chunk.rows;
    }
    if (!lines.blocks.empty()) lines.blocks.back().size = end - lines.blocks.back().offset;
    return lines;
}

void require_whole_last_line(const NumberLines& lines) {
    if (lines.rows == 0) return;
    std::vector<double> numbers(lines.layout.columns);
    parse_number_line(whole_line(lines.source, lines.last.offset, lines.end), lines.layout, lines.last.line + 1,
                      lines.source.name, numbers.data());
}

Array2D read_numbers(const NumberLines& lines, const NumberPlaces& places) {
    const Index last = places.count < 0 ? lines.rows : places.first + places.count;
    const Index rows = last - places.first;
    std::uint64_t characters = 1;  // a cell has at least one character and its separator: no more memory is allocated
    for (const auto& block : lines.blocks) characters += block.size;
    if (static_cast<std::uint64_t>(lines.rows) >
        characters / static_cast<std::uint64_t>(std::max<Index>(lines.columns, 1)))
        throw FormatError(
            lines.source.name, {.line = lines.lines},
            fmt::format("{} lines are too short for {} columns each; some have fewer", lines.rows, lines.columns));
    Array2D target(places.lines_are_columns ? rows : lines.columns, places.lines_are_columns ? lines.columns : rows);
    parallel::for_each_index(lines.blocks.size(), {}, [&](std::size_t i) {
        const auto& block = lines.blocks[i];
        const Index next = i + 1 < lines.blocks.size() ? lines.blocks[i + 1].row : lines.rows;
        if (next <= places.first || block.row >= last) return;
        const auto bytes = std::make_unique_for_overwrite<char[]>(block.size);
        lines.source.read_into(block.offset, block.size, bytes.get());
        LineParser parser(lines, {bytes.get(), block.size}, block.line);
        Gathering gathering(places, lines.columns, target);
        for (Index row = block.row; row < std::min(next, last); ++row) {
            if (!parser.next(gathering.place())) break;
            if (row >= places.first) gathering.keep(row - places.first);
        }
        gathering.put();
    });
    return target;
}

Array2D read_numbers_plainly(const NumberLines& lines) {
    Array2D target(lines.columns, lines.rows);
    std::vector<double> values(static_cast<std::size_t>(lines.columns));
    Index row = 0;
    for (const auto& block : lines.blocks) {
        const auto text = lines.source.bytes(block.offset, block.size);
        auto number = block.line;
        for (const auto line : bytes::split_lines(text)) {
            ++number;
            const auto content = trimmed(line);
            if (content.empty() || is_comment(content)) continue;
            parse_number_line(line, lines.layout, number, lines.source.name, values.data());
            for (Index k = 0; k < lines.columns; ++k) target(k, row) = values[static_cast<std::size_t>(k)];
            ++row;
        }
    }
    return target;
}

}  // namespace setae::tables
