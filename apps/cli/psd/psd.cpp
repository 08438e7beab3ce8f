// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <nlohmann/json.hpp>

#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "psd/surface_options.hpp"
#include "setae/answers/power_spectrum_fields.hpp"
#include "setae/file_figures/spectrum_figure.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/quantity_table.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::cli::psd_command {
namespace {

constexpr const char* explanation =
    "The command computes the power spectral density of one or several measurements of a surface.\n"
    "\n"
    "C1D     C1D(q) = |h(q)|^2/L [m3], h(q) = int h exp(-iqx) dx; two-sided, averaged over +-q [J17]\n"
    "        h_rms^2 = (1/pi) int_0^inf C1D dq\n"
    "C2D     C2D(q) = |h(q)|^2/A [m4] [J17]\n"
    "C_iso   mean of C2D over the circle |q|; h_rms^2 = (1/2 pi) int q C_iso dq [J17]\n"
    "        From C1D: C_iso = pi C1D/(q sqrt(1 - (q/q_s)^2)), q_s the end of the band; [D19] Eq. 11.\n"
    "        One map has C_iso from its transform.\n"
    "--abel  C_iso = -2 int_q^inf C1D'(p) dp/sqrt(p^2 - q^2), exact for isotropic surfaces; Bracewell\n"
    "        The ratio to pi C1D/q is given, too.\n"
    "--fit   C_iso = C_0 max(1, q/q_r)^(-2-2H) by the likelihood of the spectra, with the exact Abel integral for C1D\n"
    "        docs/concepts/self-affine-fit.md\n"
    "\n"
    "One measurement: the table contains its own modes.\n"
    "Several measurements: arithmetic mean in bins of 0.1 decade, each measurement in its reliable band [D19].\n"
    "[D19] Dalvi et al., PNAS 116 (2019) 25484; [J17] Jacobs, Junge, Pastewka, Surf. Topogr. 5 (2017) 013001.\n";

struct Arguments {
    Common common;
    SurfaceOptions surface;
    answers::PowerSpectrumRequest request;  ///< without the surface and its analysis
    std::string output;
    FigureOption figure;
};

ExitCode run(const Arguments& arguments) {
    require_table_or_figure(arguments.output);
    auto request = arguments.request;
    request.surface = arguments.surface.surface();
    request.analysis = arguments.surface.analysis();
    const auto spectrum = answers::power_spectrum(request, arguments.common.workers());
    const auto& [surface, table, fit] = spectrum;
    const auto code = report_failures(surface);
    if (code == ExitCode::nothing_done) return code;
    auto alerts = answers::alerts_of(surface);
    if (!arguments.common.json) alerts = show_reading_warnings(std::move(alerts));
    write_table_or_figure(
        arguments.output, table,
        [&spectrum, &arguments] {
            return file_figures::spectrum_figure(spectrum.surface, spectrum.table, arguments.figure.look());
        },
        arguments.common.json);
    if (arguments.common.json) {
        print_json(output::described(spectrum));
        return code;
    }
    if (arguments.output.empty()) print(tables::as_csv(table));
    if (fit) {
        const auto text = output::quantity_table("", answers::parameters_of(*fit), output_size().width);
        arguments.output.empty() ? print_for_reader(text) : print(text);
    }
    if (fit) alerts.insert(alerts.end(), fit->alerts.begin(), fit->alerts.end());
    show(alerts);
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    options.ask(arguments->request);
    options.ask(arguments->request.fit);
    options.output("-o,--output", arguments->output, "table OUT.csv or OUT.nc; figure OUT.svg, .pdf or .png");
    arguments->figure.add_to(options);
    options.example("setae psd afm.ibw --tip-radius \"10 nm\" -o psd.svg",
                    "spectrum as a figure, with the range limited by the tip");
    options.example("setae psd stylus.csv afm.ibw tem.csv -o psd.csv", "three measurements combined, as a table");
    options.example("setae psd afm.ibw stylus.csv --fit --json", "spectrum and self-affine fit as JSON");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::psd_command
