// SPDX-License-Identifier: GPL-3.0-or-later
#include "labels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/header.hpp"

namespace setae::formats {
namespace {

constexpr Index min_evenly_spaced = 8;  ///< number of evenly spaced numbers that are not heights by chance
constexpr Index min_positions = 3, rows_looked_at = 64;
constexpr double rounding_of_labels = 0.1;  ///< of a step
constexpr double share_of_others = 0.25;    ///< of other rows that are evenly spaced, too, as on a tilted plane

/// Values as evenly spaced labels; empty if they are not.
std::optional<AxisLabels> evenly_spaced(const Eigen::Ref<const Array1D, 0, Eigen::InnerStride<>>& values) {
    const Index n = values.size();
    if (n < 2) return std::nullopt;
    const double step = (values[n - 1] - values[0]) / static_cast<double>(n - 1);
    if (!std::isfinite(step) || step == 0.0) return std::nullopt;
    for (Index i = 0; i < n; ++i)
        if (!(std::abs(values[i] - values[0] - static_cast<double>(i) * step) <= rounding_of_labels * std::abs(step)))
            return std::nullopt;
    const bool counts = step == 1.0 && (values[0] == 0.0 || values[0] == 1.0);
    return AxisLabels{values[0], step, n, counts};
}

/// The last line of the header as labels: its corner, and its numbers.
struct HeaderRow {
    std::string corner;
    Array1D numbers;
    std::string unit;  ///< next to every number: "1.382 um"
};

std::optional<HeaderRow> header_row(const std::vector<std::string>& header, const tables::NumberLines& lines) {
    if (header.empty()) return std::nullopt;
    std::string_view line = header.back();
    while (!line.empty() && line.front() == '#') line = trimmed(line.substr(1));
    std::vector<std::string_view> cells;
    tables::split_cells(line, lines.layout.dialect.separator, cells);
    while (static_cast<Index>(cells.size()) > lines.columns && cells.back().empty()) cells.pop_back();
    const bool cornered = static_cast<Index>(cells.size()) == lines.columns;
    if (!cornered && static_cast<Index>(cells.size()) + 1 != lines.columns) return std::nullopt;
    HeaderRow row{
        .corner = cornered ? std::string(cells.front()) : "", .numbers = Array1D(lines.columns - 1), .unit = {}};
    for (Index k = 0; k + 1 < lines.columns; ++k) {
        auto cell = cells[static_cast<std::size_t>(cornered ? k + 1 : k)];
        if (const auto blank = cell.find_last_of(" ["); blank != std::string_view::npos && blank > 0) {
            auto unit = std::string(trimmed(cell.substr(blank + 1)));
            if (unit.ends_with(']')) unit.pop_back();
            const auto parsed = tables::try_parse_unit(unit);
            if (parsed && parsed->dimension == dimension::length && (row.unit.empty() || row.unit == unit)) {
                row.unit = unit;
                cell = trimmed(cell.substr(0, blank));
            }
        }
        if (!tables::parse_cell(cell, lines.layout.dialect, row.numbers[k]) || std::isnan(row.numbers[k]))
            return std::nullopt;
    }
    return row;
}

/// The unit in a corner such as "y\x [um]" or "um".
std::string unit_of_corner(std::string corner) {
    if (corner.size() >= 2 && corner.front() == '"' && corner.back() == '"')
        corner = corner.substr(1, corner.size() - 2);
    const auto is_length = [](const std::string& text) {
        const auto unit = tables::try_parse_unit(text);
        return unit && unit->dimension == dimension::length;
    };
    if (const auto cell = tables::parse_header_cell(corner); is_length(cell.unit)) return cell.unit;
    auto inside = corner;
    std::erase_if(inside, [](char c) { return c == '[' || c == ']' || c == '(' || c == ')'; });
    return is_length(inside) ? inside : "";
}

/// Share of rows (or columns) of numbers that are evenly spaced.
template <class Line>
double evenly_spaced_share(Index first, Index count, const Line& line) {
    Index even = 0, all = 0;
    for (Index i = first; i < count; ++i, ++all) even += evenly_spaced(line(i)).has_value();
    return all > 0 ? static_cast<double>(even) / static_cast<double>(all) : 1.0;
}

class Search {
public:
    Search(const tables::NumberLines& lines, const std::vector<std::string>& header, bool is_map)
        : lines_(lines), header_(header), is_map_(is_map) {
        const Index count = std::min(rows_looked_at, lines.rows);
        numbers_ = tables::read_numbers(lines, {.count = count});
        last_row_ = Array1D(lines.columns);
        tables::parse_number_line(tables::whole_line(lines.source, lines.last.offset, lines.end), lines.layout,
                                  lines.last.line + 1, lines.source.name, last_row_.data());
    }

    Labels labels() {
        Labels found;
        look_at_header(found);
        if (!found.x) look_at_first_row(found);
        look_at_first_column(found);
        return found;
    }

private:
    [[nodiscard]] auto row(Index j, Index from) const { return numbers_.col(j).segment(from, lines_.columns - from); }

    void look_at_header(Labels& found) const {
        const auto above = header_row(header_, lines_);
        if (!above) return;
        const auto positions = evenly_spaced(above->numbers);
        if (!positions && above->corner.empty()) return;  // numbers of another kind
        if (!positions)
            throw FormatError(
                lines_.source.name, {.line = lines_.blocks.front().line},
                "the line above the numbers contains numbers that are not evenly spaced, expected positions "
                "with one step above a map; remove them, and give `size`");
        const auto first = first_column_from(0);
        if (positions->counts && !above->corner.empty() && first && !first->counts && !is_map_) ask(*first);
        found.x = positions;
        found.first_column = true;
        found.unit = above->unit.empty() ? unit_of_corner(above->corner) : above->unit;
    }

    void look_at_first_row(Labels& found) const {
        const Index n = lines_.columns;
        const bool corner_is_empty = std::isnan(numbers_(0, 0));
        const auto inner = evenly_spaced(row(0, 1)), whole = evenly_spaced(row(0, 0));
        // a few numbers are labels if those of the first column are, too
        const auto column = first_column_from(1);
        const bool both = column && n - 1 + column->count > min_evenly_spaced;
        if (!inner || (!corner_is_empty && !both && n - 1 < min_evenly_spaced)) return;
        const auto others = [&](Index j) -> Array1D { return row(j, 1); };
        if (evenly_spaced_share(1, numbers_.cols(), others) > share_of_others) return;
        found.rows_above = 1;
        // the first cell belongs to the positions of the row if the first column has none
        found.first_column = corner_is_empty || !whole || column.has_value();
        found.x = found.first_column ? inner : whole;
    }

    /// The first column as labels from a row on.
    [[nodiscard]] std::optional<AxisLabels> first_column_from(Index row) const {
        const Index looked_at = numbers_.cols() - row, all = lines_.rows - row;
        if (looked_at < 2) return std::nullopt;
        Array1D values = numbers_.row(0).segment(row, looked_at).transpose();
        auto labels = evenly_spaced(values);
        if (!labels) return std::nullopt;
        const double step = (last_row_[0] - labels->first) / static_cast<double>(all - 1);
        if (!(std::abs(step - labels->step) <= rounding_of_labels * std::abs(step))) return std::nullopt;
        return AxisLabels{labels->first, step, all, labels->counts && step == 1.0};
    }

    void look_at_first_column(Labels& found) {
        const auto positions = first_column_from(found.rows_above);
        if (found.x) {
            if (found.first_column) found.y = positions;
            return;
        }
        if (!positions || positions->count < min_evenly_spaced) return;
        const auto others = [&](Index k) -> Array1D { return numbers_.row(k).transpose(); };
        if (evenly_spaced_share(1, lines_.columns, others) > share_of_others) return;
        if (!positions->counts && !is_map_) ask(*positions);
        found.y = positions;
        found.first_column = true;
    }

    [[noreturn]] void ask(const AxisLabels& positions) const {
        throw FormatError(
            lines_.source.name, {.line = lines_.blocks.front().line + 1},
            fmt::format("the first of {} columns is evenly spaced from {:.6g} to {:.6g}: it contains x of {} profiles, "
                        "or positions of the rows of a map; set `layout` to columns or matrix",
                        lines_.columns, positions.first, positions.last(), lines_.columns - 1));
    }

    const tables::NumberLines& lines_;
    const std::vector<std::string>& header_;
    bool is_map_;
    Array2D numbers_;
    Array1D last_row_;
};

std::string axis_described(const char* what, const std::optional<AxisLabels>& axis, const char* counted) {
    if (!axis) return fmt::format("the first {} contains labels", what);
    if (axis->counts) return fmt::format("the first {} contains numbers of {}", what, counted);
    return fmt::format("the first {} contains positions {:.6g} to {:.6g}", what, axis->first, axis->last());
}

}  // namespace

std::string Labels::described() const {
    if (!first_column) return axis_described("row", x, "columns");
    const auto column = axis_described("column", y, "rows");
    return x ? axis_described("row", x, "columns") + ", " + column : column;
}

Labels find_labels(const tables::NumberLines& lines, const std::vector<std::string>& header, bool is_map) {
    if (lines.columns <= min_positions || lines.rows <= min_positions) return {};
    return Search(lines, header, is_map).labels();
}

Array2D without_labels(const Array2D& numbers, const Labels& labels, const tables::NumberLines& lines) {
    const Index left = labels.first_column ? 1 : 0, above = labels.rows_above;
    if (labels.y)
        for (Index j = above; j < numbers.cols(); ++j) {
            const double expected = labels.y->first + labels.y->step * static_cast<double>(j - above);
            if (!(std::abs(numbers(0, j) - expected) <= 2.0 * rounding_of_labels * std::abs(labels.y->step)))
                throw FormatError(
                    lines.source.name, {},
                    fmt::format("position {} of row {} of numbers; expected {:.6g}, in steps as in the first column of "
                                "positions",
                                numbers(0, j), j + 1, expected));
        }
    Array2D heights = numbers.block(left, above, numbers.rows() - left, numbers.cols() - above);
    if (labels.x && labels.x->step < 0.0) heights = heights.colwise().reverse().eval();
    if (labels.y && labels.y->step < 0.0) heights = heights.rowwise().reverse().eval();
    return heights;
}

}  // namespace setae::formats
