// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr/jkr_curve.hpp"

#include <fmt/format.h>

#include "program/messages.hpp"
#include "program/terminal.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/loops/shared_inputs.hpp"
#include "setae/output/force_map_output.hpp"
#include "setae/output/loop_answer.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::cli {
namespace {

/// "0 nm:500 nm", "1 nN:20 nN" or "0:1".
loops::CurveRange range_of(const std::string& text) {
    using Measure = loops::CurveRange::Measure;
    const auto colon = text.find(':');
    if (colon == std::string::npos)
        throw InvalidArgument(fmt::format(
            "--fit-range {}: expected FROM:TO, such as \"0 nm:500 nm\", \"1 nN:20 nN\" or shares of the largest indentation, 0:1",
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

void CurveArguments::add_to(Options& options) {
    options.flag(
        "--curve", curve,
        "take tables for force curves: force and displacement alone, without adhesion to see; files of AFM force curves always are");
    options.add("--tip", tip, "of a force curve").one_of({"paraboloid", "cone", "three_sided_pyramid"}).default_shown();
    options.add("--half-angle", half_angle, "of a cone, or inclination of a pyramid's faces, degrees");
    options.add("--curve-model", model, "of a force curve: hertz, dmt, jkr, maugis_dugdale, large_strain")
        .default_shown();
    options.add(
        "--fit-range", range,
        "of a force curve: \"0 nm:500 nm\", \"1 nN:20 nN\", or shares of the largest indentation; default -1:1");
    options
        .add("--curve-contact-point", contact_point,
             "of a force curve: fit, found (where the force leaves the baseline), or a length")
        .default_shown();
    options.flag("--keep-baseline-slope", keep_baseline_slope,
                 "of a force curve: take off the mean of free flight, not its line");
}

bool CurveArguments::concerns(const std::string& file) const {
    try {
        return curve || tables::force_curve_format(bytes::file_source(file)).has_value();
    } catch (const FileError&) {
        return false;  // whoever opens it says why
    }
}

loops::LensAndCounterBody CurveArguments::bodies(const BodyArguments& given, const Table& of_curve) const {
    const auto bodies = tip == "paraboloid" ? given.bodies(of_curve) : given.without_radius(of_curve);
    if (!bodies.standard_errors.empty())
        throw InvalidArgument(fmt::format("{} has a ±: fits of force curves take it for exact; give it without",
                                          loops::shared_input_name(bodies.standard_errors.begin()->first)));
    return bodies.values;
}

loops::ForceCurveFitOptions CurveArguments::options() const {
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

bool CurveArguments::concerns_map(const std::string& file, const LoopArguments& loops) const {
    if (loops.curve_number) return false;
    try {
        return tables::open_force_curves(file).numbers.size() > 1;
    } catch (const FormatError&) {
        return false;  // a table taken for a curve, or what whoever reads it says
    }
}

loops::ForceCurveAnalysis fit_curve(const std::string& file, const LoopArguments& loops, const BodyArguments& bodies,
                                    const CurveArguments& curve) {
    const auto opened = loops.open(file);
    return loops::analyse_force_curve(opened.table, curve.bodies(bodies, opened.table), curve.options());
}

study::ForceMap fit_map(const std::string& file, const LoopArguments& loops, const BodyArguments& bodies,
                        const CurveArguments& curve, parallel::Threads threads) {
    return study::fit_force_map(file, loops.source(file).force_curve, curve.bodies(bodies, {}), curve.options(),
                                threads);
}

void print_curve(const std::string& file, const loops::ForceCurveAnalysis& analysis) {
    tables::TidyTable table{"",
                            {"segment", "tip", "model", "E* [kPa]", "E [kPa]", "W [mJ/m²]", "contact point [µm]",
                             "indentation [µm]", "n", "rms residual"},
                            {}};
    std::string reasons;
    for (const auto& segment : analysis.segments) {
        if (!segment.fit) {
            reasons += fmt::format("  {}: {}\n", segment.name, segment.fit.reason);
            continue;
        }
        const auto& fit = *segment.fit;
        table.rows.push_back({segment.name, to_string(fit.shape), to_string(fit.model),
                              uncertain_number(fit.contact_modulus, 1e3), uncertain_number(fit.youngs_modulus, 1e3),
                              fit.work_of_adhesion ? uncertain_number(*fit.work_of_adhesion, 1e-3) : "–",
                              uncertain_number(fit.contact_point, 1e-6),
                              fmt::format("{:.4g} … {:.4g}", 1e6 * fit.indentation_from, 1e6 * fit.indentation_to),
                              fmt::format("{}", fit.n), format_value(fit.rms_residual, "N", 3)});
    }
    const auto width = output_size().width;
    print(wrapped(file + ": " + output::answer(analysis.summary), width, 2) + "\n" +
          tables::as_text_within(table, width) + reasons);
}

void print_map(const study::ForceMap& map) {
    const auto width = output_size().width;
    print(wrapped(map.file + ": " + output::answer(map), width, 2) + "\n" +
          tables::as_text_within(output::spread_table(map), width));
}

}  // namespace setae::cli
