// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/force_curves.hpp"

#include <utility>

#include <fmt/format.h>

#include "setae/bytes/source.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/loops/shared_inputs.hpp"

namespace setae::answers {
namespace {

/// "0 nm:500 nm", "1 nN:20 nN" or "0:1".
loops::CurveRange range_of(const std::string& text) {
    using Measure = loops::CurveRange::Measure;
    const auto colon = text.find(':');
    if (colon == std::string::npos)
        throw InvalidArgument(fmt::format(
            "`fit_range = {}`: expected FROM:TO, such as \"0 nm:500 nm\", \"1 nN:20 nN\" or shares of the largest indentation, 0:1",
            text));
    const auto from = text.substr(0, colon), to = text.substr(colon + 1);
    const auto as = [&](Measure measure, const Dimension& dimension) {
        return loops::CurveRange{
            .measure = measure, .from = parse_quantity(from, dimension), .to = parse_quantity(to, dimension)};
    };
    for (const auto& [measure, dimension] :
         {std::pair{Measure::indentation, dimension::length}, std::pair{Measure::force, dimension::force}}) {
        try {
            return as(measure, dimension);
        } catch (const InvalidArgument&) {
            // another measure
        }
    }
    return as(Measure::share_of_indentation, dimension::none);
}

}  // namespace

bool CurveRequest::concerns(const std::string& file) const {
    try {
        return curve || tables::force_curve_format(bytes::file_source(file)).has_value();
    } catch (const FileError&) {
        return false;  // opening the file later reports the reason
    }
}

loops::LensAndCounterBody CurveRequest::bodies(const LoopBodies& given, const Table& of_curve) const {
    const auto bodies = tip == "paraboloid" ? given.bodies(of_curve) : given.without_radius(of_curve);
    if (!bodies.standard_errors.empty())
        throw InvalidArgument(fmt::format("{} has a ±: fits of force curves take it for exact; give it without",
                                          loops::shared_input_name(bodies.standard_errors.begin()->first)));
    return bodies.values;
}

loops::ForceCurveFitOptions CurveRequest::options() const {
    loops::ForceCurveFitOptions options{.shape = loops::tip_shape_named(tip),
                                        .half_angle = half_angle * pi / 180.0,
                                        .model = loops::model_named(model)};
    if (!range.empty()) options.range = range_of(range);
    options.fit_contact_point = contact_point == "fit";
    if (contact_point != "fit" && contact_point != "found")
        options.contact_point = parse_quantity(contact_point, dimension::length);
    options.subtract_baseline_slope = !keep_baseline_slope;
    return options;
}

bool CurveRequest::concerns_map(const std::string& file, const LoopFiles& loops) const {
    if (loops.curve_number) return false;
    try {
        return tables::open_force_curves(file).numbers.size() > 1;
    } catch (const FormatError&) {
        return false;  // a table that is treated as a curve, or an error that is reported on reading
    }
}

loops::ForceCurveAnalysis fit_curve(const std::string& file, const LoopFiles& loops, const LoopBodies& bodies,
                                    const CurveRequest& curve) {
    const auto opened = loops.open(file);
    return loops::analyse_force_curve(opened.table, curve.bodies(bodies, opened.table), curve.options());
}

study::ForceMap fit_map(const std::string& file, const LoopFiles& loops, const LoopBodies& bodies,
                        const CurveRequest& curve, parallel::Threads threads) {
    return study::fit_force_map(file, loops.source(file).force_curve, curve.bodies(bodies, {}), curve.options(),
                                threads);
}

}  // namespace setae::answers
