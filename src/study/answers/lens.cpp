// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/lens.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/imaging/lens_outline.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::answers {
namespace {

/// The column of that name, else the given one of those in metres.
const Array1D& length_column(const Table& table, const std::string& file, const std::string& name, std::size_t place) {
    std::vector<const Column*> lengths;
    for (const auto& column : table.columns)
        if (column.unit == "m") lengths.push_back(&column);
    if (name.empty()) {
        if (lengths.size() > place) return lengths[place]->values;
        throw FormatError(file, {},
                          "a profile needs two columns of lengths with their units, such as \"x [mm]\" and "
                          "\"z [um]\"; name them with `x` and `z`");
    }
    const Column* column = table.find(name);
    if (column == nullptr || column->unit != "m")
        throw InvalidArgument(fmt::format("{}: no column '{}' of lengths", file, name));
    return column->values;
}

/// Points of a lens's section, from a table or from a picture of its side.
imaging::LensOutline outline_of(const std::string& file, const LensRequest& request) {
    if (imaging::is_picture(file))
        return imaging::lens_outline(file, request.pixel.empty()
                                               ? std::nullopt
                                               : std::optional(parse_quantity(request.pixel, dimension::length)));
    const Table table = tables::read_table(file);
    return {.x = length_column(table, file, request.x, 0), .z = length_column(table, file, request.z, 1)};
}

}  // namespace

Lens lens_of(const std::string& file, const LensRequest& request) {
    const auto outline = outline_of(file, request);
    const auto &x = outline.x, &z = outline.z;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const auto end = [](const std::string& text, double otherwise) {
        return text.empty() ? otherwise : parse_quantity(text, dimension::length);
    };
    const double from = end(request.from, -infinite), to = end(request.to, infinite);
    std::vector<Index> kept;
    for (Index i = 0; i < x.size(); ++i)
        if (x[i] >= from && x[i] <= to && std::isfinite(z[i])) kept.push_back(i);
    const Array1D along = x(kept), height = z(kept);
    Lens lens{.file = file,
              .circle = kept.size() == 3 ? loops::circle_through(along, height) : loops::fit_circle(along, height),
              .conic = {},
              .no_conic = {},
              .alerts = outline.alerts,
              .points = along.size()};
    try {
        lens.conic = loops::fit_conic(along, height);
    } catch (const UndefinedDataError& error) {
        lens.no_conic = error.what();
    }
    lens.first = along.minCoeff();
    lens.last = along.maxCoeff();
    return lens;
}

}  // namespace setae::answers
