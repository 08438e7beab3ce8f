// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/force_map.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::study {
namespace {

using Summary = loops::ForceCurveSummary;

/// An error of one curve is reported for that curve.
MappedCurve fitted_curve(const tables::ForceCurves& curves, const std::string& file, long number,
                         const loops::LensAndCounterBody& bodies, const loops::ForceCurveFitOptions& options) {
    MappedCurve result{.number = number};
    try {
        const auto curve = curves.read(number);
        result.x = curve.x;
        result.y = curve.y;
        if (curves.grid) result.pixel = curves.grid->pixel(curve.x, curve.y);
        result.summary = loops::summary_of_force_curve(curve.table, bodies, options);
    } catch (const Error& error) {
        std::string reason = error.what();
        if (reason.starts_with(file + ": ")) reason.erase(0, file.size() + 2);
        result.summary = loops::Outcome<Summary>::missing(std::move(reason));
    }
    return result;
}

/// The first complete curve; empty where there is none.
std::optional<Table> first_whole(const tables::ForceCurves& curves) {
    for (const long number : curves.numbers) try {
            auto curve = curves.read(number).table;
            const auto* force = curve.find("force");
            const auto* displacement = curve.find("displacement");
            const bool numbers =
                (!force || force->values.allFinite()) && (!displacement || displacement->values.allFinite());
            if (numbers) return curve;
        } catch (const FormatError&) {
            // reported for that curve
        }
    return std::nullopt;
}

/// An error of the call, not of a curve, is an error of the whole.
void require_fit(const tables::ForceCurves& curves, const std::string& file, const loops::LensAndCounterBody& bodies,
                 const loops::ForceCurveFitOptions& options) {
    const auto curve = first_whole(curves);
    if (!curve) return;
    require_constants(*curve, file);
    try {
        (void)loops::summary_of_force_curve(*curve, bodies, options);
    } catch (const UndefinedDataError&) {
        // reported for that curve
    }
}

}  // namespace

ForceMap fit_force_map(const std::string& file, const tables::ForceCurveOptions& constants,
                       const loops::LensAndCounterBody& bodies, const loops::ForceCurveFitOptions& options,
                       parallel::Threads threads) {
    const auto curves = tables::open_force_curves(file, constants);
    require_fit(curves, file, bodies, options);
    ForceMap map{.file = file, .format = curves.format, .grid = curves.grid};
    map.curves.resize(curves.numbers.size());
    parallel::for_each_index(map.curves.size(), threads, [&](std::size_t i) {
        map.curves[i] = fitted_curve(curves, file, curves.numbers[i], bodies, options);
    });
    if (std::none_of(map.curves.begin(), map.curves.end(),
                     [](const MappedCurve& curve) { return static_cast<bool>(curve.summary); }))
        throw UndefinedDataError(
            fmt::format("{}: none of {} force curves could be read and fitted; reason of the first: {}", file,
                        map.curves.size(), map.curves.front().summary.reason));
    return map;
}

std::vector<formats::QuantityMap> quantities_on_grid(const ForceMap& map) {
    if (!map.grid)
        throw UndefinedDataError(
            fmt::format("{}: the file states no grid of its curves, so that no maps can be made", map.file));
    std::vector<formats::QuantityMap> quantities;
    for (const auto& quantity : loops::curve_quantities()) {
        Array2D values = Array2D::Constant(map.grid->columns, map.grid->rows, undefined);
        for (const auto& curve : map.curves)
            if (curve.pixel && curve.summary && (*curve.summary).*quantity.value)
                values((*curve.pixel)[0], (*curve.pixel)[1]) = ((*curve.summary).*quantity.value)->value;
        quantities.push_back({quantity.name, quantity.unit, std::move(values)});
    }
    return quantities;
}

OpenedLoop open_force_curve(const std::string& file, long number, const tables::ForceCurveOptions& constants) {
    const auto curves = tables::open_force_curves(file, constants);
    if (!std::binary_search(curves.numbers.begin(), curves.numbers.end(), number))
        throw InvalidArgument(fmt::format("{}: no force curve {}; the file has {}, from {} to {}", file, number,
                                          curves.numbers.size(), curves.numbers.front(), curves.numbers.back()));
    auto curve = curves.read(number).table;
    require_constants(curve, file);
    curve.metadata["curve"] = fmt::format("{}", number);
    return {.table = std::move(curve)};
}

}  // namespace setae::study
