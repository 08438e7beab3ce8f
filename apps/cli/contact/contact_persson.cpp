// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "contact/pressures.hpp"
#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "psd/surface_options.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/file_figures/persson_figure.hpp"
#include "setae/output/json.hpp"
#include "setae/output/persson_answer.hpp"
#include "setae/persson/load_curve.hpp"

namespace setae::cli::contact_persson_command {
namespace {

constexpr const char* explanation =
    "V(q)     variance of the pressure in full contact, (1/2 pi) int k^2 C_iso q dq; k = E* q/2: V = E*^2 h'^2/4\n"
    "P(p, q)  dP/dV = 1/2 d2P/dp2, P(0) = 0: [exp(-(p-p0)^2/2V) - exp(-(p+p0)^2/2V)]/sqrt(2 pi V)   Persson (2001)\n"
    "A/A_0    erf(p0/sqrt(2V)); sqrt(8/pi) p0/(E* h') at low load                                   Persson (2001)\n"
    "U        int W dU_full, W = A [g + (1 - g) A^2], g = 0.45 or --energy-factor                   Yang, Persson (2008)\n"
    "gap      int_p0^inf (dU/dp) dp/p; stiffness p0/(dU/dp), as p = -dU/d(gap)                       Persson (2007)\n"
    "--w      P(-s_a) = 0 with s_a = sqrt(k(q) w_eff(q)); A(q) w_eff(q) = w A(q_1) - int_q A dU      Persson (2002)\n"
    "         parting: of several solutions that with most contact; w per projected area\n"
    "--layer  k(q) of a layer on a rigid base                                       Carbone, Mangialardi (2008)\n"
    "several pressures: a table against pressure; one: against q, waves up to q alone        docs/theory/persson.md\n";

struct Arguments {
    Common common;
    SurfaceOptions surface;
    std::string modulus, pressure, work, layer, output;
    double poisson_ratio = 0.5, energy_factor = persson::usual_energy_factor;
    bool frictionless = false;
    FigureOption figure;
};

half_space::Body body_of(const Arguments& arguments) {
    half_space::Body body{.contact_modulus = parse_quantity(arguments.modulus, positive(dimension::pressure))};
    if (!arguments.layer.empty())
        body.layer = {.thickness = parse_quantity(arguments.layer, positive(dimension::length)),
                      .poisson_ratio = arguments.poisson_ratio,
                      .base = arguments.frictionless ? half_space::Base::frictionless : half_space::Base::bonded};
    return body;
}

output::Json columns_json(const Table& table) {
    output::Json json, units;
    for (const auto& column : table.columns) {
        json[column.name] = output::numbers(column.values);
        units[column.name] = column.unit;
    }
    json["units"] = units;
    return json;
}

output::Json as_json(const Table& load, const Table* along_scales, const persson::Scales& scales,
                     const Arguments& arguments, double modulus) {
    const Index last = scales.wavevector.size() - 1;
    auto json = columns_json(load);
    if (along_scales) json["scales"] = columns_json(*along_scales);
    json["contact_modulus"] = modulus;
    json["energy_factor"] = arguments.energy_factor;
    json["rms_pressure"] = std::sqrt(scales.pressure_variance[last]);
    json["full_contact_energy"] = scales.stored_energy[last];
    json["band"] = {{"lower", scales.wavevector[0]}, {"upper", scales.wavevector[last]}, {"unit", "1/m"}};
    return json;
}

ExitCode run(const Arguments& arguments) {
    if (arguments.modulus.empty() || arguments.pressure.empty())
        throw InvalidArgument(
            "expected --contact-modulus and --pressure, such as --contact-modulus 1GPa --pressure 10MPa");
    require_table_or_figure(arguments.output);
    const auto body = body_of(arguments);
    const auto pressures = pressures_of(arguments.pressure);
    persson::LoadOptions options{.energy_factor = arguments.energy_factor};
    if (!arguments.work.empty())
        options.work_of_adhesion = parse_quantity(arguments.work, non_negative(dimension::surface_energy));
    auto analysis = arguments.surface.analysis();
    analysis.bootstrap_resamples = 0;
    const auto found = study::analyse_surface(arguments.surface.surface(), analysis,
                                              {.previews = false, .parameters = false}, arguments.common.workers());
    const auto& surface = found.surface;
    const auto code = report_failures(surface);
    if (code == ExitCode::nothing_done) return code;
    const auto scales = persson::scales_of(surface.used().curve, body);
    const auto load = persson::load_table(pressures, scales, options);
    std::optional<Table> along_scales;
    if (pressures.size() == 1) along_scales = persson::scale_table(pressures[0], scales, options);
    const Table& table = along_scales ? *along_scales : load;
    write_table_or_figure(
        arguments.output, table,
        [&] { return file_figures::persson_figure(table, arguments.surface.files.front(), arguments.figure.look()); },
        arguments.common.json);
    if (arguments.common.json)
        print_json(as_json(load, along_scales ? &*along_scales : nullptr, scales, arguments, body.contact_modulus));
    else print(output::persson_answer(load, scales, body.contact_modulus, output_size().width));
    if (!arguments.common.json) show(answers::alerts_of(surface));
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    options.add("--contact-modulus", arguments->modulus, "E* = E/(1 - nu^2) of the soft body")
        .quantity(positive(dimension::pressure));
    options
        .add("--pressure", arguments->pressure,
             "mean pressure: one, several as 1MPa,10MPa, or ten a decade as 1MPa:100MPa; below 0 with --w")
        .read_by([](const std::string& text) { (void)pressures_of(text); });
    options.add("--w,--work-of-adhesion", arguments->work, "work of adhesion, such as 50mJ/m2; default none")
        .quantity(non_negative(dimension::surface_energy));
    options.add("--layer", arguments->layer, "thickness of the soft body on a rigid base; default a half-space")
        .quantity(positive(dimension::length));
    options.add("--nu,--poisson-ratio", arguments->poisson_ratio, "of the layer").within(domain::poisson_ratio);
    options.flag("--frictionless", arguments->frictionless, "the layer slides on its base; default bonded");
    options.add("--energy-factor", arguments->energy_factor, "of the stored energy of partial contact, in (0, 1]")
        .within(domain::positive)
        .default_shown();
    options.add("-o,--output", arguments->output, "table OUT.csv or OUT.nc; figure OUT.svg, .pdf or .png");
    arguments->figure.add_to(options);
    options.example("setae contact persson spectrum.csv --contact-modulus 1GPa --pressure 10MPa",
                    "area, gap and stiffness of the contact under one pressure, from a table of a spectrum");
    options.example(
        "setae contact persson afm.ibw --contact-modulus 1MPa --pressure 1kPa:1MPa --w 50mJ/m2 -o contact.svg",
        "against load, with adhesion, as a figure");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::contact_persson_command
