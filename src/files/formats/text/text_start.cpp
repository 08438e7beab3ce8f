// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_start.hpp"

#include <algorithm>
#include <utility>

#include "matrix_header.hpp"
#include "setae/core/text.hpp"

namespace setae::formats {
namespace {

/// Lines up to the header of a second map, if there is one.
void keep_first_part(std::vector<std::string_view>& lines) {
    bool numbers = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto line = trimmed(lines[i]);
        if (numbers && begins_numbers(line, {})) return lines.resize(i);
        numbers = numbers || !(line.empty() || tables::is_comment(line));
    }
}

thread_local KeptStart* innermost = nullptr;

std::optional<tables::TextStart> looked_for(const bytes::Source& source) {
    auto head = source.head(bytes::detection_bytes);
    if (!bytes::looks_like_text(head)) return std::nullopt;
    tables::TextStart start;
    start.source = source;
    const bool two_bytes = head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff");
    if (two_bytes || (head.find('\n') == std::string::npos && head.find('\r') != std::string::npos)) {
        start.source = bytes::memory_source(source.name, bytes::decoded(source.all(), bytes::Encoding::detect));
        head = start.source.head(bytes::detection_bytes);
    }
    for (;;) {
        const bool whole = head.size() == start.source.size;
        const auto last_break = head.rfind('\n');
        auto text = bytes::decoded(whole || last_break == std::string::npos ? head : head.substr(0, last_break),
                                   bytes::Encoding::detect);
        auto lines = bytes::split_lines(text);
        keep_first_part(lines);
        auto layout = tables::find_layout(lines, {});
        if (!layout && !whole) {  // a first row longer than the bytes read: its dialect follows from the available part
            text = bytes::decoded(head.substr(0, head.find_last_of(" \t;,")), bytes::Encoding::detect);
            lines = bytes::split_lines(text);
            layout = tables::find_layout(lines, {});
        }
        if (!layout && !whole && head.size() < (std::size_t{1} << 20)) {
            head = start.source.head(4 * head.size());
            continue;
        }
        if (!layout) return std::nullopt;
        start.layout = *layout;
        start.line = layout->first_row;
        start.broken = tables::broken_row_above(lines, *layout);
        constexpr std::string_view utf8_mark = "\xef\xbb\xbf";
        if (head.starts_with(utf8_mark)) start.begin = utf8_mark.size();
        for (std::size_t i = 0; i < layout->first_row; ++i) {
            start.begin = head.find('\n', start.begin) + 1;
            if (const auto line = trimmed(lines[i]); !line.empty()) start.header.emplace_back(line);
        }
        const bool row_is_whole = whole || head.find('\n', start.begin) != std::string::npos;
        if (!row_is_whole) {
            const auto row = tables::whole_line(start.source, start.begin, start.source.size);
            std::vector<std::string_view> cells;
            tables::split_cells(row, layout->dialect.separator, cells);
            start.layout.columns = start.layout.filled = cells.size();
        }
        start.layout.first_row = 0;
        start.layout.columns = start.layout.filled;
        return start;
    }
}

}  // namespace

KeptStart::KeptStart(const bytes::Source& source) : source_(source), outer_(std::exchange(innermost, this)) {}

KeptStart::~KeptStart() { innermost = outer_; }

std::optional<tables::TextStart> find_start(const bytes::Source& source) {
    if (!innermost || &innermost->source_ != &source) return looked_for(source);
    if (!innermost->start_) innermost->start_ = looked_for(source);
    return *innermost->start_;
}

}  // namespace setae::formats
