// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/force_map_output.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/core/units.hpp"
#include "setae/formats/quantity_maps.hpp"

namespace setae::output {
namespace {

/// Missing results of a curve with the reasons, each reason once.
std::string missing_text(const study::MappedCurve& curve) {
    if (!curve.summary) return curve.summary.reason;
    std::vector<std::string> reasons;
    for (const auto& quantity : loops::curve_quantities())
        if (const auto& value = (*curve.summary).*quantity.value;
            !value && std::find(reasons.begin(), reasons.end(), value.reason) == reasons.end())
            reasons.push_back(value.reason);
    return fmt::format("{}", fmt::join(reasons, "; "));
}

double pixel_of(const study::MappedCurve& curve, std::size_t axis) {
    return curve.pixel ? static_cast<double>((*curve.pixel)[axis]) : undefined;
}

std::vector<double> sorted_values(const study::ForceMap& map, const loops::CurveQuantity& quantity) {
    std::vector<double> values;
    for (const auto& curve : map.curves)
        if (curve.summary && (*curve.summary).*quantity.value)
            values.push_back(((*curve.summary).*quantity.value)->value);
    std::sort(values.begin(), values.end());
    return values;
}

}  // namespace

tables::TidyTable curves_table(const study::ForceMap& map) {
    tables::TidyTable table{"curves", {"curve", "x [m]", "y [m]", "column", "row"}, {}};
    for (const auto& quantity : loops::curve_quantities()) {
        table.columns.push_back(fmt::format("{} [{}]", quantity.column, quantity.unit));
        table.columns.push_back(fmt::format("{} standard_error [{}]", quantity.column, quantity.unit));
    }
    table.columns.emplace_back("reason");
    for (const auto& curve : map.curves) {
        std::vector<tables::TidyTable::Cell> row{static_cast<double>(curve.number), curve.x, curve.y,
                                                 pixel_of(curve, 0), pixel_of(curve, 1)};
        for (const auto& quantity : loops::curve_quantities()) {
            const Estimate value = curve.summary && (*curve.summary).*quantity.value
                                       ? *((*curve.summary).*quantity.value)
                                       : Estimate{undefined};
            row.emplace_back(value.value);
            row.emplace_back(value.standard_error);
        }
        row.emplace_back(missing_text(curve));
        table.rows.push_back(std::move(row));
    }
    return table;
}

tables::TidyTable spread_table(const study::ForceMap& map) {
    tables::TidyTable table{"", {"quantity", "curves", "least", "16 %", "median", "84 %", "largest"}, {}};
    for (const auto& quantity : loops::curve_quantities()) {
        const auto values = sorted_values(map, quantity);
        std::vector<tables::TidyTable::Cell> row{std::string(quantity.symbol), fmt::format("{}", values.size())};
        for (const double probability : {0.0, normal_probability(-1.0), 0.5, normal_probability(1.0), 1.0})
            row.emplace_back(values.empty() ? std::string("–")
                                            : format_value(sorted_quantile(values, probability), quantity.unit, 3));
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::vector<std::string> write_force_map(const study::ForceMap& map, const std::string& folder,
                                         const std::string& name) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        throw FileError(
            fmt::format("{}: cannot be made: {}; check that the folder above is writable", folder, failure.message()));
    const auto place = std::filesystem::path(folder) / name;
    std::vector<std::string> written{place.string() + ".csv"};
    bytes::write_whole_file(written.front(), tables::as_csv(curves_table(map)));
    if (map.grid) {
        written.push_back(place.string() + ".gwy");
        formats::write_quantity_maps(written.back(), study::quantities_on_grid(map),
                                     {map.grid->width, map.grid->height});
    }
    return written;
}

}  // namespace setae::output
