// SPDX-License-Identifier: GPL-3.0-or-later
// sdrp, acf and vbw: functions of a distance, of one measurement or combined from several.
#include <memory>

#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "psd/surface_options.hpp"
#include "setae/answers/scale_fields.hpp"
#include "setae/file_figures/scale_figure.hpp"
#include "setae/output/field_json.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::cli {
namespace {

constexpr const char* sdrp_explanation =
    "The command computes rms slope (order 1), rms curvature (order 2) or a higher derivative (order 3) at every scale.\n"
    "\n"
    "order 1  [h(x + s) - h(x)]/s, distance d = s; of maps with both directions |grad h|\n"
    "order 2  [h(x - s) - 2h(x) + h(x + s)]/s^2, distance d = 2s; of maps with both directions half the Laplacian\n"
    "order 3  distance d = 3s\n"
    "\n"
    "The distance d is the length of the stencil. Results are reliable from d = order/2 of the shortest wavelength.\n"
    "Source: 10.1016/j.apsadv.2021.100190.\n";
constexpr const char* acf_explanation =
    "The command computes the autocorrelation of height differences.\n"
    "\n"
    "A(d)     <[h(x + d) - h(x)]^2>/2 [m2] over all pairs of defined points\n"
    "--area   mean over all vectors of length d, the full circle\n"
    "--slope  sqrt(2A)/d; Wang, Mueser 2018\n"
    "\n"
    "Results are reliable from half the shortest wavelength.\n";
constexpr const char* vbw_explanation =
    "The command computes the rms height in cells of every size.\n"
    "\n"
    "rms       of all residuals of the best line (--area: plane) in each of m cells, m = 1, 2, 4, ... while n/m >= 4\n"
    "distance  size/m\n"
    "\n"
    "Results are reliable from the shortest wavelength. Source: 10.1088/2051-672X/aa51f8.\n";

using Asked = fields::Asked<answers::ScaleRequest>;

/// Options of all three commands.
struct ScaleArguments {
    Common common;
    SurfaceOptions surface;
    answers::ScaleRequest request;  ///< without the surface
    std::string output;
    FigureOption figure;

    void add_to(Options& options) {
        surface.add_measurements_to(options, "measurements of one surface: files or containers");
        options.ask(request);
        options.output("-o,--output,--csv", output, "table OUT.csv or OUT.nc; figure OUT.svg, .pdf or .png");
        figure.add_to(options);
    }
};

ExitCode run(const ScaleArguments& arguments, answers::ScaleFunction function) {
    require_table_or_figure(arguments.output);
    auto request = arguments.request;
    request.surface = arguments.surface.surface();
    request.largest_map = arguments.surface.analysis().largest_map;
    const auto found = answers::functions_of_scale(function, request, arguments.common.workers());
    for (const auto& failure : found.failures) print_message(failure);
    if (found.functions.empty()) return ExitCode::nothing_done;
    if (request.all) show_every_warning(true);
    auto alerts = found.alerts;
    if (!arguments.common.json) alerts = show_reading_warnings(std::move(alerts));
    write_table_or_figure(
        arguments.output, found.table,
        [&] {
            return file_figures::scale_figure(found.functions, found.combined ? &*found.combined : nullptr,
                                              arguments.figure.look());
        },
        arguments.common.json);
    if (arguments.common.json) print_json(output::described(&found, answers::description_of(found.function)));
    else if (arguments.output.empty()) print(tables::as_csv(found.table));
    if (!arguments.common.json) show(alerts);
    return found.failures.empty() ? ExitCode::done : ExitCode::some_failed;
}

ExitCode run_sdrp(const ScaleArguments& arguments) { return run(arguments, answers::ScaleFunction::differences); }
ExitCode run_acf(const ScaleArguments& arguments) { return run(arguments, answers::ScaleFunction::autocorrelation); }
ExitCode run_vbw(const ScaleArguments& arguments) { return run(arguments, answers::ScaleFunction::variable_bandwidth); }

}  // namespace

Action sdrp_command(Options& options) {
    auto arguments = std::make_shared<ScaleArguments>();
    arguments->add_to(options);
    options.ask(Asked::differences, &arguments->request);
    options.example("setae sdrp afm.ibw --tip-radius \"10 nm\" -o slope.svg", "rms slope at every scale, as a figure");
    options.example("setae sdrp stylus.csv afm.ibw --order 2 --distance 100nm,1um",
                    "rms curvature at two scales, from two measurements");
    return action(options, arguments, sdrp_explanation, run_sdrp);
}

Action acf_command(Options& options) {
    auto arguments = std::make_shared<ScaleArguments>();
    arguments->add_to(options);
    options.ask(Asked::of_area, &arguments->request);
    options.ask(Asked::autocorrelation, &arguments->request);
    options.example("setae acf afm.ibw -o acf.csv", "autocorrelation along the scan lines, as a table");
    options.example("setae acf map.x3p --area -o acf.svg", "autocorrelation over all directions, as a figure");
    return action(options, arguments, acf_explanation, run_acf);
}

Action vbw_command(Options& options) {
    auto arguments = std::make_shared<ScaleArguments>();
    arguments->add_to(options);
    options.ask(Asked::of_area, &arguments->request);
    options.example("setae vbw stylus.csv -o vbw.svg", "rms height in cells of every length, as a figure");
    return action(options, arguments, vbw_explanation, run_vbw);
}

}  // namespace setae::cli
