// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "psd/surface_options.hpp"
#include "setae/answers/persson_fields.hpp"
#include "setae/file_figures/persson_figure.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/persson_answer.hpp"

namespace setae::cli::contact_persson_command {
namespace {

constexpr const char* explanation =
    "The command computes area, gap and stiffness of an elastic contact from a spectrum (Persson's theory).\n"
    "\n"
    "V(q)     variance of the pressure in full contact: (1/2 pi) int k^2 C_iso q dq; k = E* q/2: V = E*^2 h'^2/4\n"
    "P(p, q)  distribution of the pressure: dP/dV = 1/2 d2P/dp2, P(0) = 0; Persson (2001)\n"
    "         [exp(-(p-p0)^2/2V) - exp(-(p+p0)^2/2V)]/sqrt(2 pi V)\n"
    "A/A_0    erf(p0/sqrt(2V)); at low load sqrt(8/pi) p0/(E* h'); Persson (2001)\n"
    "U        int W dU_full, W = A [g + (1 - g) A^2], g = 0.45 or --energy-factor; Yang, Persson (2008)\n"
    "gap      int_p0^inf (dU/dp) dp/p; stiffness p0/(dU/dp), because p = -dU/d(gap); Persson (2007)\n"
    "--w      P(-s_a) = 0 with s_a = sqrt(k(q) w_eff(q)); A(q) w_eff(q) = w A(q_1) - int_q A dU; Persson (2002)\n"
    "         The work w is per unit projected area. Several solutions: the one with the largest contact (retraction).\n"
    "--layer  k(q) of a layer on a rigid base; Carbone, Mangialardi (2008)\n"
    "\n"
    "Several pressures give a table against pressure. One pressure gives a table against q, with only the waves up to q.\n"
    "The method is described in docs/concepts/persson.md.\n";

struct Arguments {
    Common common;
    SurfaceOptions surface;
    answers::PerssonRequest request;
    std::string output;
    FigureOption figure;
};

ExitCode run(const Arguments& arguments) {
    arguments.request.require_complete();
    require_table_or_figure(arguments.output);
    const auto surface = answers::surface_for_theory(arguments.surface.surface(), arguments.surface.analysis(),
                                                     arguments.common.workers());
    const auto code = report_failures(surface);
    if (code == ExitCode::nothing_done) return code;
    const auto contact = answers::persson_contact(surface, arguments.request);
    const Table& table = contact.table();
    write_table_or_figure(
        arguments.output, table,
        [&] { return file_figures::persson_figure(table, arguments.surface.files.front(), arguments.figure.look()); },
        arguments.common.json);
    if (arguments.common.json) {
        print_json(output::described(contact));
        return code;
    }
    print(output::persson_answer(contact.load, contact.scales, contact.contact_modulus, output_size().width));
    show(contact.alerts);
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    auto& request = arguments->request;
    options.ask<answers::BodyRequest>(request);
    options.ask(request);
    options.ask(fields::Asked<answers::PerssonRequest>::adhesion, &request);
    options.output("-o,--output", arguments->output, "table OUT.csv or OUT.nc; figure OUT.svg, .pdf or .png");
    arguments->figure.add_to(options);
    options.example("setae contact persson spectrum.csv --contact-modulus 1GPa --pressure 10MPa",
                    "area, gap and stiffness under one pressure, from the table of a spectrum");
    options.example(
        "setae contact persson afm.ibw --contact-modulus 1MPa --pressure 1kPa:1MPa --w 50mJ/m2 -o contact.svg",
        "adhesive contact against pressure, as a figure");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::contact_persson_command
