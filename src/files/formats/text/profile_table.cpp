// SPDX-License-Identifier: GPL-3.0-or-later
#include "profile_table.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "column_meaning.hpp"
#include "curve_channel.hpp"
#include "height_names.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/header.hpp"
#include "trace.hpp"

namespace setae::formats {
namespace {

bool is_named_y(const std::string& name) {
    const auto words = words_of_name(name);
    return !words.empty() && words.front() == "y";
}

bool may_be_positions(const tables::RawTable::RawColumn& column, bool declared) {
    if (!column.unit.empty() && !is_length_unit(column.unit)) return false;
    if (!other_quantity(column.name).empty() || !run_along(column.values)) return false;
    return declared || !column.unit.empty() || is_position_name(column.name);
}

/// A column of loops and other records in time: time, or a force.
bool is_of_a_record(const tables::RawTable::RawColumn& column) {
    const auto unit = tables::try_parse_unit(column.unit);
    const auto quantity = other_quantity(column.name);
    return (unit && (unit->dimension == dimension::time || unit->dimension == dimension::force)) ||
           quantity == "time" || quantity == "zeit" || quantity == "temps" || quantity == "force" ||
           quantity == "kraft";
}

/// A column of 0, 1, 2 … or 1, 2, 3 … whose name and unit are not those of positions or a quantity.
bool are_numbers_of_rows(const tables::RawTable::RawColumn& column) {
    return column.unit.empty() && !is_position_name(column.name) && other_quantity(column.name).empty() &&
           counts_rows(column.values);
}

/// A column that may come before that of positions: another quantity, such as the time.
bool is_before_positions(const tables::RawTable::RawColumn& column) {
    return are_numbers_of_rows(column) || !other_quantity(column.name).empty() ||
           (!column.unit.empty() && !is_length_unit(column.unit));
}

}  // namespace

bool run_along(const Array1D& positions) {
    if (positions.size() < 2 || !positions.isFinite().all()) return false;
    bool forward = true, backward = true;
    for (Index i = 1; i < positions.size(); ++i) {
        forward = forward && positions[i] >= positions[i - 1];
        backward = backward && positions[i] <= positions[i - 1];
    }
    const bool moves = positions.maxCoeff() > positions.minCoeff();
    return moves && (forward || backward || passes_of(positions).size() > 1);
}

std::optional<std::size_t> positions_of_profiles(const tables::RawTable& table, bool declared) {
    const auto& columns = table.columns;
    const bool numbers_first =
        columns.size() > 2 && are_numbers_of_rows(columns[0]) && may_be_positions(columns[1], declared);
    std::size_t x = numbers_first ? 1 : 0;
    while (x + 2 < columns.size() && is_before_positions(columns[x]) && !may_be_positions(columns[x], false)) ++x;
    if (x > 0 && !numbers_first &&
        (!is_position_name(columns[x].name) ||
         std::none_of(columns.begin() + static_cast<std::ptrdiff_t>(x) + 1, columns.end(),
                      [](const auto& column) { return is_height_name(column.name); })))
        return std::nullopt;
    if (columns.size() < x + 2 || !may_be_positions(columns[x], declared)) return std::nullopt;
    const bool record = std::any_of(columns.begin(), columns.end(), is_of_a_record);
    if (record && !declared && !is_position_name(columns[x].name)) return std::nullopt;
    const bool points = !declared && columns.size() >= x + 3 && is_named_y(columns[x + 1].name);
    return points ? std::nullopt : std::optional(x);
}

std::optional<tables::RawTable> named_points(const tables::RawTable& table) {
    std::vector<tables::RawTable::RawColumn> x, y, heights;
    for (const auto& column : table.columns) {
        const auto words = words_of_name(column.name);
        const bool length = column.text.empty() && (column.unit.empty() || is_length_unit(column.unit));
        if (words.empty() || !length) continue;
        if (words.front() == "x") x.push_back(column);
        else if (words.front() == "y") y.push_back(column);
        else if (is_height_name(column.name)) heights.push_back(column);
    }
    if (x.size() != 1 || y.size() != 1 || heights.size() != 1) return std::nullopt;
    auto points = table;
    points.columns = {x.front(), y.front(), heights.front()};
    return points;
}

std::vector<Channel> profile_channels(const tables::RawTable& table, std::size_t positions,
                                      const std::vector<Alert>& alerts, const ReadOptions& options,
                                      const bytes::Source& source) {
    std::vector<Channel> channels;
    for (std::size_t k = positions + 1; k < table.columns.size(); ++k) {
        const auto& column = table.columns[k];
        ChannelInfo info;
        info.name = column.name.empty() ? fmt::format("column {}", k + 1) : column.name;
        info.format = "xy";
        info.alerts = alerts;
        info.metadata.file = source.name;
        auto reason = reason_against_heights(column);
        const bool named_so = is_position_name(column.name) || is_named_y(column.name);
        if (reason.empty() && named_so && run_along(column.values)) reason = "its name means positions";
        if (reason.empty() && column.values.isNaN().all()) reason = "none of its cells is defined";
        const bool lengths = column.text.empty() && (column.unit.empty() || is_length_unit(column.unit));
        if (!lengths || column.values.isNaN().all()) {
            info.shape = {column.values.size()};
            info.unit = column.unit;
            channels.push_back(non_height_channel(std::move(info), reason));
            continue;
        }
        for (auto& channel : curve_channels(std::move(info), {table.columns[positions], column}, options, source))
            channels.push_back(reason.empty() ? std::move(channel) : doubtful_channel(std::move(channel), reason));
    }
    return channels;
}

}  // namespace setae::formats
