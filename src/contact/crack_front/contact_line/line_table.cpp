// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact_line/line_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::contact_line {
namespace {

std::string radius_name(Index place) { return fmt::format("radius_{}", place + 1); }

}  // namespace

Table as_table(const ContactLine& line, const std::vector<long>& frames) {
    require_valid(line);
    if (static_cast<Index>(frames.size()) != line.frames())
        throw InvalidArgument(
            fmt::format("{} numbers for {} frames; expected one per frame", frames.size(), line.frames()));
    Array1D numbers(line.frames());
    std::copy(frames.begin(), frames.end(), numbers.begin());
    Table table;
    table.columns = {{"time", "s", line.time}, {"frame", "1", std::move(numbers)}};
    for (Index j = 0; j < line.angles(); ++j) table.columns.push_back({radius_name(j), "m", line.radius.col(j)});
    table.metadata["place_error"] = fmt::format("{} m", line.place_error);
    return table;
}

ContactLine line_of(const Table& table) {
    ContactLine line{.time = table.at("time"), .radius = {}};
    Index angles = 0;
    while (table.find(radius_name(angles))) ++angles;
    const auto radii = std::count_if(table.columns.begin(), table.columns.end(),
                                     [](const Column& c) { return c.name.starts_with("radius_"); });
    if (angles == 0 || radii != angles)
        throw InvalidArgument(
            fmt::format("a table of a contact line with {} columns of radii, of which {} are consecutive; expected "
                        "radius_1, radius_2 … radius_N at N equal angles",
                        radii, angles));
    line.radius.resize(table.rows(), angles);
    for (Index j = 0; j < angles; ++j) line.radius.col(j) = table.at(radius_name(j));
    if (const auto stated = table.metadata.find("place_error"); stated != table.metadata.end())
        line.place_error = parse_quantity(stated->second, non_negative(dimension::length));
    require_valid(line);
    return line;
}

}  // namespace setae::contact_line
